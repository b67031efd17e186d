// Every command: push, undo and redo, no-ops, events, texts, journal.
#include "commands/commandfactory.h"
#include "support/commandcases.h"
#include "support/editsupport.h"
#include "support/randomedits.h"

#include <QTest>

#include <set>

namespace tst_commands {

using namespace autocuts;
using namespace autocuts::test;
using namespace Qt::Literals::StringLiterals;

namespace {

void addCases()
{
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < commandCases().size(); ++i)
        QTest::newRow(commandCases()[i].name) << static_cast<int>(i);
}

} // namespace

class TestCommands : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pushUndoRedo_data() { addCases(); }
    void pushUndoRedo();
    void noopLeavesNoEntry_data() { addCases(); }
    void noopLeavesNoEntry();
    void journal_data() { addCases(); }
    void journal();
    void damagedJournal_data() { addCases(); }
    void damagedJournal();
    void everyIdIsCovered();
};

void TestCommands::pushUndoRedo()
{
    QFETCH(int, index);
    const Case &c = commandCases()[index];
    const auto document = startFor(c);
    EventLog log(*document);
    const DocumentState before = document->state();
    QVERIFY(pushCommand(c.make(*document)));
    const DocumentState after = document->state();
    const QStringList events = log.take();
    QVERIFY(!(after == before));
    QCOMPARE(document->validate(), QString());
    QCOMPARE(document->undoStack().count(), 1);
    QCOMPARE(document->undoStack().undoText(), QString::fromLatin1(c.text));
    QVERIFY(!events.isEmpty());
    if (!c.events.isEmpty())
        QCOMPARE(events, c.events);
    for (int round = 0; round < 2; ++round) {
        document->undoStack().undo();
        QVERIFY(document->state() == before);
        QVERIFY(!log.take().isEmpty());
        document->undoStack().redo();
        QVERIFY(document->state() == after);
        QCOMPARE(log.take(), events);
    }
}

void TestCommands::noopLeavesNoEntry()
{
    QFETCH(int, index);
    const Case &c = commandCases()[index];
    if (!c.noop)
        return;
    const auto document = gridDocument();
    pushCommand(seams(SetSeamState::Edit::Cut, 20, 1)(*document));
    document->undoStack().undo();
    const DocumentState before = document->state();
    EventLog log(*document);
    if (pushCommand(c.noop(*document)))
        QFAIL(qPrintable(document->undoStack().undoText() + log.take().join(u'\n')));
    QVERIFY(document->state() == before);
    QVERIFY(log.take().isEmpty());
    QCOMPARE(document->undoStack().count(), 1); // what was undone can still be redone
    QVERIFY(document->undoStack().canRedo());
}

void TestCommands::journal()
{
    QFETCH(int, index);
    const auto document = startFor(commandCases()[index]);
    const auto second = startFor(commandCases()[index]);
    pushCommand(commandCases()[index].make(*document));
    const auto &entry = static_cast<const DocumentCommand &>(*document->undoStack().command(0));
    const QByteArray bytes = QCborValue(entry.toCbor()).toCbor();
    auto again = makeCommand(QCborValue::fromCbor(bytes).toMap(), *second);
    QVERIFY(again.ok());
    QVERIFY(pushCommand(std::move(again.value())));
    QVERIFY(second->state() == document->state());
    QCOMPARE(second->undoStack().undoText(), entry.text());
    const auto &copy = static_cast<const DocumentCommand &>(*second->undoStack().command(0));
    QCOMPARE(QCborValue(copy.toCbor()).toCbor(), bytes);
}

void TestCommands::damagedJournal()
{
    QFETCH(int, index);
    const auto document = startFor(commandCases()[index]);
    const auto second = startFor(commandCases()[index]);
    pushCommand(commandCases()[index].make(*document));
    const auto &entry = static_cast<const DocumentCommand &>(*document->undoStack().command(0));
    const QByteArray bytes = QCborValue(entry.toCbor()).toCbor();
    Random random(index + 1);
    const DocumentState before = second->state();
    for (int round = 0; round < 300; ++round) {
        QByteArray damaged = bytes;
        for (int i = random.below(3); i >= 0; --i)
            damaged[random.below(static_cast<int>(damaged.size()))] ^=
                static_cast<char>(1 << random.below(8));
        if (random.oneIn(4))
            damaged.truncate(random.below(static_cast<int>(damaged.size())));
        QCborParserError error;
        const QCborMap map = QCborValue::fromCbor(damaged, &error).toMap();
        if (error.error != QCborError::NoError)
            continue; // Qt's half-read maps must not be touched
        auto command = makeCommand(map, *second);
        if (!command.ok()) {
            QVERIFY(!command.error().message.isEmpty());
            continue;
        }
        if (!pushCommand(std::move(command.value())))
            continue;
        QCOMPARE(second->validate(), QString());
        second->undoStack().undo();
        QVERIFY(second->state() == before);
    }
    const QCborMap map = entry.toCbor();
    for (const auto &key : map.keys()) {
        QCborMap without = map;
        without.remove(key);
        // Settings and flags that stay may be left out.
        if (key != QCborValue(u"solve"_s) && key != QCborValue(u"packing"_s) && key != QCborValue(u"flags"_s))
            QVERIFY2(!makeCommand(without, *second).ok(), qPrintable(key.toString()));
    }
}

void TestCommands::everyIdIsCovered()
{
    std::set<int> ids;
    for (const Case &c : commandCases()) {
        const auto document = startFor(c);
        ids.insert(c.make(*document)->id());
    }
    // All but ReplaceModel, which is never in a journal.
    QCOMPARE(ids.size(), std::size_t(CommandId::End) - 2);
}

QTEST_GUILESS_MAIN(TestCommands)

} // namespace tst_commands

#include "tst_commands.moc"
