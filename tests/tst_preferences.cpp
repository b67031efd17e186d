// Preferences between runs, the dialog that edits them, and the shortcut editor.
#include "support/studioparts.h"
#include "views/actions/actiontree.h"
#include "views/actions/keyfield.h"
#include "views/actions/preferencesdialog.h"
#include "views/actions/shortcutspage.h"
#include "views/ui/colorbutton.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

namespace tst_preferences {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

//! Every value differs from its default.
PreferenceValues otherValues()
{
    PreferenceValues v;
    v.navigation = NavigationPreset::Maya;
    v.theme = Theme::Light;
    v.language = Language::German;
    v.interfacePercent = 125;
    v.colorBlindHeatMap = true;
    v.seamColor = QColor(1, 2, 3);
    v.selectionColor = QColor(4, 5, 6);
    v.forcedCutColor = QColor(7, 8, 9);
    v.joinedColor = QColor(10, 11, 12);
    v.textureSize = 512;
    v.margin = 3;
    v.maxDistortion = 4.25;
    v.autosaveSeconds = 0;
    v.undoMemoryMb = 64;
    v.solveOnOpen = true;
    v.showTextures = false;
    v.letProgramsIn = false;
    return v;
}

struct Folder : QTemporaryDir
{
    QString ini() const { return filePath(u"a folder/Настройки.ini"_s); }
};

QStringList keysOf(const QAction *action)
{
    QStringList result;
    for (const QKeySequence &keys : action->shortcuts())
        result << keys.toString(QKeySequence::PortableText);
    return result;
}

//! A child of a dialog by the value that it shows.
template <typename Box, typename Value>
Box *boxWithValue(const QWidget &parent, Value value)
{
    for (Box *box : parent.findChildren<Box *>()) {
        if (box->value() == value)
            return box;
    }
    return nullptr;
}

} // namespace

