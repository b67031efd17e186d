// The German texts: all of the sources are there, they fit their English ones, and the window has room for
// them.
#include "support/studioparts.h"
#include "support/studiosession.h"
#include "views/actions/actiontable.h"
#include "views/actions/menubuilder.h"
#include "views/actions/preferencesdialog.h"
#include "views/ui/language.h"

#include <QAbstractButton>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTranslator>
#include <QXmlStreamReader>

#include <map>
#include <set>

namespace tst_translations {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;
using test::StudioSession;

namespace {

const QString sourceRoot = QStringLiteral(AUTOCUTS_SOURCE_DIR);
const QString germanFile = sourceRoot + u"/resources/translations/autocuts_de.ts"_s;

struct Message
{
    QString context, source, comment;
    QStringList translations; //!< more than one for plural forms
    bool plural = false;
    bool finished = true;

    QString name() const { return context + u": "_s + source; }
    auto key() const { return std::tuple(context, source, comment); }
};

Message readMessage(QXmlStreamReader &xml, const QString &context)
{
    Message message;
    message.context = context;
    message.plural = xml.attributes().value("numerus"_L1) == "yes"_L1;
    while (xml.readNextStartElement()) {
        if (xml.name() == "source"_L1) {
            message.source = xml.readElementText();
        } else if (xml.name() == "comment"_L1) {
            message.comment = xml.readElementText();
        } else if (xml.name() == "translation"_L1) {
            message.finished = !xml.attributes().hasAttribute("type"_L1);
            if (message.plural) {
                while (xml.readNextStartElement())
                    message.translations << xml.readElementText();
            } else {
                message.translations << xml.readElementText();
            }
        } else {
            xml.skipCurrentElement();
        }
    }
    return message;
}

//! The messages of a .ts file; none when it is not one.
std::vector<Message> readMessages(const QString &path)
{
    QFile file(path);
    std::vector<Message> result;
    if (!file.open(QIODevice::ReadOnly))
        return result;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == "name"_L1)
            context = xml.readElementText();
        else if (xml.name() == "message"_L1)
            result.push_back(readMessage(xml, context));
    }
    return xml.hasError() ? std::vector<Message>() : result;
}

QStringList placeholders(const QString &text)
{
    static const QRegularExpression pattern(u"%L?(n|[1-9][0-9]?)"_s);
    QStringList result;
    for (const QRegularExpressionMatch &match : pattern.globalMatch(text))
        result << match.captured(0);
    result.sort();
    return result;
}

//! The letter after a single "&", in lower case; empty when there is none.
QString mnemonic(const QString &text)
{
    static const QRegularExpression pattern(u"(?:^|[^&])(?:&&)*&([^&])"_s);
    return pattern.match(text).captured(1).toLower();
}

//! Why a translation does not fit its source; empty when it does.
QString misfit(const Message &message, const QString &text)
{
    const auto ends = [&](const QString &ending) {
        return message.source.endsWith(ending) == text.endsWith(ending);
    };
    if (text.isEmpty() != message.source.isEmpty())
        return u"empty"_s;
    QStringList expected = placeholders(message.source);
    if (message.plural && text == message.translations.front() && !text.contains(u"%n"_s))
        expected.removeAll(u"%n"_s); // the form for 1 may leave the number out
    if (placeholders(text) != expected)
        return u"other placeholders"_s;
    if (mnemonic(text).isEmpty() != mnemonic(message.source).isEmpty())
        return u"mnemonic"_s;
    if (!ends(u"..."_s) || !ends(u"…"_s) || !ends(u":"_s) || !ends(u"."_s))
        return u"other ending"_s;
    if (text.startsWith(u' ') != message.source.startsWith(u' '))
        return u"space"_s;
    return {};
}

//! The letters of a menu, or of a row of buttons, that are given twice.
QStringList doubleMnemonics(const QStringList &texts)
{
    std::map<QString, QString> seen;
    QStringList result;
    for (const QString &text : texts) {
        const QString letter = mnemonic(text);
        if (letter.isEmpty())
            continue;
        if (const auto [at, isNew] = seen.emplace(letter, text); !isNew)
            result << at->second + u" - "_s + text;
    }
    return result;
}

QStringList textsOf(const QList<QAction *> &actions)
{
    QStringList result;
    for (const QAction *action : actions)
        result << action->text();
    return result;
}

//! The texts with mnemonics that a dialog shows now.
QStringList shownTexts(const QWidget &dialog)
{
    QStringList result;
    for (const auto *button : dialog.findChildren<QAbstractButton *>()) {
        if (button->isVisible())
            result << button->text();
    }
    for (const auto *label : dialog.findChildren<QLabel *>()) {
        if (label->isVisible() && label->buddy())
            result << label->text();
    }
    return result;
}

