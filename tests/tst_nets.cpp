// Nets of rigid regions and of clusters beside them: the maps that the seam search starts from.
#include "solver/definite/relaxing.h"
#include "solver/preference/seampreference.h"
#include "solver/rigid/nets.h"
#include "solver/search/tutte.h"
#include "solver/unwrap/netstarts.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"
#include "support/objpolygons.h"
#include "support/props.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <set>

namespace tst_nets {

using namespace autocuts;
using namespace autocuts::test::props;

namespace {

//! With the rigid regions of its surface.
Snapshot hardSurface(test::MeshPtr mesh)
{
    Snapshot snapshot;
    snapshot.mesh = std::move(mesh);
    snapshot.settings.surface = SurfaceKind::HardSurface;
    return preference::SeamPreference().applied(snapshot, 1);
}

//! Every region as a chart of its own, by Tutte's embedding. \pre all triangles are in regions
SeamedMap regionsApart(const Snapshot &snapshot, const Soup &soup)
{
    SeamedMap map;
    for (const EdgePair &pair : snapshot.mesh->edgePairs) {
        map.cut.push_back(snapshot.rigid->region[pair.triangle[0]] !=
                          snapshot.rigid->region[pair.triangle[1]]);
    }
    map.x = search::tutteEmbedding(soup, CutMesh(*snapshot.mesh, map.cut));
    return map;
}

//! A ramp that winds up around an axis, more than once.
Model ramp()
{
    Model model;
    const int steps = 144; // of ten degrees
    for (int i = 0; i <= steps; ++i) {
        const double angle = i * std::numbers::pi / 18;
        const Vec3 outward(std::cos(angle), std::sin(angle), 0), up(0, 0, 0.03 * i);
        model.points.push_back(outward + up);
        model.points.push_back(2 * outward + up);
    }
    for (int i = 0; i < steps; ++i) {
        model.faces.push_back({2 * i, 2 * i + 1, 2 * i + 3});
        model.faces.push_back({2 * i, 2 * i + 3, 2 * i + 2});
    }
    return model;
}

//! A ring that is curved everywhere, beside a box.
test::MeshPtr ringAndBox()
{
    const test::MeshPtr ring = test::torus(16, 8);
    Model model;
    for (int v = 0; v < ring->positions.rows(); ++v)
        model.points.emplace_back(ring->positions.row(v));
    for (int face = 0; face < ring->faceCount(); ++face) {
        model.faces.emplace_back();
        for (int c = ring->faceStart[face]; c < ring->faceStart[face + 1]; ++c)
            model.faces.back().push_back(ring->cornerVertex[c]);
    }
    model.add(box({5, 5, 5}, {1, 1, 1}));
    return model.mesh();
}

} // namespace

class TestNets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    //! The gear has triangles so thin that rounding flips them when their net is turned.
    void noTriangleFlipsWhenNetsAreTurned()
    {
        const std::string folder = test::meshFolder();
        if (folder.empty())
            QSKIP(test::noMeshes);
        const Snapshot snapshot = hardSurface(test::readObjPolygons(folder + "/props/gear.obj"));
        const auto graph = search::SeamGraph::build(Soup::build(snapshot.mesh), snapshot);
        search::OptimizeOptions options;
        QVERIFY(unwrap::startFromClusterNets(graph, snapshot, options));
    }

    void regionsThatOverlapThemselvesStay()
    {
        const Snapshot snapshot = hardSurface(ramp().mesh());
        QVERIFY(snapshot.rigid);
        const std::shared_ptr<const Soup> soup = Soup::build(snapshot.mesh);
        const SeamedMap map = rigid::Nets(soup, snapshot).joined(0, regionsApart(snapshot, *soup));
        QVERIFY(!definite::coversItself(*soup, map));
    }

