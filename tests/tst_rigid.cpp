// Flat faces, and what unrolls without stretch, keep their shape: how regions are found, and what an unwrap
// makes of them.
#include "model/plain/edgeangles.h"
#include "solver/preference/creases.h"
#include "solver/rigid/stiffregions.h"
#include "solver/rigid/unrolling.h"
#include "solver/unwrap/unwrap.h"
#include "support/props.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace tst_rigid {

using namespace autocuts;
using namespace autocuts::test::props;

namespace {

std::shared_ptr<const RigidRegions> regionsOf(const test::MeshPtr &mesh)
{
    return rigid::rigidRegions(mesh, preference::creases(*mesh, edgeAngles(*mesh)));
}

int islands(const MeshData &mesh, const CutFlags &cut)
{
    return CutMesh(mesh, cut).chartCount;
}

//! Largest stretch or squeeze of a triangle in a rigid region, beside the scale of the whole map.
double worstOfRigid(const MeshData &mesh, const RigidRegions &regions, const UvMatrix &uv)
{
    const std::shared_ptr<const Soup> soup = Soup::build(std::make_shared<const MeshData>(mesh));
    double area = 0;
    std::vector<Eigen::Matrix2d> jacobians;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        Eigen::Matrix2d j = Eigen::Matrix2d::Zero();
        for (int k = 0; k < 3; ++k)
            j += uv.row(mesh.cornerOfSoup(3 * t + k)).transpose() *
                 Eigen::RowVector2d(soup->basis[t][2 * k], soup->basis[t][2 * k + 1]);
        area += soup->weight[t] * j.determinant();
        jacobians.push_back(j);
    }
    double worst = 1;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (regions.region[t] < 0)
            continue;
        const Eigen::Vector2d values =
            Eigen::JacobiSVD<Eigen::Matrix2d>(jacobians[t] / std::sqrt(area)).singularValues();
        worst = std::max({worst, values[0], 1 / values[1]});
    }
    return worst;
}

} // namespace

class TestRigid : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void regions_data();
    void regions();
    void unwrapped_data();
    void unwrapped();
    void panelsKeepWhatTheyCan_data();
    void panelsKeepWhatTheyCan();
    void smoothBodiesStayWhole();
    void alignedIslandsKeepTheirShape_data();
    void alignedIslandsKeepTheirShape();
    void freeIsAsBefore();
    void lambdaIsThePapers();
    void stiffnessLeavesTheBound();
};

void TestRigid::regions_data()
{
    QTest::addColumn<test::MeshPtr>("mesh");
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("share");
    QTest::newRow("box") << box({0, 0, 0}, {3, 2, 1}).mesh() << 6 << 1.0;
    QTest::newRow("prism") << column(6, 1, 1, 3).mesh() << 8 << 1.0;
    QTest::newRow("cylinder") << column(32, 1, 1, 3).mesh() << 3 << 1.0;
    QTest::newRow("cylinder of rows") << column(32, 1, 1, 3, 5).mesh() << 3 << 1.0;
    QTest::newRow("cone") << column(32, 1, 0, 3).mesh() << 2 << 1.0;
    QTest::newRow("pyramid") << column(4, 1, 0, 2).mesh() << 5 << 1.0;
    QTest::newRow("house") << house().mesh() << 7 << 1.0;
    QTest::newRow("shelf") << shelf().mesh() << 36 << 1.0;
    QTest::newRow("sphere") << sphere(12, 1).mesh() << 0 << 0.0;
    // A box beside a sphere of the same area: judged part by part.
    Model mixed = sphere(12, 1);
    mixed.add(box({3, 0, 0}, {1, 1, 1}));
    QTest::newRow("box and sphere") << mixed.mesh() << 6 << 0.33;
    QTest::newRow("cushion") << cushion(0.1).mesh() << 6 << 1.0;
    QTest::newRow("round cushion") << cushion(0.8).mesh() << 0 << 0.0;
    // Less than 1e-4 of the area of the largest part is dust.
    Model dusty = sphere(12, 1), small = dusty;
    dusty.add(box({3, 0, 0}, {0.01, 0.01, 0.01}));
    small.add(box({3, 0, 0}, {0.02, 0.02, 0.02}));
    QTest::newRow("dust and sphere") << dusty.mesh() << 0 << 0.0;
    QTest::newRow("small box and sphere") << small.mesh() << 6 << 0.0;
}

void TestRigid::regions()
{
    QFETCH(const test::MeshPtr, mesh);
    QFETCH(const int, count);
    QFETCH(const double, share);
    const auto found = regionsOf(mesh);
    if (count == 0) {
        QVERIFY(!found);
        return;
    }
    QVERIFY(found);
    std::set<int> numbers(found->region.begin(), found->region.end());
    numbers.erase(-1);
    QCOMPARE(static_cast<int>(numbers.size()), count);
    QVERIFY2(std::abs(found->share - share) < 0.01, qPrintable(QString::number(found->share)));
    for (int f = 0; f < mesh->faceCount(); ++f) {
        for (const int t : mesh->trianglesOf(f))
            QCOMPARE(found->region[t], found->region[mesh->faceTriangle[f]]);
    }
}