//! True when a text needs more room than its widget has.
bool isCut(const QLabel &label)
{
    if (label.text().isEmpty() || label.inherits("autocuts::ElidedLabel"))
        return false;
    if (label.wordWrap())
        return label.heightForWidth(label.width()) > label.height();
    return label.minimumSizeHint().width() > label.width();
}

bool isCut(const QAbstractButton &button)
{
    if (button.text().isEmpty())
        return false;
    if (const auto *tool = qobject_cast<const QToolButton *>(&button);
        tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly)
        return false;
    const int text = button.fontMetrics().size(Qt::TextShowMnemonic, button.text()).width();
    const int icon = button.icon().isNull() ? 0 : button.iconSize().width();
    return text + icon > button.width();
}

//! What of the window or a dialog does not have room for its text.
QStringList cutTexts(const QWidget &window)
{
    QStringList result;
    const auto note = [&](const QWidget &widget, const QString &text, bool cut) {
        if (widget.isVisible() && (cut || widget.visibleRegion().boundingRect().width() < widget.width()) &&
            !widget.visibleRegion().isEmpty())
            result << QLatin1StringView(widget.metaObject()->className()) + u": "_s + text;
    };
    for (const auto *label : window.findChildren<QLabel *>())
        note(*label, label->text(), isCut(*label));
    for (const auto *button : window.findChildren<QAbstractButton *>())
        note(*button, button->text(), isCut(*button));
    return result;
}

} // namespace