class TestPreferences : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void valuesSurvive()
    {
        const Folder folder;
        {
            Preferences preferences(folder.ini());
            QCOMPARE(preferences.values(), PreferenceValues());
            QSignalSpy changed(&preferences, &Preferences::changed);
            preferences.setValues(PreferenceValues());
            QCOMPARE(changed.count(), 0);
            preferences.setValues(otherValues());
            QCOMPARE(changed.count(), 1);
        }
        QCOMPARE(Preferences(folder.ini()).values(), otherValues());
        QCOMPARE(Preferences::language(folder.ini()), Language::German);
    }

    void wrongValuesFallBack_data()
    {
        QTest::addColumn<QString>("line");
        for (const char *line :
             {"navigation=upside down", "theme=42", "language=Klingon", "interfacePercent=5",
              "seamColor=no colour", "textureSize=0", "textureSize=-5", "textureSize=many",
              "textureSize=999999999999", "margin=-1", "margin=100000", "maxDistortion=4",
              "maxDistortion=nan", "maxDistortion=inf", "autosaveSeconds=-2", "undoMemoryMb=0",
              "undoMemoryMb=99999999"})
            QTest::newRow(line) << QString::fromLatin1(line);
    }

    void wrongValuesFallBack()
    {
        QFETCH(QString, line);
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"p.ini"_s);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("[values]\n" + line.toUtf8() + "\n");
        file.close();
        QCOMPARE(Preferences(path).values(), PreferenceValues());
    }

    void damagedFileGivesDefaults()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(u"p.ini"_s);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray("\0\xff[[[\n=\n[values\ntheme", 21));
        file.close();
        const Preferences preferences(path);
        QCOMPARE(preferences.values(), PreferenceValues());
        QVERIFY(preferences.recentFiles().isEmpty());
        QVERIFY(preferences.shortcuts().isEmpty());
    }

    void recentFilesAreOrdered()
    {
        const Folder folder;
        Preferences preferences(folder.ini());
        QSignalSpy changed(&preferences, &Preferences::recentFilesChanged);
        preferences.addRecentFile(u"/a/one.obj"_s);
        preferences.addRecentFile(u"/a/Два, три.obj"_s);
        preferences.addRecentFile(u"/a/../a/one.obj"_s);
        QCOMPARE(preferences.recentFiles(), QStringList({u"/a/one.obj"_s, u"/a/Два, три.obj"_s}));
        QCOMPARE(changed.count(), 3);
        preferences.addRecentFile(u"/a/one.obj"_s);
        QCOMPARE(changed.count(), 3);
        for (int i = 0; i < 30; ++i)
            preferences.addRecentFile(u"/b/%1.obj"_s.arg(i));
        QCOMPARE(preferences.recentFiles().size(), Preferences::maxRecentFiles);
        QCOMPARE(preferences.recentFiles().first(), u"/b/29.obj"_s);
        QCOMPARE(Preferences(folder.ini()).recentFiles(), preferences.recentFiles());
        preferences.clearRecentFiles();
        QVERIFY(Preferences(folder.ini()).recentFiles().isEmpty());
    }

    void shortcutsSurvive()
    {
        const Folder folder;
        const QMap<QString, QKeySequence> shortcuts{{u"uv.pack"_s, QKeySequence(u"Ctrl+Alt+K"_s)},
                                                    {u"uv.cut"_s, QKeySequence()},
                                                    {u"view.frameAll"_s, QKeySequence(u"Num+."_s)}};
        {
            Preferences preferences(folder.ini());
            QSignalSpy changed(&preferences, &Preferences::shortcutsChanged);
            preferences.setShortcuts(shortcuts);
            preferences.setShortcuts(shortcuts);
            QCOMPARE(changed.count(), 1);
        }
        Preferences again(folder.ini());
        QCOMPARE(again.shortcuts(), shortcuts);
        const ActionRegistry registry(again);
        QCOMPARE(keysOf(registry.action("uv.pack")), QStringList(u"Ctrl+Alt+K"_s));
        QCOMPARE(keysOf(registry.action("uv.cut")), QStringList());
        QVERIFY(registry.action("uv.pack")->toolTip().contains(u"[Ctrl+Alt+K]\n"_s));
        again.setShortcuts({});
        QCOMPARE(keysOf(registry.action("uv.pack")), QStringList(u"P"_s));
    }

    void layoutAndFolderSurvive()
    {
        const Folder folder;
        Preferences preferences(folder.ini());
        QCOMPARE(preferences.lastFolder(), QDir::homePath());
        preferences.setLastFolder(folder.path());
        preferences.setWindowLayout(QByteArray("\0geometry", 9), QByteArray("\xff\0state", 7));
        const Preferences again(folder.ini());
        QCOMPARE(again.lastFolder(), folder.path());
        QCOMPARE(again.windowGeometry(), QByteArray("\0geometry", 9));
        QCOMPARE(again.windowState(), QByteArray("\xff\0state", 7));
        preferences.setLastFolder(folder.filePath(u"gone"_s));
        QCOMPARE(preferences.lastFolder(), QDir::homePath());
    }

    void dialogChangesAtOnceAndCancels()
    {
        test::StudioParts studio;
        studio.preferences.setValues(otherValues());
        PreferencesDialog dialog(studio.preferences, studio.registry);
        QCOMPARE(studio.preferences.values(), otherValues());
        auto *undoMemory = boxWithValue<QSpinBox>(dialog, 64);
        QVERIFY(undoMemory);
        undoMemory->setValue(128);
        PreferenceValues expected = otherValues();
        expected.undoMemoryMb = 128;
        QCOMPARE(studio.preferences.values(), expected);
        dialog.findChildren<ColorButton *>().first()->setColor(Qt::green);
        expected.seamColor = Qt::green;
        QCOMPARE(studio.preferences.values(), expected);
        dialog.shortcutsPage().setCurrent(studio.action("uv.pack"));
        dialog.shortcutsPage().assign(QKeySequence(u"F9"_s));
        QCOMPARE(keysOf(studio.action("uv.pack")), QStringList(u"F9"_s));
        dialog.reject();
        QCOMPARE(studio.preferences.values(), otherValues());
        QCOMPARE(keysOf(studio.action("uv.pack")), QStringList(u"P"_s));
    }

    void dialogRestoresThePageShown()
    {
        test::StudioParts studio;
        studio.preferences.setValues(otherValues());
        PreferencesDialog dialog(studio.preferences, studio.registry);
        auto *restore = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::RestoreDefaults);
        dialog.showPage(PreferencesDialog::Page::Appearance);
        restore->click();
        PreferenceValues expected = otherValues();
        expected.theme = Theme::Dark;
        expected.language = Language::System;
        expected.interfacePercent = 100;
        expected.colorBlindHeatMap = false;
        expected.seamColor = PreferenceValues().seamColor;
        expected.selectionColor = PreferenceValues().selectionColor;
        expected.forcedCutColor = PreferenceValues().forcedCutColor;
        expected.joinedColor = PreferenceValues().joinedColor;
        QCOMPARE(studio.preferences.values(), expected);
        dialog.showPage(PreferencesDialog::Page::General);
        restore->click();
        QCOMPARE(studio.preferences.values(), PreferenceValues());
        dialog.accept();
        QCOMPARE(studio.preferences.values(), PreferenceValues());
    }

    void dialogStoresTheLanguage()
    {
        test::StudioParts studio;
        PreferencesDialog dialog(studio.preferences, studio.registry);
        for (QComboBox *box : dialog.findChildren<QComboBox *>()) {
            if (const int german = box->findText(u"Deutsch"_s); german >= 0) {
                QCOMPARE(box->currentText(), u"As the system"_s);
                box->setCurrentIndex(german);
            }
        }
        QCOMPARE(studio.preferences.values().language, Language::German);
        QCOMPARE(Preferences::language(studio.path("autocuts.ini")), Language::German);
        dialog.reject();
        QCOMPARE(Preferences::language(studio.path("autocuts.ini")), Language::System);
    }

    void marginFitsTheTexture()
    {
        test::StudioParts studio;
        PreferencesDialog dialog(studio.preferences, studio.registry);
        boxWithValue<QSpinBox>(dialog, 2048)->setValue(16);
        boxWithValue<QSpinBox>(dialog, 8)->setValue(1000);
        QCOMPARE(studio.preferences.values().margin, 16);
    }

    void shortcutConflictIsShownAndTakenOver()
    {
        test::StudioParts studio;
        ShortcutsPage page(studio.preferences, studio.registry);
        page.setCurrent(studio.action("uv.pack"));
        page.assign(QKeySequence(u"U"_s));
        QVERIFY(page.conflictText().contains(u"Unwrap"_s));
        QCOMPARE(keysOf(studio.action("uv.pack")), QStringList(u"P"_s));
        page.takeOver();
        QVERIFY(page.conflictText().isEmpty());
        QCOMPARE(keysOf(studio.action("uv.pack")), QStringList(u"U"_s));
        QCOMPARE(keysOf(studio.action("uv.unwrap")), QStringList());
        // Its default belongs to another action now.
        page.setCurrent(studio.action("uv.unwrap"));
        page.resetCurrent();
        QVERIFY(page.conflictText().contains(u"Pack"_s));
        page.takeOver();
        QCOMPARE(keysOf(studio.action("uv.unwrap")), QStringList(u"U"_s));
        QCOMPARE(keysOf(studio.action("uv.pack")), QStringList());
        page.resetAll();
        QCOMPARE(keysOf(studio.action("uv.pack")), QStringList(u"P"_s));
        QVERIFY(studio.preferences.shortcuts().isEmpty());
    }

    void takingOverLeavesTheOtherKey()
    {
        test::StudioParts studio;
        ShortcutsPage page(studio.preferences, studio.registry);
        page.setCurrent(studio.action("uv.pack"));
        page.assign(QKeySequence(u"Ctrl+Y"_s));
        page.takeOver();
        QCOMPARE(keysOf(studio.action("edit.redo")), QStringList(u"Ctrl+Shift+Z"_s));
    }

    void defaultKeyIsNotStored()
    {
        test::StudioParts studio;
        ShortcutsPage page(studio.preferences, studio.registry);
        page.setCurrent(studio.action("uv.pack"));
        page.assign({});
        QCOMPARE(keysOf(studio.action("uv.pack")), QStringList());
        QCOMPARE(studio.preferences.shortcuts().size(), 1);
        page.assign(QKeySequence(u"P"_s));
        QVERIFY(studio.preferences.shortcuts().isEmpty());
    }

    void keysAreRecorded_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char *name, int key, Qt::KeyboardModifiers modifiers,
                            const char *expected) {
            QTest::newRow(name) << key << modifiers << QString::fromLatin1(expected);
        };
        row("letter", Qt::Key_K, Qt::NoModifier, "K");
        row("modifiers", Qt::Key_K, Qt::ControlModifier | Qt::AltModifier, "Ctrl+Alt+K");
        row("space", Qt::Key_Space, Qt::NoModifier, "Space");
        row("delete", Qt::Key_Delete, Qt::NoModifier, "Del");
        row("tab", Qt::Key_Tab, Qt::ControlModifier, "Ctrl+Tab");
        row("keypad", Qt::Key_Period, Qt::KeypadModifier, "Num+.");
        row("return", Qt::Key_Return, Qt::NoModifier, "Return");
        row("shifted symbol", Qt::Key_Question, Qt::ShiftModifier, "?");
        row("shifted letter", Qt::Key_K, Qt::ShiftModifier, "Shift+K");
    }

    void keysAreRecorded()
    {
        QFETCH(int, key);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        QFETCH(QString, expected);
        KeyField field;
        QSignalSpy recorded(&field, &KeyField::recorded);
        field.setKeys(u"P"_s);
        QTest::keyClick(&field, Qt::Key(key), modifiers);
        QCOMPARE(recorded.count(), 0);
        QTest::mouseClick(&field, Qt::LeftButton);
        field.startRecording();
        QTest::keyClick(&field, Qt::Key_Control);
        QVERIFY(field.isRecording());
        QTest::keyClick(&field, Qt::Key(key), modifiers);
        QVERIFY(!field.isRecording());
        QCOMPARE(recorded.count(), 1);
        QCOMPARE(recorded.first().first().value<QKeySequence>().toString(QKeySequence::PortableText),
                 expected);
    }

    void escapeEndsRecording()
    {
        KeyField field;
        QSignalSpy recorded(&field, &KeyField::recorded);
        field.setKeys(u"P"_s);
        field.startRecording();
        QTest::keyClick(&field, Qt::Key_Escape);
        QVERIFY(!field.isRecording());
        QCOMPARE(field.text(), u"P"_s);
        QCOMPARE(recorded.count(), 0);
    }

    void searchHidesRows()
    {
        test::StudioParts studio;
        QTreeWidget tree;
        tree.setColumnCount(2);
        fillActionTree(tree, studio.registry);
        const auto shown = [&tree] {
            QStringList names;
            for (QTreeWidgetItemIterator it(&tree, QTreeWidgetItemIterator::NotHidden); *it; ++it) {
                if (actionOfItem(**it))
                    names << actionOfItem(**it)->objectName();
            }
            return names;
        };
        QCOMPARE(shown().size(), int(studio.registry.actions().size()));
        filterActionTree(tree, u"ctrl+shift+z"_s);
        QCOMPARE(shown(), QStringList(u"edit.redo"_s));
        filterActionTree(tree, u"pack sel"_s);
        QCOMPARE(shown(), QStringList(u"uv.packSelection"_s));
        filterActionTree(tree, u"no such thing"_s);
        QCOMPARE(shown(), QStringList());
        filterActionTree(tree, {});
        QCOMPARE(shown().size(), int(studio.registry.actions().size()));
    }
};

QTEST_MAIN(TestPreferences)

} // namespace tst_preferences

#include "tst_preferences.moc"
