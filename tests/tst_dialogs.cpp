// Dialogs of files, recovery and help; theme.
#include "model/io/meshes/exportlosses.h"
#include "model/io/projects/projectfile.h"
#include "model/samples/samples.h"
#include "support/editsupport.h"
#include "support/studioparts.h"
#include "views/actions/shortcutlistdialog.h"
#include "views/dialogs/aboutdialog.h"
#include "views/dialogs/densitydialog.h"
#include "views/dialogs/exportlayoutdialog.h"
#include "views/dialogs/exportmeshdialog.h"
#include "views/dialogs/numberdialog.h"
#include "views/dialogs/pathfield.h"
#include "views/dialogs/recoverydialog.h"
#include "views/dialogs/scatterdialog.h"
#include "views/ui/icons.h"
#include "views/ui/theme.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QStyle>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

namespace tst_dialogs {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

QPushButton *buttonOf(const QWidget &dialog, const QString &text)
{
    for (QPushButton *button : dialog.findChildren<QPushButton *>()) {
        if (button->text().remove(u'&') == text)
            return button;
    }
    return nullptr;
}

void touch(const QString &path)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("old");
}

//! A session as a crash leaves it behind.
RecoverableSession crashed(const QString &file, const QString &sessionPath)
{
    const DocumentState state = DocumentState::initial(makeSample(u"bumpycube"_s).value());
    ProjectExtras extras;
    extras.sessionPath = sessionPath;
    [[maybe_unused]] const bool saved = saveProject(state, extras, file).ok();
    return {file, sessionPath, u"/models/чайник.obj"_s, QDateTime(QDate(2026, 1, 2), QTime(3, 4))};
}

double luminance(const QColor &color)
{
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

//! Contrast of the W3C's accessibility guidelines, 1 to 21.
double contrast(const QColor &a, const QColor &b)
{
    const double first = luminance(a) + 0.05, second = luminance(b) + 0.05;
    return std::max(first, second) / std::min(first, second);
}

} // namespace