void TestRigid::unwrapped_data()
{
    QTest::addColumn<test::MeshPtr>("mesh");
    QTest::addColumn<int>("most"); // islands
    QTest::addColumn<int>("least");
    QTest::newRow("box: a net") << box({0, 0, 0}, {3, 2, 1}).mesh() << 1 << 1;
    QTest::newRow("prism: a net") << column(6, 1, 1, 3).mesh() << 1 << 1;
    QTest::newRow("cylinder: two discs and a strip") << column(32, 1, 1, 3).mesh() << 3 << 3;
    QTest::newRow("cylinder of rows") << column(32, 1, 1, 3, 5).mesh() << 3 << 3;
    QTest::newRow("cone: a disc and a fan") << column(32, 1, 0, 3).mesh() << 2 << 2;
    QTest::newRow("pyramid") << column(4, 1, 0, 2).mesh() << 1 << 1;
    QTest::newRow("house") << house().mesh() << 2 << 1;
    QTest::newRow("stairs") << stairs(8).mesh() << 4 << 1;
    QTest::newRow("shelf") << shelf().mesh() << 12 << 6;
    Model mixed = column(32, 1, 1, 3);
    mixed.add(moved(sphere(10, 1), {4, 0, 0}));
    QTest::newRow("cylinder and sphere") << mixed.mesh() << 8 << 4;
    QTest::newRow("bolt") << bolt().mesh() << 5 << 4;
    QTest::newRow("table") << table().mesh() << 12 << 5;
    QTest::newRow("pipe") << pipe().mesh() << 8 << 1;
    QTest::newRow("bicycle") << bicycle().mesh() << 36 << 10;
    // The bottom of a bottle bends when only its energy counts: it has to be cut out.
    QTest::newRow("bottle") << bottle().mesh() << 5 << 1;
    Model scene = bottle();
    scene.add(moved(bolt(), {4, 0, 0}));
    scene.add(moved(house(), {8, 0, 0}));
    QTest::newRow("bottle, bolt and house") << scene.mesh() << 14 << 6;
}

//! Nothing rigid is stretched, nothing is flipped, the bound holds.
void TestRigid::unwrapped()
{
    QFETCH(const test::MeshPtr, mesh);
    QFETCH(const int, most);
    QFETCH(const int, least);
    Snapshot snapshot;
    snapshot.mesh = mesh;
    const auto regions = regionsOf(mesh);
    QVERIFY(regions);
    for (const unwrap::UnwrapQuality quality :
         {unwrap::UnwrapQuality::Draft, unwrap::UnwrapQuality::Standard}) {
        unwrap::UnwrapOptions options;
        options.quality = quality;
        options.pack = false;
        const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshot, options);
        QVERIFY(result.withinBound);
        const double worst = worstOfRigid(*mesh, *regions, result.uv);
        QVERIFY2(worst < 1.02, qPrintable(QString::number(worst)));
        if (regions->share > 0.999)
            QVERIFY2(result.distortion < 4.0005, qPrintable(QString::number(result.distortion, 'g', 8)));
        const int count = islands(*mesh, result.cut);
        QVERIFY2(count >= least && count <= most, qPrintable(QString::number(count)));
    }
}

void TestRigid::panelsKeepWhatTheyCan_data()
{
    QTest::addColumn<test::MeshPtr>("mesh");
    QTest::addColumn<int>("panels");
    QTest::newRow("flat cushion") << cushion(0.05).mesh() << 6;
    QTest::newRow("cushion") << cushion(0.1).mesh() << 6;
    QTest::newRow("thick cushion") << cushion(0.2).mesh() << 6;
    QTest::newRow("door") << door(0.05, 0).mesh() << 1;
    QTest::newRow("bulging door") << door(0.15, 0).mesh() << 1;
    QTest::newRow("door with a bevel") << door(0.05, 0.04).mesh() << 1;
    QTest::newRow("bulging door with a bevel") << door(0.15, 0.04).mesh() << 1;
}

