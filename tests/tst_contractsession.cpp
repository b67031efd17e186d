// The steering contract through a document: commands record the steering, a session is saved, opened and
// replayed, and every job still obeys.
#include "commands/changesettings.h"
#include "commands/editpins.h"
#include "commands/editrectangles.h"
#include "commands/journalrecorder.h"
#include "commands/newmap.h"
#include "commands/replay.h"
#include "commands/reset.h"
#include "commands/setislandflags.h"
#include "commands/setseamstate.h"
#include "commands/setseamweights.h"
#include "model/document/makesnapshot.h"
#include "support/editsupport.h"
#include "support/sessions.h"
#include "support/steeredjobs.h"

#include <QTest>

#include <map>
#include <set>

namespace tst_contractsession {

using namespace autocuts;

namespace {

//! Gives a document the map and the steering of a snapshot, by commands.
class Editor
{
public:
    Editor(Document &document, const Snapshot &wanted)
        : mDocument(document), mWanted(wanted), mMesh(*wanted.mesh), mSteering(*wanted.steering)
    {}

    void push()
    {
        pushCommand(std::make_unique<Reset>(mDocument, Reset::Steering | Reset::Marks));
        pushCommand(newMapCommand(mDocument, UvEdit::Solve, *mWanted.uv));
        SolveSettings settings = mDocument.solveSettings();
        settings.seed = mWanted.settings.seed;
        pushCommand(std::make_unique<ChangeSettings>(mDocument, settings));
        pushEdges();
        pushPins();
        pushRectangles();
        pushFlags();
    }

private:
    void pushEdges()
    {
        std::vector<int> cuts, joins, painted;
        std::vector<double> weights;
        for (int p = 0; p < mMesh.cornerPairCount(); ++p) {
            if (!mSteering.pairState.empty() && mSteering.pairState[p] == PairState::Cut)
                cuts.push_back(p);
            if (!mSteering.pairState.empty() && mSteering.pairState[p] == PairState::Joined)
                joins.push_back(p);
            if (!mSteering.pairWeight.empty() && mSteering.pairWeight[p] != 1) {
                painted.push_back(p);
                weights.push_back(mSteering.pairWeight[p]);
            }
        }
        using Edit = SetSeamState::Edit;
        pushCommand(std::make_unique<SetSeamState>(mDocument, Edit::Cut, IndexRanges::fromSorted(cuts)));
        pushCommand(std::make_unique<SetSeamState>(mDocument, Edit::Join, IndexRanges::fromSorted(joins)));
        pushCommand(std::make_unique<SetSeamWeights>(mDocument, IndexRanges::fromSorted(painted), weights));
    }

    void pushPins()
    {
        std::vector<UvPin> pins;
        std::set<int> corners;
        for (const Pin &pin : mSteering.pins) {
            const int corner = mMesh.cornerOfSoup(pin.soupCorner);
            if (corners.insert(corner).second)
                pins.push_back({corner, mWanted.uvScale * pin.target, pin.hard, pin.weight});
        }
        pushCommand(std::make_unique<EditPins>(mDocument, EditPins::Edit::Pin, pins));
    }

    void pushRectangles()
    {
        for (const UvRectangle &box : mSteering.rectangles) {
            LayoutRectangle rectangle;
            rectangle.lower = mWanted.uvScale * box.lower;
            rectangle.upper = mWanted.uvScale * box.upper;
            rectangle.hard = box.hard;
            std::set<int> faces;
            for (const int s : box.soupCorners)
                faces.insert(mMesh.triangleFace[s / 3]);
            rectangle.faces = QList<int>(faces.begin(), faces.end());
            pushCommand(EditRectangles::add(mDocument, rectangle));
        }
    }

    void pushFlags()
    {
        std::set<int> locked;
        std::map<int, std::set<int>> stacks, groups;
        for (std::size_t face = 0; face < mSteering.faceFlags.size(); ++face) {
            const IslandFlags &flags = mSteering.faceFlags[face];
            const int island = mDocument.islands().islandOfFace(static_cast<int>(face));
            if (flags.locked)
                locked.insert(island);
            if (flags.stack)
                stacks[flags.stack].insert(island);
            if (flags.group)
                groups[flags.group].insert(island);
        }
        using Edit = SetIslandFlags::Edit;
        const auto flag = [&](Edit edit, const std::set<int> &islands) {
            pushCommand(std::make_unique<SetIslandFlags>(mDocument, edit,
                                                         std::vector<int>(islands.begin(), islands.end())));
        };
        flag(Edit::Lock, locked);
        for (const auto &[number, islands] : stacks)
            flag(Edit::Stack, islands);
        for (const auto &[number, islands] : groups)
            flag(Edit::Group, islands);
    }

    Document &mDocument;
    const Snapshot &mWanted;
    const MeshData &mMesh;
    const Steering &mSteering;
};

} // namespace

class TestContractSession : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sessionsKeepTheContract_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : test::contractMeshes())
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void sessionsKeepTheContract();
};

//! Steers, runs a job, saves, opens and runs the job again, over and over in one session; then replays all.
void TestContractSession::sessionsKeepTheContract()
{
    QFETCH(QString, name);
    const test::MeshPtr mesh = test::contractMesh(name);
    const UvMatrix uv = test::contractMap(mesh);
    Document document(test::sceneOf(mesh));
    JournalRecorder recorder(document);
    const UvEdit edits[] = {UvEdit::Solve, UvEdit::Finish, UvEdit::Separate, UvEdit::Pack, UvEdit::Solve};
    const std::vector<test::SteeredJob> &jobs = test::steeredJobs();
    QCOMPARE(jobs.size(), std::size(edits));
    QStringList broken;
    for (int seed = 1; seed <= test::steeringCount(); ++seed) {
        const Snapshot wanted = test::steered(mesh, uv, seed);
        Editor(document, wanted).push();
        const Snapshot snapshot = makeSnapshot(document);
        QCOMPARE(snapshot.steering->pins.size(), wanted.steering->pins.size());
        QCOMPARE(snapshot.steering->rectangles.size(), wanted.steering->rectangles.size());
        const std::size_t which = seed % jobs.size();
        const test::SteeredJob &job = jobs[which];
        const test::Outcome outcome = job.run(snapshot);
        for (const QString &clause : test::broken(snapshot, outcome))
            broken
                << QStringLiteral("%1 with seed %2: %3").arg(QLatin1String(job.name)).arg(seed).arg(clause);

        const QByteArray saved = test::bytesOf({document.state(), {recorder.journal(), {}, {}}});
        Result<LoadedProject> loaded = parseProject(saved, QStringLiteral("a.acproj"));
        QVERIFY(loaded.ok());
        QCOMPARE(loaded->notes, QStringList());
        QVERIFY(sameWork(loaded->state, document.state()));
        const auto opened = std::move(Document::create(std::move(loaded->state)).value());
        const test::Outcome again = job.run(makeSnapshot(*opened));
        if (std::string_view(job.name) == "live") // which of its maps is the second depends on time
            broken += test::broken(snapshot, again);
        else
            QVERIFY2(again.uv == outcome.uv, job.name);
        pushCommand(newMapCommand(document, edits[which], outcome.uv));
    }
    QVERIFY2(broken.isEmpty(), qPrintable(broken.join(u'\n')));
    const Result<std::unique_ptr<Document>> again = replay(recorder.journal());
    QVERIFY(again.ok());
    QVERIFY(sameWork(again.value()->state(), document.state()));
}

QTEST_GUILESS_MAIN(TestContractSession)

} // namespace tst_contractsession

#include "tst_contractsession.moc"