class TestTranslations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        installLanguage(*QCoreApplication::instance(), Language::German);
        mMessages = readMessages(germanFile);
    }

    void everyTextIsTranslated()
    {
        QVERIFY(mMessages.size() > 1000);
        for (const Message &message : mMessages) {
            QVERIFY2(message.finished, qPrintable(message.name()));
            QCOMPARE(message.translations.size(), message.plural ? 2 : 1);
            for (const QString &text : message.translations)
                QVERIFY2(misfit(message, text).isEmpty(),
                         qPrintable(misfit(message, text) + u": "_s + message.name() + u" - "_s + text));
        }
    }

    void theSourcesHaveNoOtherTexts_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QStringList>("options");
        QTest::newRow("German") << germanFile << QStringList();
        QTest::newRow("English, texts with a number")
            << sourceRoot + u"/resources/translations/autocuts_en.ts"_s << QStringList{u"-pluralonly"_s};
    }
    void theSourcesHaveNoOtherTexts()
    {
        QFETCH(QString, file);
        QFETCH(QStringList, options);
        const QString lupdate = QStringLiteral(AUTOCUTS_LUPDATE);
        if (lupdate.isEmpty())
            QSKIP("lupdate is not installed");
        const QTemporaryDir folder;
        const QString copy = folder.filePath(u"copy.ts"_s);
        QVERIFY(QFile::copy(file, copy));
        QProcess process;
        process.setWorkingDirectory(sourceRoot);
        process.start(lupdate, options + QStringList{u"-silent"_s, u"-I"_s, u"src"_s, u"src/views"_s,
                                                     u"src/commands"_s, u"src/jobs"_s, u"src/model"_s,
                                                     u"src/main.cpp"_s, u"-no-obsolete"_s, u"-locations"_s,
                                                     u"none"_s, u"-ts"_s, copy});
        QVERIFY(process.waitForFinished(120'000));
        QCOMPARE(process.exitCode(), 0);
        const std::vector<Message> found = readMessages(copy);
        for (const Message &message : found)
            QVERIFY2(message.finished,
                     qPrintable(u"run scripts/translations and translate "_s + message.name()));
        std::set<decltype(Message().key())> keys;
        for (const Message &message : found)
            keys.insert(message.key());
        for (const Message &message : readMessages(file))
            QVERIFY2(keys.contains(message.key()),
                     qPrintable(u"run scripts/translations: gone is "_s + message.name()));
    }

    void theSystemSaysWhichLanguage_data()
    {
        QTest::addColumn<QStringList>("system");
        QTest::addColumn<bool>("german");
        QTest::newRow("German") << QStringList{u"de-AT"_s} << true;
        QTest::newRow("English first") << QStringList{u"en-US"_s, u"de-DE"_s} << false;
        QTest::newRow("the next there is") << QStringList{u"fr-FR"_s, u"de"_s, u"en"_s} << true;
        QTest::newRow("none there is") << QStringList{u"ja-JP"_s} << false;
        QTest::newRow("none") << QStringList{} << false;
    }
    void theSystemSaysWhichLanguage()
    {
        QFETCH(QStringList, system);
        QFETCH(bool, german);
        QCOMPARE(effectiveLanguage(Language::System, system), german ? Language::German : Language::English);
        QCOMPARE(effectiveLanguage(Language::English, system), Language::English);
        QCOMPARE(effectiveLanguage(Language::German, system), Language::German);
    }

    void menusHaveEachMnemonicOnce()
    {
        test::StudioParts studio;
        QMenuBar bar;
        const MenuBuilder menus(studio.registry, bar);
        QCOMPARE(menus.menu(u"Edit"_s)->title(), u"&Bearbeiten"_s);
        const auto none = QStringList();
        QCOMPARE(doubleMnemonics(textsOf(bar.actions())), none);
        for (const auto &[path, menu] : menus.menus())
            QCOMPARE(doubleMnemonics(textsOf(menu->actions())).join(u", "_s), QString());
        // Alt with the letter of a menu must not be the key of an action.
        for (const QAction *menu : bar.actions()) {
            const QKeySequence keys(u"Alt+"_s + mnemonic(menu->text()).toUpper());
            for (const QAction *action : studio.registry.actions())
                QVERIFY2(!action->shortcuts().contains(keys), qPrintable(action->text()));
        }
    }

    void historyCountsInGerman()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        QVERIFY(studio.jobsRest());
        studio.action("select.edges")->trigger();
        studio.action("select.all")->trigger();
        studio.action("uv.cut")->trigger();
        const QString text = studio.document()->undoStack().undoText();
        QVERIFY2(QRegularExpression(u"^[0-9]+ Kanten schneiden$"_s).match(text).hasMatch(), qPrintable(text));
    }

    void englishHasASingular()
    {
        QTranslator english;
        QVERIFY(english.load(u"autocuts_en"_s, u":/translations"_s));
        QCOMPARE(english.translate("UndoText", "Cut %n edges", nullptr, 1), u"Cut %n edge"_s);
        QCOMPARE(english.translate("UndoText", "Move %n rectangles", nullptr, 1), u"Move rectangle"_s);
        QCOMPARE(english.translate("UndoText", "Move %n rectangles", nullptr, 2), u"Move %n rectangles"_s);
    }

    void buttonsOfQtAreGerman()
    {
        if (!QFile::exists(u":/translations/qtbase_de.qm"_s))
            QSKIP("Qt's own texts were not installed when this was built");
        const QDialogButtonBox box(QDialogButtonBox::Cancel);
        QVERIFY(box.button(QDialogButtonBox::Cancel)->text().contains(u"Abbrechen"));
    }

    void theWindowHasRoom()
    {
        StudioSession studio;
        QVERIFY2(studio.window.minimumSizeHint().width() <= 960,
                 qPrintable(QString::number(studio.window.minimumSizeHint().width())));
        QVERIFY2(studio.window.minimumSizeHint().height() <= 500,
                 qPrintable(QString::number(studio.window.minimumSizeHint().height())));
        studio.window.resize(1280, 800);
        studio.action("file.sample.machine")->trigger();
        QVERIFY(studio.jobsRest());
        QCOMPARE(studio.window.size(), QSize(1280, 800));
        for (QDockWidget *dock : studio.window.findChildren<QDockWidget *>()) {
            dock->show();
            dock->raise();
            QTest::qWait(50);
            // The figures of the map come when they are measured, and with them a button.
            QTRY_COMPARE(cutTexts(*dock).join(u", "_s), QString());
        }
        QTRY_COMPARE(cutTexts(studio.window).join(u", "_s), QString());
    }

    void dialogsHaveRoom()
    {
        StudioSession studio;
        studio.action("file.sample.bumpycube")->trigger();
        QVERIFY(studio.jobsRest());
        studio.context.map.unwrap(unwrap::UnwrapQuality::Draft);
        QVERIFY(studio.jobsRest());
        QStringList faults;
        const auto examine = [&faults](const QDialog &dialog) {
            QTest::qWait(50);
            faults << cutTexts(dialog) << doubleMnemonics(shownTexts(dialog));
        };
        int shown = 0;
        studio.answers->onDialog = [&](QDialog &dialog) {
            ++shown;
            dialog.show();
            examine(dialog);
            if (auto *const preferences = qobject_cast<PreferencesDialog *>(&dialog)) {
                preferences->showPage(PreferencesDialog::Page::Appearance);
                examine(dialog);
                preferences->showPage(PreferencesDialog::Page::Shortcuts);
                examine(dialog);
            }
            return int(QDialog::Rejected);
        };
        const char *const ids[] = {
            "edit.preferences", "file.exportMesh", "file.exportLayout", "view.preview", "uv.texelWeight",
            "uv.scatter",       "uv.densitySet",   "select.sharp",      "select.small", "select.flat",
            "help.about",       "help.shortcuts",  "help.findAction"};
        for (const char *id : ids) {
            studio.action("select.all")->trigger();
            studio.action(id)->trigger();
            QVERIFY2(faults.isEmpty(), qPrintable(QLatin1StringView(id) + u": "_s + faults.join(u'\n')));
        }
        QCOMPARE(shown, int(std::size(ids)));
    }

private:
    std::vector<Message> mMessages;
};

QTEST_MAIN(TestTranslations)

} // namespace tst_translations

#include "tst_translations.moc"