//! Slightly curved panels have hardly more stretch in a map than when they are laid in the plane alone, and
//! still hang together.
void TestRigid::panelsKeepWhatTheyCan()
{
    QFETCH(const test::MeshPtr, mesh);
    QFETCH(const int, panels);
    const auto regions = regionsOf(mesh);
    QVERIFY(regions);
    QCOMPARE(static_cast<int>(std::count(regions->curved.begin(), regions->curved.end(), true)), panels);
    const std::shared_ptr<const Soup> soup = Soup::build(mesh);
    const rigid::Unrolled alone = rigid::unroll(*soup, *regions);
    Snapshot snapshot;
    snapshot.mesh = mesh;
    for (const unwrap::UnwrapQuality quality :
         {unwrap::UnwrapQuality::Draft, unwrap::UnwrapQuality::Standard}) {
        unwrap::UnwrapOptions options;
        options.quality = quality;
        options.pack = false;
        const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshot, options);
        QVERIFY(result.withinBound);
        QVERIFY(islands(*mesh, result.cut) <= 4);
        SeamedMap map = *seamedMapOf(*soup, result.uv, result.cut);
        double size = 0; // of the map, beside the model
        for (int t = 0; t < mesh->triangleCount(); ++t)
            size += soup->weight[t] * jacobianDeterminant(*soup, map.x.data(), t);
        for (double &coordinate : map.x)
            coordinate /= std::sqrt(size);
        std::vector<double> here(regions->count, 0), least(regions->count, 0), area(regions->count, 0);
        for (int t = 0; t < mesh->triangleCount(); ++t) {
            const int r = regions->region[t];
            if (r < 0 || !regions->curved[r])
                continue;
            here[r] += soup->weight[t] * rigid::excessOf(*soup, map.x, t);
            least[r] += soup->weight[t] * alone.excess[t];
            area[r] += soup->weight[t];
        }
        for (int r = 0; r < regions->count; ++r) {
            const QString figures = QStringLiteral("%1 alone, %2 in the map").arg(least[r]).arg(here[r]);
            QVERIFY2(here[r] <= 2 * least[r] + 2e-4 * area[r], qPrintable(figures));
        }
    }
}

//! A panel that ends at a bevel, not at a crease, counts only on models made of such panels.
void TestRigid::smoothBodiesStayWhole()
{
    const auto hasPanels = [](const test::MeshPtr &mesh) {
        const auto regions = regionsOf(mesh);
        return regions &&
               std::find(regions->curved.begin(), regions->curved.end(), true) != regions->curved.end();
    };
    QVERIFY(hasPanels(door(0.15, 0.04).mesh()));
    QVERIFY(!hasPanels(door(0.15, 0.04, 0.5).mesh()));
    QVERIFY(hasPanels(door(0.15, 0, 0.5).mesh()));
}

void TestRigid::alignedIslandsKeepTheirShape_data()
{
    QTest::addColumn<test::MeshPtr>("mesh");
    QTest::newRow("bolt") << bolt().mesh();
    QTest::newRow("bottle") << bottle().mesh();
    QTest::newRow("stairs") << stairs(8).mesh();
    QTest::newRow("table") << table().mesh();
}

//! What is straight on the model is made straight in the curved parts only.
void TestRigid::alignedIslandsKeepTheirShape()
{
    QFETCH(const test::MeshPtr, mesh);
    Snapshot snapshot;
    snapshot.mesh = mesh;
    snapshot.settings.align = CreaseMode::On;
    unwrap::UnwrapOptions options;
    options.quality = unwrap::UnwrapQuality::Draft;
    options.pack = false;
    const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshot, options);
    QVERIFY(result.withinBound);
    const double worst = worstOfRigid(*mesh, *regionsOf(mesh), result.uv);
    QVERIFY2(worst < 1.02, qPrintable(QString::number(worst)));
}

//! FlatMode::Free bends a cylinder's ends into its side, with shorter seams.
void TestRigid::freeIsAsBefore()
{
    Snapshot snapshot;
    snapshot.mesh = column(32, 1, 1, 3).mesh();
    snapshot.settings.flat = FlatMode::Free;
    unwrap::UnwrapOptions options;
    options.pack = false;
    const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshot, options);
    QCOMPARE(islands(*snapshot.mesh, result.cut), 1);
    QVERIFY(worstOfRigid(*snapshot.mesh, *regionsOf(snapshot.mesh), result.uv) > 1.1);
}

void TestRigid::lambdaIsThePapers()
{
    Snapshot snapshot;
    snapshot.mesh = column(12, 1, 1, 3).mesh();
    unwrap::UnwrapOptions options;
    options.lambda = 0.3;
    options.quality = unwrap::UnwrapQuality::Draft;
    options.pack = false;
    const UvMatrix rigid = unwrap::unwrapMesh(snapshot, options).uv;
    snapshot.settings.flat = FlatMode::Free;
    QVERIFY(unwrap::unwrapMesh(snapshot, options).uv == rigid);
}

//! A map within the bound by its stiffness is within it without, too.
void TestRigid::stiffnessLeavesTheBound()
{
    Model mixed = box({0, 0, 0}, {2, 2, 2});
    mixed.add(moved(sphere(8, 1), {5, 0, 0}));
    const test::MeshPtr mesh = mixed.mesh();
    const auto regions = regionsOf(mesh);
    QVERIFY(regions);
    double least = 1e9;
    for (const double factor : regions->stiffness)
        least = std::min(least, factor);
    QVERIFY(least >= 1);
}

QTEST_APPLESS_MAIN(TestRigid)

} // namespace tst_rigid

#include "tst_rigid.moc"
