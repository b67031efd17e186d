// The journal: what was done in a session can be done again, and gives the same.
#include "commands/changesettings.h"
#include "commands/journalrecorder.h"
#include "commands/replay.h"
#include "commands/setuvs.h"
#include "model/io/projectfile.h"
#include "support/editsupport.h"
#include "support/randomedits.h"

#include <QTest>

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

void pushLambda(Document &document, double lambda)
{
    SolveSettings settings = document.solveSettings();
    settings.lambda = lambda;
    pushCommand(std::make_unique<ChangeSettings>(document, settings, document.packingSettings()));
}

void moveAll(Document &document, double by, quint64 gesture = 0)
{
    UvMatrix uv = document.uv();
    uv.array() += by;
    auto command = std::make_unique<SetUvs>(document, UvEdit::Move, uv, UvEditExtras{1, {}, {}});
    command->setGesture(gesture);
    pushCommand(std::move(command));
}

//! Replays the journal after a way through a project file.
bool replays(const Journal &journal, const DocumentState &expected)
{
    const QByteArray bytes = ProjectWriter().bytes(expected, {journal, {}, {}});
    const Result<LoadedProject> loaded = parseProject(bytes, {});
    if (!loaded || !loaded->extras.journal)
        return false;
    const Result<std::unique_ptr<Document>> document = replay(*loaded->extras.journal);
    return document && sameWork(document.value()->state(), expected);
}

} // namespace

class TestJournal : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holdsWhatIsDone();
    void undoneCommandsAreLeftOut();
    void mergedCommandsAreOne();
    void forgottenCommandsStay();
    void loadedJournalGoesOn();
    void undoneBeyondItsStart();
    void sizeIsBounded();
    void sizeOfForgottenCommandsIsBounded();
    void randomSessions_data();
    void randomSessions();
    void damagedJournal();
    void differentEndIsSeen();
};

void TestJournal::holdsWhatIsDone()
{
    const auto document = test::gridDocument();
    const DocumentState start = document->state();
    JournalRecorder recorder(*document);
    QVERIFY(recorder.journal().commands.empty());
    pushLambda(*document, 0.25);
    moveAll(*document, 1);
    const Journal journal = recorder.journal();
    QCOMPARE(journal.commands.size(), std::size_t(2));
    QVERIFY(sameWork(journal.initial, start));
    QVERIFY(journal.initial.selection.isEmpty());
    QVERIFY(journal.initial.viewState.isEmpty());
    QVERIFY(replays(journal, document->state()));
    QCOMPARE(recorder.journal().commands, journal.commands);
}

void TestJournal::undoneCommandsAreLeftOut()
{
    const auto document = test::gridDocument();
    JournalRecorder recorder(*document);
    for (double lambda : {0.1, 0.2, 0.3})
        pushLambda(*document, lambda);
    const Journal three = recorder.journal();
    document->undoStack().undo();
    document->undoStack().undo();
    QCOMPARE(recorder.journal().commands.size(), std::size_t(1));
    document->undoStack().redo();
    QCOMPARE(recorder.journal().commands.size(), std::size_t(2));
    document->undoStack().undo();
    pushLambda(*document, 0.7);
    const Journal other = recorder.journal();
    QCOMPARE(other.commands.size(), std::size_t(2));
    QVERIFY(other.commands[1] != three.commands[1]);
    QVERIFY(replays(other, document->state()));
}

void TestJournal::mergedCommandsAreOne()
{
    const auto document = test::gridDocument();
    JournalRecorder recorder(*document);
    const quint64 gesture = document->undoStack().newGesture();
    moveAll(*document, 0.5, gesture);
    QVERIFY(replays(recorder.journal(), document->state()));
    moveAll(*document, 0.25, gesture);
    const Journal journal = recorder.journal();
    QCOMPARE(journal.commands.size(), std::size_t(1));
    QVERIFY(replays(journal, document->state()));
    cancelGesture(*document, gesture);
    QVERIFY(recorder.journal().commands.empty());
}

void TestJournal::forgottenCommandsStay()
{
    const auto document = test::gridDocument();
    JournalRecorder recorder(*document);
    document->undoStack().setMemoryLimit(0);
    for (int i = 0; i < 5; ++i) {
        moveAll(*document, 0.125);
        if (i == 2)
            QCOMPARE(recorder.journal().commands.size(), std::size_t(3));
    }
    QCOMPARE(document->undoStack().releasedCount(), 4);
    QCOMPARE(recorder.journal().commands.size(), std::size_t(5));
    QVERIFY(replays(recorder.journal(), document->state()));
    // The last one can be undone; undoing the others only takes them off the stack.
    document->undoStack().undo();
    document->undoStack().undo();
    QCOMPARE(recorder.journal().commands.size(), std::size_t(4));
    moveAll(*document, 2);
    QCOMPARE(recorder.journal().commands.size(), std::size_t(5));
    QVERIFY(replays(recorder.journal(), document->state()));
}

