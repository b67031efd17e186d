// Jobs that are watched, that are cancelled, and that run while the document is edited: edits win, Cancel
// keeps what there is.
#include "model/document/makesnapshot.h"
#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "solver/packing/packmap.h"
#include "solver/unwrap/unwrap.h"
#include "support/mapstudio.h"
#include "support/meshbuilders.h"
#include "support/timers.h"

namespace tst_jobsandedits {

using namespace autocuts;
using namespace autocuts::unwrap;
using Studio = test::MapStudio;

namespace {

//! Large enough for a search that goes on while it is watched.
test::MeshPtr ball()
{
    return test::sphere(10, 12);
}

//! An edge pair that is no seam of the map that is shown, and no diagonal.
int joinedInside(const Studio &studio)
{
    const std::vector<EdgePair> &pairs = studio.workspace.document()->mesh().edgePairs;
    int edge = 0;
    while (pairs[edge].diagonal || studio.shown.isSeam(edge))
        ++edge;
    return edge;
}

} // namespace

class TestJobsAndEdits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! The best map is seen while it is looked for; the document does not change before the end.
    void unwrappingShowsItsBestMap()
    {
        Studio studio(ball());
        const std::size_t corners = studio.document().mesh().soupCornerCount();
        studio.map.unwrap(UnwrapQuality::Standard);
        QVERIFY(QTest::qWaitFor([&] { return studio.map.isPreviewing(); }, test::patience));
        QVERIFY(studio.map.jobs().isBusy());
        QVERIFY(studio.shown.isLive() && !studio.shown.isSoup());
        QCOMPARE(std::size_t(studio.shown.uv().rows()), corners);
        QVERIFY(studio.shown.uv().allFinite());
        QVERIFY(!hasUvs(studio.document()));
        QCOMPARE(studio.stack().count(), 0);
        QVERIFY(studio.ends());
        QVERIFY(!studio.map.isPreviewing() && !studio.shown.isLive());
        QCOMPARE(studio.stack().count(), 1);
        QVERIFY(studio.shown.uv() == soupUv(studio.document().mesh(), studio.document().uv()));
    }

    //! Seeing maps on the way does not change the result.
    void aWatchedUnwrapGivesTheSameMap()
    {
        Studio studio(ball());
        const Snapshot snapshot = makeSnapshot(studio.document());
        unwrap::UnwrapOptions options;
        options.packing = packing::tileOptions(studio.document().packingSettings());
        options.packing.keepScale = false;
        const UvMatrix alone = unwrap::unwrapMesh(snapshot, options).uv;
        studio.map.unwrap(UnwrapQuality::Standard);
        QVERIFY(studio.ends());
        QVERIFY(studio.document().uv() == alone);
    }

    //! The job begins again with the edit, also when that comes shortly before its end.
    void unwrappingTakesUpEdits()
    {
        Studio studio(ball());
        studio.map.unwrap(UnwrapQuality::Standard);
        QVERIFY(QTest::qWaitFor([&] { return studio.map.isPreviewing(); }, test::patience));
        const int edge = joinedInside(studio);
        studio.cut(edge);
        QVERIFY(studio.map.isPreviewing());
        const auto isCut = [&] {
            const std::vector<bool> open = openCornerPairs(studio.document().mesh(), studio.document().uv());
            return open[2 * edge] || open[2 * edge + 1];
        };
        QVERIFY(QTest::qWaitFor([&] { return isCut() && !studio.map.jobs().isBusy(); }, test::patience));
        QVERIFY(!studio.map.isPreviewing());
    }

    //! What is edited after Cancel does not begin the job again.
    void aCancelledJobStaysCancelled()
    {
        Studio studio(ball());
        studio.map.unwrap(UnwrapQuality::Best);
        QVERIFY(QTest::qWaitFor([&] { return studio.map.isPreviewing(); }, test::patience));
        studio.cut(joinedInside(studio));
        studio.map.cancel();
        QVERIFY(studio.ends());
        QVERIFY(!studio.map.isPreviewing());
        QVERIFY(test::timersRest(studio.map)); // so that no edit is taken up any more
        QVERIFY(!studio.map.jobs().isBusy());
    }

    void anEditMeanwhileWins()
    {
        Studio studio(ball());
        studio.map.unwrap(UnwrapQuality::Draft);
        studio.layOut(false);
        const UvMatrix edited = studio.document().uv();
        QVERIFY(!studio.map.jobs().isBusy() && !studio.map.isPreviewing()); // it does not go on for nothing
        QTRY_COMPARE(studio.failed.count(), 1);
        QVERIFY(studio.document().uv() == edited);
        studio.map.unwrap(UnwrapQuality::Best);
        studio.stack().undo();
        QVERIFY(!studio.map.jobs().isBusy());
        QTRY_COMPARE(studio.failed.count(), 2);
    }

    void cancelKeepsTheBestSoFar()
    {
        Studio studio("bumpycube"); // of one closed part: the search reports progress when it has a map
        studio.map.unwrap(UnwrapQuality::Best);
        QTRY_VERIFY_WITH_TIMEOUT(studio.map.jobs().progress() > 0, test::patience);
        studio.map.cancel();
        QVERIFY(studio.ends());
        QCOMPARE(studio.stack().count(), 1);
        QVERIFY(studio.measures());
        QCOMPARE(studio.map.figures()->metrics.flipped, 0);
        QCOMPARE(studio.map.figures()->metrics.facesWithoutUv, 0);
    }

    void cancelKeepsAMapThatIsBetter()
    {
        Studio studio(ball());
        studio.layOut(false);
        const UvMatrix before = studio.document().uv();
        const int entries = studio.stack().count();
        studio.map.unwrap(UnwrapQuality::Best);
        studio.map.cancel();
        QVERIFY(studio.ends());
        QVERIFY(studio.document().uv() == before);
        QCOMPARE(studio.stack().count(), entries);
        QCOMPARE(studio.failed.count(), 1);
    }

    void anotherDocumentThrowsTheResultAway()
    {
        Studio studio(ball());
        studio.map.unwrap(UnwrapQuality::Draft);
        studio.workspace.open(std::make_unique<Document>(makeSample(QStringLiteral("torus")).value()), {});
        QVERIFY(!studio.map.jobs().isBusy());
        QTRY_COMPARE_WITH_TIMEOUT(Task::threads(), 0, test::patience);
        QCOMPARE(studio.stack().count(), 0);
        QVERIFY(!studio.document().uv().allFinite());
    }
};

QTEST_GUILESS_MAIN(TestJobsAndEdits)

} // namespace tst_jobsandedits

#include "tst_jobsandedits.moc"