    //! The first map of a draft has the faces of a box as one net, and the ring in charts that fit.
    void clustersAndRegionsAreJoined()
    {
        const Snapshot snapshot = hardSurface(ringAndBox());
        QVERIFY(snapshot.rigid);
        const auto graph = search::SeamGraph::build(Soup::build(snapshot.mesh), snapshot);
        search::OptimizeOptions options;
        QVERIFY(unwrap::startFromClusterNets(graph, snapshot, options));
        QCOMPARE(options.effort.seeds, 0);
        QCOMPARE(options.given.size(), std::size_t(1));
        const SeamedMap &map = options.given.front();
        QCOMPARE(QString::fromStdString(map.validate(*graph->soup)), QString());
        QVERIFY(!definite::coversItself(*graph->soup, map));
        const CutMesh charts(*snapshot.mesh, map.cut);
        std::set<int> ofBox;
        for (int t = 0; t < snapshot.mesh->triangleCount(); ++t) {
            if (snapshot.rigid->region[t] < 0)
                continue;
            ofBox.insert(charts.chart[t]);
            QVERIFY(rigid::excessOf(*graph->soup, map.x, t) < 1e-6);
        }
        QCOMPARE(ofBox.size(), std::size_t(1));
        QVERIFY(map.distortion(*graph->soup) < 5);
    }

    //! Of the plate with holes, standard finds nothing as good as the map of a draft from another start.
    void moreEffortIsNotDearer()
    {
        const std::string folder = test::meshFolder();
        if (folder.empty())
            QSKIP(test::noMeshes);
        Snapshot snapshot;
        snapshot.mesh = test::readObjPolygons(folder + "/props/plate.obj");
        const Snapshot preferred = preference::SeamPreference().applied(snapshot);
        QVERIFY(preferred.rigid);
        const auto soup = Soup::build(snapshot.mesh);
        const auto cost = [&](unwrap::UnwrapQuality quality) {
            unwrap::UnwrapOptions options;
            options.quality = quality;
            options.pack = false;
            SeamedMap map;
            map.cut = unwrap::unwrapMesh(snapshot, options, {nullptr, 2}).cut;
            return map.seamCost(*soup, preferred);
        };
        const double draft = cost(unwrap::UnwrapQuality::Draft);
        const double standard = cost(unwrap::UnwrapQuality::Standard);
        QVERIFY2(standard < draft + 1e-9, qPrintable(QStringLiteral("%1 %2").arg(standard).arg(draft)));
    }

    //! Charts beside the regions that are nearly isometric join them.
    void nearlyFlatChartsJoin()
    {
        Snapshot snapshot = hardSurface(column(8, 1, 1, 2).mesh());
        QVERIFY(snapshot.rigid);
        const std::shared_ptr<const Soup> soup = Soup::build(snapshot.mesh);
        RigidRegions fewer = *snapshot.rigid;
        const int without = fewer.region.front();
        for (int &region : fewer.region)
            region = region == without ? -1 : region;
        SeamedMap apart =
            rigid::Nets(soup, snapshot)
                .cutOut(std::vector<bool>(fewer.count, true), regionsApart(snapshot, *soup), false);
        snapshot.rigid = std::make_shared<const RigidRegions>(fewer);
        const auto charts = [&](const SeamedMap &map) { return CutMesh(*snapshot.mesh, map.cut).chartCount; };
        const rigid::Nets nets(soup, snapshot);
        const SeamedMap alone = nets.joined(0, apart);
        const SeamedMap together = nets.withCharts(apart, snapshot).joined(0, apart);
        QCOMPARE(QString::fromStdString(together.validate(*soup)), QString());
        QVERIFY2(charts(together) < charts(alone),
                 qPrintable(QStringLiteral("%1 %2").arg(charts(together)).arg(charts(alone))));
        QVERIFY(!definite::coversItself(*soup, together));
    }
};

QTEST_APPLESS_MAIN(TestNets)

} // namespace tst_nets

#include "tst_nets.moc"