void TestJournal::loadedJournalGoesOn()
{
    const auto document = test::gridDocument();
    JournalRecorder recorder(*document);
    pushLambda(*document, 0.25);
    const QByteArray bytes = ProjectWriter().bytes(document->state(), {recorder.journal(), {}, {}});
    LoadedProject loaded = parseProject(bytes, {}).value();
    const auto second = std::move(Document::create(loaded.state).value());
    JournalRecorder next(*second, std::move(loaded.extras.journal));
    moveAll(*second, 0.5);
    const Journal journal = next.journal();
    QCOMPARE(journal.commands.size(), std::size_t(2));
    QVERIFY(sameWork(journal.initial, test::gridDocument()->state()));
    QVERIFY(replays(journal, second->state()));
}

void TestJournal::undoneBeyondItsStart()
{
    const auto document = test::gridDocument();
    pushLambda(*document, 0.25);
    pushLambda(*document, 0.5);
    JournalRecorder recorder(*document);
    moveAll(*document, 0.5);
    QCOMPARE(recorder.journal().commands.size(), std::size_t(1));
    document->undoStack().setIndex(1);
    moveAll(*document, 0.25);
    pushLambda(*document, 0.75);
    QVERIFY(recorder.journal().commands.empty());
    QVERIFY(replays(recorder.journal(), document->state()));
    moveAll(*document, 0.25);
    QCOMPARE(recorder.journal().commands.size(), std::size_t(1));
    QVERIFY(replays(recorder.journal(), document->state()));
}

void TestJournal::sizeIsBounded()
{
    const auto document = test::gridDocument();
    JournalRecorder recorder(*document);
    recorder.setByteLimit(2000);
    for (int i = 0; i < 100; ++i) {
        moveAll(*document, 0.01 * i + 0.003);
        const Journal journal = recorder.journal();
        qint64 bytes = 0;
        for (const QByteArray &command : journal.commands)
            bytes += command.size();
        QVERIFY(bytes <= 2000);
        QVERIFY(replays(journal, document->state()));
    }
}

void TestJournal::sizeOfForgottenCommandsIsBounded()
{
    const auto document = test::gridDocument();
    JournalRecorder recorder(*document);
    recorder.setByteLimit(2000);
    document->undoStack().setMemoryLimit(0);
    for (int i = 0; i < 100; ++i)
        moveAll(*document, 0.01 * i + 0.003);
    const Journal journal = recorder.journal();
    QVERIFY(journal.commands.empty());
    QVERIFY(replays(journal, document->state()));
}

void TestJournal::randomSessions_data()
{
    QTest::addColumn<int>("seed");
    QTest::addColumn<qint64>("undoBytes");
    QTest::newRow("one") << 1 << UndoStack::defaultMemoryLimit;
    QTest::newRow("two") << 2 << UndoStack::defaultMemoryLimit;
    QTest::newRow("little memory") << 3 << qint64(20000);
    QTest::newRow("no memory") << 4 << qint64(0);
}

void TestJournal::randomSessions()
{
    QFETCH(int, seed);
    QFETCH(qint64, undoBytes);
    const auto document = test::layoutDocument(test::torus(10, 8));
    UndoStack &stack = document->undoStack();
    stack.setMemoryLimit(undoBytes);
    JournalRecorder recorder(*document);
    test::RandomEdits edits(static_cast<std::uint64_t>(seed));
    test::Random &random = edits.random();
    for (int step = 0; step < 600; ++step) {
        if (random.oneIn(4))
            edits.select(*document);
        if (random.oneIn(5))
            for (int i = random.below(4); i > 0 && stack.canUndoFurther(); --i)
                stack.undo();
        else if (random.oneIn(6))
            stack.redo();
        else
            pushCommand(edits.next(*document));
        if (random.oneIn(50))
            QVERIFY(replays(recorder.journal(), document->state()));
    }
    QVERIFY(recorder.journal().commands.size() > 10);
    QVERIFY(replays(recorder.journal(), document->state()));
}

void TestJournal::damagedJournal()
{
    const auto document = test::gridDocument();
    JournalRecorder recorder(*document);
    pushLambda(*document, 0.25);
    moveAll(*document, 1);
    Journal journal = recorder.journal();
    journal.commands[1][9] = static_cast<char>(journal.commands[1][9] ^ 8);
    const auto replayed = replay(journal);
    QVERIFY(!replayed.ok());
    QVERIFY2(replayed.error().message.startsWith(u"command 2 of the journal"),
             qPrintable(replayed.error().message));
    journal.commands[1] = "ab";
    QVERIFY(!replay(journal).ok());
    journal.commands[1].clear();
    QVERIFY(!replay(journal).ok());
}

void TestJournal::differentEndIsSeen()
{
    const auto document = test::gridDocument();
    JournalRecorder recorder(*document);
    moveAll(*document, 1);
    const Journal journal = recorder.journal();
    pushLambda(*document, 0.5);
    QVERIFY(!replays(journal, document->state()));
}

QTEST_GUILESS_MAIN(TestJournal)
#include "tst_journal.moc"
