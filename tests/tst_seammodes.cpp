// Which edges become seams: any, the user's and more, or only the user's.
#include "solver/metrics/uvmetrics.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

namespace tst_seammodes {

using namespace autocuts;
using namespace autocuts::unwrap;

namespace {

UnwrapOptions draft()
{
    UnwrapOptions options;
    options.quality = UnwrapQuality::Draft;
    options.packing.effort = 0.05;
    return options;
}

Snapshot snapshotOf(const test::MeshPtr &mesh, SeamMode mode, const std::vector<bool> &given)
{
    Snapshot snapshot;
    snapshot.mesh = mesh;
    snapshot.settings.seams = mode;
    snapshot.editSteering().givenSeams = given;
    return snapshot;
}

void isValid(const MeshData &mesh, const UnwrapResult &result)
{
    const metrics::UvMetrics figures = metrics::measureUv(mesh, result.uv);
    QCOMPARE(figures.flipped, 0);
    QCOMPARE(figures.overlapPairs, 0);
}

} // namespace

class TestSeamModes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyTheGivenSeams_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"sphere", "torus", "cube"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void onlyTheGivenSeams()
    {
        QFETCH(QString, name);
        const test::MeshPtr mesh = test::meshNamed(name);
        const std::vector<bool> given = unwrapMesh(snapshotOf(mesh, SeamMode::Free, {}), draft()).cut;
        const UnwrapResult result = unwrapMesh(snapshotOf(mesh, SeamMode::Only, given), draft());
        QCOMPARE(result.cut, given);
        QVERIFY(result.unmet.empty());
        QVERIFY(result.withinBound);
        isValid(*mesh, result);
    }

    //! A closed surface cannot do without any seam: the map says which ones it had to add.
    void whatIsMissingIsNamed()
    {
        const test::MeshPtr mesh = test::sphere(10, 12);
        const std::vector<bool> none(mesh->edgePairs.size(), false);
        const UnwrapResult result = unwrapMesh(snapshotOf(mesh, SeamMode::Only, none), draft());
        isValid(*mesh, result);
        QVERIFY(!result.unmet.missingSeams.empty());
        std::vector<int> seams;
        for (std::size_t e = 0; e < result.cut.size(); ++e) {
            if (result.cut[e])
                seams.push_back(static_cast<int>(e));
        }
        QCOMPARE(result.unmet.missingSeams, seams);
        const UnwrapResult free = unwrapMesh(snapshotOf(mesh, SeamMode::Free, none), draft());
        QVERIFY(result.seamLength < free.seamLength);
    }

    void givenSeamsStayAndOthersAreAdded()
    {
        const test::MeshPtr mesh = test::sphere(10, 12);
        std::vector<bool> given(mesh->edgePairs.size(), false);
        for (std::size_t e = 0; e < given.size(); e += 7)
            given[e] = true;
        const UnwrapResult result = unwrapMesh(snapshotOf(mesh, SeamMode::Keep, given), draft());
        isValid(*mesh, result);
        for (std::size_t e = 0; e < given.size(); ++e)
            QVERIFY(!given[e] || result.cut[e]);
        QVERIFY(result.withinBound);
    }
};

QTEST_GUILESS_MAIN(TestSeamModes)

} // namespace tst_seammodes

#include "tst_seammodes.moc"
