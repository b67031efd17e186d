// The journal: what was done in a session can be done again, and gives the same.
#include "commands/changesettings.h"
#include "commands/journalrecorder.h"
#include "commands/replay.h"
#include "commands/setseamstate.h"
#include "commands/setseamweights.h"
#include "commands/setuvs.h"
#include "model/io/projects/projectfile.h"
#include "model/plain/polygonsides.h"
#include "support/editsupport.h"
#include "support/meshbuilders.h"
#include "support/randomedits.h"

#include <QTest>

#include <algorithm>

namespace tst_journal {

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

//! A state or weight per polygon side, which does not depend on how edges are numbered.
template <typename T>
std::vector<T> bySide(const MeshData &mesh, const std::vector<T> &values, T none)
{
    std::vector<T> result(static_cast<std::size_t>(mesh.cornerCount()), none);
    for (int p = 0; p < static_cast<int>(mesh.edgePairs.size()); ++p) {
        if (mesh.edgePairs[p].diagonal)
            continue;
        const SidePair sides = sidePair(mesh, p);
        for (std::size_t i = 0; i < 2; ++i)
            result[sides.startCorner[i]] = values[sides.cornerPair[i]];
    }
    return result;
}

std::vector<PairState> statesBySide(const Document &document)
{
    return bySide(document.mesh(), document.seams().states, PairState::Free);
}

std::vector<double> weightsBySide(const Document &document)
{
    return bySide(document.mesh(), document.seams().weights, 0.0);
}

//! Cuts one row of edges of a grid, halfway, and paints another one.
void steer(Document &document)
{
    const MeshData &mesh = document.mesh();
    std::vector<int> halfCut, pairs;
    std::vector<std::pair<int, double>> painted;
    for (int p = 0; p < static_cast<int>(mesh.edgePairs.size()); ++p) {
        if (mesh.edgePairs[p].diagonal)
            continue;
        const SidePair sides = sidePair(mesh, p);
        // The side that comes first in the file, whichever of the two the pair has first.
        const std::size_t first = sides.startCorner[0] < sides.startCorner[1] ? 0 : 1;
        if (mesh.cornerVertex[sides.startCorner[first]] % 67 == 20)
            halfCut.push_back(sides.cornerPair[first]);
        if (mesh.cornerVertex[sides.startCorner[first]] % 67 == 30)
            painted.emplace_back(sides.cornerPair[1 - first], 1.0 + sides.startCorner[first] % 7);
    }
    std::sort(halfCut.begin(), halfCut.end());
    std::sort(painted.begin(), painted.end());
    pushCommand(
        std::make_unique<SetSeamState>(document, SetSeamState::Edit::Cut, IndexRanges::fromSorted(halfCut)));
    std::vector<double> weights;
    for (const auto &[pair, weight] : painted) {
        pairs.push_back(pair);
        weights.push_back(weight);
    }
    pushCommand(std::make_unique<SetSeamWeights>(document, IndexRanges::fromSorted(pairs), weights));
}

LoadedProject fixture(const char *name)
{
    return loadProject(QStringLiteral(AUTOCUTS_SOURCE_DIR "/tests/data/") + QLatin1StringView(name)).value();
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
    void numbersOfEdgesDoNotMatter();
    void versionOneReplays();
    void versionOneOfALargeMeshIsLeftOut();
    void largeMeshReplays();
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

void TestJournal::numbersOfEdgesDoNotMatter()
{
    // Two grids with the same faces whose places run in other directions: their edges have other numbers.
    const test::MeshPtr one = test::grid(66);
    PositionMatrix turned = one->positions;
    turned.col(0) = one->positions.col(1);
    turned.col(1) = -one->positions.col(0);
    const test::MeshPtr two = MeshData::build(turned, one->faceStart, one->cornerVertex, one->faceObject);
    const auto isSame = [](const EdgePair &a, const EdgePair &b) { return a.corner == b.corner; };
    QVERIFY(one->triangles != two->triangles ||
            !std::equal(one->edgePairs.begin(), one->edgePairs.end(), two->edgePairs.begin(), isSame));
    Document first(test::sceneOf(one));
    JournalRecorder recorder(first);
    steer(first);
    Journal journal = recorder.journal();
    QCOMPARE(journal.commands.size(), std::size_t(2));
    journal.initial = Document(test::sceneOf(two)).state();
    const auto replayed = replay(journal);
    QVERIFY(replayed.ok());
    QVERIFY(first.seams().states != replayed.value()->seams().states);
    QVERIFY(statesBySide(*replayed.value()) == statesBySide(first));
    QVERIFY(weightsBySide(*replayed.value()) == weightsBySide(first));
}

void TestJournal::versionOneReplays()
{
    const LoadedProject loaded = fixture("journal-v1.acproj");
    QVERIFY(loaded.lost.isEmpty());
    QVERIFY(loaded.extras.journal);
    QVERIFY(loaded.extras.journal->commands.size() > 10);
    const auto replayed = replay(*loaded.extras.journal);
    QVERIFY(replayed.ok());
    QVERIFY(sameWork(replayed.value()->state(), loaded.state));
    // It can go on in a file of today.
    const auto document = std::move(Document::create(loaded.state).value());
    JournalRecorder recorder(*document, loaded.extras.journal);
    pushCommand(std::make_unique<SetSeamState>(*document, SetSeamState::Edit::Clear,
                                               IndexRanges::all(document->mesh().cornerPairCount())));
    QVERIFY(replays(recorder.journal(), document->state()));
}

//! The fixture was made before the triangles of large meshes were numbered along a curve.
void TestJournal::versionOneOfALargeMeshIsLeftOut()
{
    const LoadedProject loaded = fixture("journal-v1-large.acproj");
    QCOMPARE(loaded.state.scene.mesh->faceCount(), 66 * 66);
    QVERIFY(loaded.lost.isEmpty());
    QVERIFY(!loaded.extras.journal);
    QVERIFY2(loaded.notes.join(u' ').contains(u"the journal was left out and begins anew"),
             qPrintable(loaded.notes.join(u' ')));
    // The seams are named by sides: both corner pairs of the edges of one row of quads. The edges that were
    // selected cannot be known.
    const std::vector<PairState> &states = loaded.state.seams.states;
    QCOMPARE(std::count(states.begin(), states.end(), PairState::Cut), 2 * (65 + 66));
    QCOMPARE(loaded.state.selection.mode, SelectionMode::Edges);
    QVERIFY(loaded.state.selection.edges.isEmpty());
}

void TestJournal::largeMeshReplays()
{
    const LoadedProject loaded = fixture("journal-v2-large.acproj");
    QVERIFY(loaded.lost.isEmpty());
    QVERIFY(loaded.extras.journal);
    QCOMPARE(loaded.extras.journal->commands.size(), std::size_t(2));
    const auto replayed = replay(*loaded.extras.journal);
    QVERIFY(replayed.ok());
    QVERIFY(sameWork(replayed.value()->state(), loaded.state));
    Document expected(test::sceneOf(test::grid(66)));
    steer(expected);
    QVERIFY(statesBySide(*replayed.value()) == statesBySide(expected));
    QVERIFY(weightsBySide(*replayed.value()) == weightsBySide(expected));
    // All edges on one boundary of the grid and across its middle are selected, wherever they stand.
    const MeshAdjacency adjacency(*loaded.state.scene.mesh);
    QCOMPARE(loaded.state.selection.edges.size(), 2 * 66);
    for (int edge : loaded.state.selection.edges) {
        const std::array<int, 2> &ends = adjacency.edgeVertices(edge);
        QVERIFY((ends[0] % 67 == 0 || ends[0] % 67 == 33) && ends[1] % 67 == ends[0] % 67);
    }
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

} // namespace tst_journal

#include "tst_journal.moc"
