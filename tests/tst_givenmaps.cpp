// Given seams on real meshes: none of them is lost, and what the list says of seams is true.
#include "model/document/givenseams.h"
#include "model/io/meshes/meshfile.h"
#include "model/plain/uvlayout.h"
#include "solver/base/cutmesh.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/search/resteering.h"
#include "solver/search/seamtrial.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/mapbefore.h"
#include "solver/unwrap/seamprices.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <QTest>

#include <map>

namespace tst_givenmaps {

using namespace autocuts;
using namespace autocuts::unwrap;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int dropped = 3; //!< seams that are really dropped

UnwrapOptions draft()
{
    UnwrapOptions options;
    options.quality = UnwrapQuality::Draft;
    options.packing.effort = 0.05;
    return options;
}

//! Given seams that the map does not have although they would part it.
int lostSeams(const MeshData &mesh, const std::vector<bool> &given, const CutFlags &cut)
{
    const CutMesh state(mesh, given);
    int lost = 0;
    for (std::size_t e = 0; e < given.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const bool parts = state.uvVertex[pair.corner[0][0]] != state.uvVertex[pair.corner[0][1]] ||
                           state.uvVertex[pair.corner[1][0]] != state.uvVertex[pair.corner[1][1]];
        lost += given[e] && parts && !cut[e];
    }
    return lost;
}

//! The distortion of a snapshot's map once these seams are closed; nothing when they cannot be.
std::optional<double> distortionWithout(const Snapshot &snapshot, const std::vector<int> &edges)
{
    Snapshot before = FreePart::of(snapshot)->withoutRectangles();
    const std::shared_ptr<const Soup> soup = Soup::build(before.mesh);
    const std::optional<SeamedMap> map = mapBefore(*soup, before, true);
    // With SeamMode::Only the edges of seams that had to be added are joined.
    for (std::size_t e = 0; e < map->cut.size(); ++e) {
        if (map->cut[e] && before.isJoined(e))
            before.editSteering().pairState[2 * e] = before.editSteering().pairState[2 * e + 1] =
                PairState::Free;
    }
    const auto graph = search::SeamGraph::build(soup, before);
    Snapshot joined = before;
    std::vector<PairState> &states = joined.editSteering().pairState;
    states.resize(snapshot.mesh->cornerPairCount(), PairState::Free);
    for (const int e : edges)
        states[2 * e] = states[2 * e + 1] = PairState::Joined;
    search::CutState relaxed = search::CutState::from(graph, *map, true);
    search::SeamTrial(relaxed).relaxAll(200, true);
    std::optional<search::CutState> state = search::resteered(relaxed, graph->steeredBy(joined));
    if (!state)
        return std::nullopt;
    search::SeamTrial(*state).relaxAll(200, true);
    return state->distortion;
}

} // namespace

class TestGivenMaps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noGivenSeamIsLost_data();
    void noGivenSeamIsLost();

private:
    std::map<QString, UvMatrix> mBefore; //!< per file: the map that the seams are taken from
};

void TestGivenMaps::noGivenSeamIsLost_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("sharp");
    QTest::addColumn<bool>("only");
    for (const char *file : {"organic/girl1.obj", "polygons/suzanne.obj", "polygons/spot_control_mesh.obj",
                             "irregular/multiComp.obj"}) {
        for (const bool sharp : {false, true}) {
            for (const bool only : {false, true})
                QTest::addRow("%s %s %s", file, sharp ? "sharp" : "uv", only ? "only" : "keep")
                    << QString::fromLatin1(file) << sharp << only;
        }
    }
}

void TestGivenMaps::noGivenSeamIsLost()
{
    if (test::meshFolder().empty())
        QSKIP(test::noMeshes);
    QFETCH(QString, file);
    QFETCH(bool, sharp);
    QFETCH(bool, only);
    const Result<Scene> scene = readMesh(QString::fromStdString(test::meshFolder()) + u'/' + file);
    QVERIFY(scene);
    Snapshot snapshot;
    snapshot.mesh = scene->mesh;
    UvMatrix &before = mBefore[file];
    if (before.rows() == 0)
        before = unwrapMesh(snapshot, draft()).uv;
    snapshot.uv = std::make_shared<const UvMatrix>(before);
    snapshot.uvScale = layoutScale(*scene->mesh, before);
    GivenSeamOptions options;
    options.cuts = false;
    options.map = !sharp;
    options.sharp = sharp;
    const std::vector<bool> given = givenSeams(scene.value(), &before, {}, options);
    snapshot.settings.seams = only ? SeamMode::Only : SeamMode::Keep;
    snapshot.editSteering().givenSeams = given;
    const UnwrapResult result = unwrapMesh(snapshot, draft());
    const metrics::UvMetrics figures = metrics::measureUv(*scene->mesh, result.uv);
    QCOMPARE(figures.flipped, 0);
    QCOMPARE(figures.overlapPairs, 0);
    QCOMPARE(lostSeams(*scene->mesh, given, result.cut), 0);
    if (only) {
        // What had to be added is named, edge for edge.
        int added = 0;
        for (std::size_t e = 0; e < given.size(); ++e)
            added += result.cut[e] && !given[e];
        QVERIFY(added <= static_cast<int>(result.unmet.missingSeams.size()));
    }
    if (only && !sharp && result.unmet.missingSeams.empty()) {
        // The seams are those of the map before: so is the map, or better.
        const double distortion = metrics::measureUv(*scene->mesh, before).symDirichlet;
        QVERIFY2(figures.symDirichlet < distortion + 1e-3,
                 qPrintable(u"%1 instead of %2"_s.arg(figures.symDirichlet).arg(distortion)));
    }
    qInfo("D %.4f, seams %.3f, %d islands, %zu seams added that were not given", figures.symDirichlet,
          figures.seamNorm, figures.charts, result.unmet.missingSeams.size());

    snapshot.uv = std::make_shared<const UvMatrix>(result.uv);
    snapshot.uvScale = layoutScale(*scene->mesh, result.uv);
    const SeamPrices prices = priceSeams(snapshot);
    QVERIFY(prices.hasMap);
    int checked = 0;
    for (const SeamPrice &price : prices.seams) {
        if (!price.distortion || checked == dropped)
            continue;
        for (const int e : price.edges)
            QVERIFY(given[e]);
        const std::optional<double> really = distortionWithout(snapshot, price.edges);
        QVERIFY(really);
        ++checked;
        QVERIFY2(std::abs(*really - *price.distortion) < 0.03 * (*really - 3.9),
                 qPrintable(u"%1 instead of %2"_s.arg(*really).arg(*price.distortion)));
    }
}

QTEST_GUILESS_MAIN(TestGivenMaps)

} // namespace tst_givenmaps

#include "tst_givenmaps.moc"