class TestDialogs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void meshFormatsSayTheirLosses_data()
    {
        QTest::addColumn<QString>("format");
        for (const char *format : {"obj", "glb", "gltf", "dae", "fbx", "ply"})
            QTest::newRow(format) << QString::fromLatin1(format);
    }

    void meshFormatsSayTheirLosses()
    {
        QFETCH(QString, format);
        test::Answers answers;
        const QTemporaryDir folder;
        const Scene scene = makeSample(u"machine"_s).value();
        ExportMeshDialog dialog(scene, folder.filePath(u"a.b"_s), answers);
        dialog.setFormat(format);
        QCOMPARE(dialog.path(), folder.filePath(u"a.b."_s + format));
        QCOMPARE(dialog.losses(), exportLosses(scene, format));
        QString shown;
        for (const QLabel *label : dialog.findChildren<QLabel *>())
            shown += label->text();
        for (const QString &loss : dialog.losses())
            QVERIFY2(shown.contains(loss.mid(1).toHtmlEscaped()), qPrintable(loss));
    }

    void typedSuffixChoosesTheFormat()
    {
        test::Answers answers;
        const QTemporaryDir folder;
        ExportMeshDialog dialog(makeSample(u"torus"_s).value(), folder.filePath(u"torus"_s), answers);
        auto *edit = dialog.findChild<QLineEdit *>();
        QCOMPARE(dialog.format(), u"obj"_s);
        edit->setText(folder.filePath(u"torus.GLB"_s));
        QCOMPARE(dialog.format(), u"glb"_s);
        QCOMPARE(dialog.path(), folder.filePath(u"torus.GLB"_s));
        QPushButton *button = buttonOf(dialog, u"Export"_s);
        QVERIFY(button->isEnabled());
        for (const QString &wrong : {folder.filePath(u"torus.xyz"_s), folder.filePath(u"no/torus.obj"_s),
                                     folder.path() + u'/', QString()}) {
            edit->setText(wrong);
            QVERIFY2(!button->isEnabled(), qPrintable(wrong));
            dialog.accept();
            QCOMPARE(dialog.result(), int(QDialog::Rejected));
        }
    }

    void sourceIsNotReplacedByDefault()
    {
        test::Answers answers;
        const QTemporaryDir folder;
        Scene scene = makeSample(u"torus"_s).value();
        scene.path = folder.filePath(u"torus.obj"_s);
        scene.format = u"obj"_s;
        ExportMeshDialog dialog(scene, folder.filePath(u"torus"_s), answers);
        QCOMPARE(dialog.path(), folder.filePath(u"torus_uv.obj"_s));
    }

    void replacingIsConfirmed()
    {
        test::Answers answers;
        const QTemporaryDir folder;
        touch(folder.filePath(u"torus.obj"_s));
        ExportMeshDialog dialog(makeSample(u"torus"_s).value(), folder.filePath(u"torus"_s), answers);
        answers.confirms = false;
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Rejected));
        answers.confirms = true;
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        QCOMPARE(answers.confirmations.size(), 2);
    }

    void browsedFileIsConfirmedOnce()
    {
        test::Answers answers;
        const QTemporaryDir folder;
        touch(folder.filePath(u"old.ply"_s));
        ExportMeshDialog dialog(makeSample(u"torus"_s).value(), folder.filePath(u"torus"_s), answers);
        answers.filesToSave = {folder.filePath(u"old.ply"_s)};
        buttonOf(dialog, u"Browse..."_s)->click();
        QCOMPARE(dialog.format(), u"ply"_s);
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        QVERIFY(answers.confirmations.isEmpty());
    }

    void layoutOptions()
    {
        test::Answers answers;
        const QTemporaryDir folder;
        ExportLayoutDialog dialog(1024, folder.filePath(u"map.png"_s), {1, 5}, answers);
        QCOMPARE(dialog.options().size, 1024);
        QCOMPARE(dialog.options().overlapping, std::vector<int>({1, 5}));
        const auto boxes = dialog.findChildren<QCheckBox *>();
        for (QCheckBox *box : boxes)
            box->setChecked(false);
        dialog.findChild<QSpinBox *>()->setValue(1'000'000);
        const auto combos = dialog.findChildren<QComboBox *>();
        combos[0]->setCurrentIndex(1);
        combos[1]->setCurrentIndex(0);
        const LayoutOptions options = dialog.options();
        QCOMPARE(options.size, 16384);
        QVERIFY(!options.edges);
        QCOMPARE(options.background, LayoutBackground::Transparent);
        QVERIFY(options.overlapping.empty());
        QCOMPARE(dialog.path(), folder.filePath(u"map.svg"_s));
        QVERIFY(!options.fill && !options.seams && !options.islandColor && !options.seamColor);
        QVERIFY(!ExportLayoutDialog(4, folder.filePath(u"a.png"_s), {}, answers)
                     .findChild<QCheckBox *>(u"overlaps"_s)
                     ->isEnabled());
        dialog.findChild<QSpinBox *>(u"bleed"_s)->setValue(12);
        dialog.findChild<QCheckBox *>(u"seamColor"_s)->setChecked(true);
        QCOMPARE(dialog.options().bleed, 12);
        QCOMPARE(dialog.options().seamColor, std::optional<QColor>(Qt::white));
    }

    void enterAccepts()
    {
        test::Answers answers;
        const QTemporaryDir folder;
        ExportLayoutDialog layout(64, folder.filePath(u"map.png"_s), {}, answers);
        DensityDialog density(512, {});
        for (QDialog *dialog : std::initializer_list<QDialog *>{&layout, &density}) {
            dialog->show();
            QTest::keyClick(dialog, Qt::Key_Return);
            QCOMPARE(dialog->result(), int(QDialog::Accepted));
        }
    }

    void exportsAreWritten()
    {
        test::StudioParts studio;
        studio.workspace.open(test::layoutDocument(test::grid(8)), {});
        studio.answers.onDialog = [&](QDialog &dialog) {
            if (auto *mesh = qobject_cast<ExportMeshDialog *>(&dialog)) {
                mesh->findChild<PathField *>()->setPath(studio.path("Модель один.ply"));
                mesh->accept();
            } else if (auto *layout = qobject_cast<ExportLayoutDialog *>(&dialog)) {
                layout->findChild<PathField *>()->setPath(studio.path("map.svg"));
                layout->accept();
            }
            return dialog.result();
        };
        studio.trigger("file.exportMesh");
        QVERIFY(studio.rests());
        QVERIFY(QFileInfo(studio.path("Модель один.ply")).size() > 1000);
        QVERIFY(studio.action("file.exportLayout")->isEnabled());
        studio.trigger("file.exportLayout");
        QVERIFY(studio.rests());
        QCOMPARE(studio.answers.errors, QStringList());
        // The islands lie in two tiles.
        for (const char *name : {"map.1001.svg", "map.1002.svg"})
            QVERIFY(QFileInfo(studio.path(name)).size() > 100);
        QCOMPARE(studio.preferences.lastFolder(), studio.folder.path());
        QVERIFY(studio.answers.errors.isEmpty());
    }

    void recoveryOffersAndDiscards()
    {
        test::Answers answers;
        const QTemporaryDir folder;
        std::vector<RecoverableSession> sessions{
            crashed(folder.filePath(u"1.acproj"_s), u"/home/a/Машина.acproj"_s),
            crashed(folder.filePath(u"2.acproj"_s), QString())};
        sessions.push_back({folder.filePath(u"damaged.acproj"_s), u"/x/damaged.acproj"_s, {}, QDateTime()});
        touch(sessions.back().file);
        RecoveryDialog dialog(sessions, answers);
        auto *list = dialog.findChild<QTreeWidget *>();
        QCOMPARE(list->topLevelItemCount(), 3);
        QCOMPARE(list->topLevelItem(0)->text(0), u"Машина.acproj"_s);
        QVERIFY(!list->topLevelItem(0)->text(1).isEmpty());
        QCOMPARE(list->topLevelItem(1)->text(0), u"чайник.obj (never saved)"_s);
        QCOMPARE(list->topLevelItem(1)->text(2), QDir::toNativeSeparators(u"/models"_s));
        QCOMPARE(dialog.chosen().file, sessions[0].file);
        list->setCurrentItem(list->topLevelItem(1));
        answers.confirms = false;
        buttonOf(dialog, u"Discard"_s)->click();
        QVERIFY(QFile::exists(sessions[1].file));
        answers.confirms = true;
        buttonOf(dialog, u"Discard"_s)->click();
        QVERIFY(!QFile::exists(sessions[1].file));
        QCOMPARE(dialog.count(), 2);
        list->setCurrentItem(list->topLevelItem(1));
        QCOMPARE(dialog.chosen().file, sessions[2].file);
        buttonOf(dialog, u"Recover"_s)->click();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
    }

    void discardingAllEnds()
    {
        test::Answers answers;
        const QTemporaryDir folder;
        RecoveryDialog dialog({crashed(folder.filePath(u"1.acproj"_s), QString())}, answers);
        dialog.show();
        buttonOf(dialog, u"Discard"_s)->click();
        QVERIFY(!dialog.isVisible());
        QCOMPARE(dialog.result(), int(QDialog::Rejected));
    }

    void recoveredSessionIsOpenedAndModified()
    {
        test::StudioParts studio;
        int dialogs = 0;
        studio.answers.onDialog = [&](QDialog &dialog) {
            ++dialogs;
            dialog.accept();
            return dialog.result();
        };
        studio.actions.file().offerRecovery();
        QCOMPARE(dialogs, 0);
        QDir().mkpath(studio.path("recovery"));
        crashed(studio.path("recovery/1.acproj"), studio.path("mine.acproj"));
        studio.actions.file().offerRecovery();
        QCOMPARE(dialogs, 1);
        QTRY_VERIFY(studio.workspace.document());
        QVERIFY(studio.workspace.isModified());
        QCOMPARE(studio.workspace.sessionPath(), studio.path("mine.acproj"));
    }

    //! Whoever opens the file that a crash was about is asked as well; whoever opens another one is not.
    void aCrashIsOfferedWithItsFile_data()
    {
        QTest::addColumn<bool>("accepted");
        QTest::newRow("recovered") << true;
        QTest::newRow("later") << false;
    }
    void aCrashIsOfferedWithItsFile()
    {
        QFETCH(bool, accepted);
        test::StudioParts studio;
        int dialogs = 0;
        studio.answers.onDialog = [&](QDialog &dialog) {
            ++dialogs;
            accepted ? dialog.accept() : dialog.reject();
            return dialog.result();
        };
        QDir().mkpath(studio.path("recovery"));
        crashed(studio.path("recovery/1.acproj"), studio.path("mine.acproj"));
        const DocumentState saved = DocumentState::initial(makeSample(u"bumpycube"_s).value());
        for (const char *name : {"mine.acproj", "other.acproj"})
            QVERIFY(saveProject(saved, {}, studio.path(name)).ok());
        studio.actions.file().openFile(studio.path("other.acproj"));
        QTRY_VERIFY(studio.workspace.document());
        QCOMPARE(dialogs, 0);
        QVERIFY(!studio.workspace.isModified());
        studio.actions.file().openFile(studio.path("mine.acproj"));
        QCOMPARE(dialogs, 1);
        QTRY_COMPARE(studio.workspace.sessionPath(), studio.path("mine.acproj"));
        QCOMPARE(studio.workspace.isModified(), accepted);
    }

    void listOfKeysIsThatOfTheRegistry()
    {
        test::StudioParts studio;
        studio.preferences.setShortcuts(
            {{u"uv.pack"_s, QKeySequence(u"F9"_s)}, {u"uv.cut"_s, QKeySequence()}});
        const ShortcutListDialog dialog(studio.registry);
        QMap<QString, QString> shown;
        for (QTreeWidgetItemIterator it(dialog.findChild<QTreeWidget *>()); *it; ++it)
            shown.insert((*it)->text(0), (*it)->text(1));
        QCOMPARE(shown.value(u"Pack"_s), u"F9"_s);
        QVERIFY(!shown.contains(u"Cut"_s));
        QCOMPARE(shown.value(u"Frame all"_s), u"Home, A"_s);
    }

    void aboutNamesVersionAndLicence()
    {
        QCoreApplication::setApplicationVersion(u"1.2.3"_s);
        const AboutDialog dialog;
        QString text;
        for (const QLabel *label : dialog.findChildren<QLabel *>())
            text += label->text();
        for (const QString &part : {u"1.2.3"_s, u"GNU General Public License"_s, u"Poranne"_s, u"CHOLMOD"_s})
            QVERIFY2(text.contains(part), qPrintable(part));
    }

    void unsavedQuestion_data()
    {
        QTest::addColumn<QString>("button");
        QTest::addColumn<int>("answer");
        QTest::newRow("save") << u"Save"_s << int(Questions::Unsaved::Save);
        QTest::newRow("discard") << u"Discard"_s << int(Questions::Unsaved::Discard);
        QTest::newRow("cancel") << u"Cancel"_s << int(Questions::Unsaved::Cancel);
        QTest::newRow("escape") << QString() << int(Questions::Unsaved::Cancel);
    }

    void unsavedQuestion()
    {
        QFETCH(QString, button);
        QFETCH(int, answer);
        QString text;
        QTimer::singleShot(0, this, [&] {
            QWidget *box = QApplication::activeModalWidget();
            text = qobject_cast<QMessageBox *>(box)->text();
            if (button.isEmpty())
                QTest::keyClick(box, Qt::Key_Escape);
            else
                buttonOf(*box, button)->click();
        });
        Questions questions;
        QCOMPARE(int(questions.askUnsaved(u"a.acproj"_s, false)), answer);
        QVERIFY(text.contains(u"a.acproj"_s));
    }

    void typingGoesToTheFirstField_data()
    {
        QTest::addColumn<QString>("field");
        QTest::newRow("density") << u"density"_s;
        QTest::newRow("number") << u"number"_s;
        QTest::newRow("scatter") << u"move"_s;
    }

    void typingGoesToTheFirstField()
    {
        QFETCH(QString, field);
        QWidget window;
        Questions questions(&window);
        DensityDialog density(523.627, PackingSettings(), &window);
        NumberDialog number({u"A"_s, u"B"_s, u"C"_s, {}, u"D"_s, 1002, 0, 5000}, &window);
        ScatterDialog scatter(ScatterRanges(), 1024, &window);
        for (QDialog *dialog : {static_cast<QDialog *>(&density), static_cast<QDialog *>(&number),
                                static_cast<QDialog *>(&scatter)}) {
            auto *box = dialog->findChild<QAbstractSpinBox *>(field);
            if (!box)
                continue;
            QTimer::singleShot(0, dialog, [&] {
                QVERIFY(QTest::qWaitForWindowActive(dialog));
                QVERIFY(box->hasFocus());
                QTest::keyClicks(QApplication::focusWidget(), u"300"_s);
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
            });
            QCOMPARE(questions.run(*dialog), int(QDialog::Accepted));
            box->interpretText();
            QCOMPARE(box->property("value").toDouble(), 300.0);
        }
    }

    void errorIsShownWithoutWaiting()
    {
        QWidget window;
        Questions questions(&window);
        questions.showError({u"the file is damaged"_s, u"/a/b.obj"_s, 7, u"Export it again"_s});
        const auto boxes = window.findChildren<QMessageBox *>();
        QCOMPARE(boxes.size(), 1);
        QCOMPARE(boxes.first()->text(), u"The file is damaged."_s);
        QVERIFY(boxes.first()->informativeText().contains(u"Export it again."_s));
        QVERIFY(boxes.first()->informativeText().contains(u"line 7"_s));
        boxes.first()->close();
    }

    void themesHaveContrast_data()
    {
        QTest::addColumn<int>("theme");
        QTest::newRow("dark") << int(Theme::Dark);
        QTest::newRow("light") << int(Theme::Light);
    }

    void themesHaveContrast()
    {
        QFETCH(int, theme);
        applyTheme(*qApp, Theme(theme));
        const QPalette palette = QApplication::palette();
        const auto of = [&](QPalette::ColorRole a, QPalette::ColorRole b, QPalette::ColorGroup group) {
            return contrast(palette.color(group, a), palette.color(group, b));
        };
        QVERIFY(of(QPalette::WindowText, QPalette::Window, QPalette::Active) > 7);
        QVERIFY(of(QPalette::Text, QPalette::Base, QPalette::Active) > 7);
        QVERIFY(of(QPalette::ButtonText, QPalette::Button, QPalette::Active) > 7);
        QVERIFY(of(QPalette::ToolTipText, QPalette::ToolTipBase, QPalette::Active) > 7);
        QVERIFY(of(QPalette::HighlightedText, QPalette::Highlight, QPalette::Active) > 4.5);
        QVERIFY(of(QPalette::PlaceholderText, QPalette::Base, QPalette::Active) > 4.5);
        QVERIFY(of(QPalette::Link, QPalette::Window, QPalette::Active) > 4.5);
        QVERIFY(of(QPalette::Text, QPalette::Base, QPalette::Disabled) > 2.5);
        const bool dark = luminance(palette.color(QPalette::Window)) < 0.2;
        QCOMPARE(dark, Theme(theme) == Theme::Dark);
    }

    void iconsFollowTheTheme()
    {
        const QIcon run = icon(u"run"_s);
        const auto centre = [&run](QIcon::Mode mode) {
            return run.pixmap(QSize(24, 24), 1, mode).toImage().pixelColor(11, 12);
        };
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            applyTheme(*qApp, theme);
            const QPalette palette = QApplication::palette();
            QCOMPARE(centre(QIcon::Normal).rgb(), palette.color(QPalette::ButtonText).rgb());
            QCOMPARE(centre(QIcon::Disabled).rgb(),
                     palette.color(QPalette::Disabled, QPalette::ButtonText).rgb());
            QCOMPARE(centre(QIcon::Selected).rgb(), palette.color(QPalette::HighlightedText).rgb());
        }
    }
};

QTEST_MAIN(TestDialogs)

} // namespace tst_dialogs

#include "tst_dialogs.moc"
