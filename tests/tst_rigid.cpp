// Flat faces, and what unrolls without stretch, keep their shape: how regions are found, and what an unwrap
// makes of them.
#include "solver/preference/creases.h"
#include "solver/rigid/stiffregions.h"
#include "solver/unwrap/unwrap.h"
#include "support/meshbuilders.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace autocuts;

namespace {

using Points = std::vector<Vec3>;
using Faces = std::vector<std::vector<int>>;

struct Model
{
    Points points;
    Faces faces;

    void add(const Model &other)
    {
        const int first = static_cast<int>(points.size());
        points.insert(points.end(), other.points.begin(), other.points.end());
        for (std::vector<int> face : other.faces) {
            for (int &vertex : face)
                vertex += first;
            faces.push_back(std::move(face));
        }
    }
    test::MeshPtr mesh() const { return test::polygonMesh(points, faces); }
};

Model box(const Vec3 &low, const Vec3 &size)
{
    Model model;
    for (int i = 0; i < 8; ++i)
        model.points.push_back(low + Vec3(i & 1 ? size.x() : 0, i & 2 ? size.y() : 0, i & 4 ? size.z() : 0));
    model.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return model;
}

//! A column with a regular polygon for its ends: a prism, and with many sides a cylinder. \param top radius
//! there; 0: a pyramid, or a cone
Model column(int sides, double bottom, double top, double height, int rows = 1)
{
    Model model;
    for (int row = 0; row <= rows; ++row) {
        const double share = double(row) / rows, radius = bottom + share * (top - bottom);
        if (radius == 0) {
            model.points.push_back({0, 0, height});
            break;
        }
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            model.points.push_back({radius * std::cos(angle), radius * std::sin(angle), share * height});
        }
    }
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < sides; ++i) {
            const int a = row * sides + i, b = row * sides + (i + 1) % sides;
            if (row + 1 == rows && top == 0)
                model.faces.push_back({a, b, rows * sides});
            else
                model.faces.push_back({a, b, b + sides, a + sides});
        }
    }
    std::vector<int> low, high;
    for (int i = 0; i < sides; ++i) {
        low.push_back(sides - 1 - i);
        high.push_back(rows * sides + i);
    }
    model.faces.push_back(low);
    if (top > 0)
        model.faces.push_back(high);
    return model;
}

Model house()
{
    Model model;
    model.points = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0},     {0, 0, 2},
                    {4, 0, 2}, {4, 3, 2}, {0, 3, 2}, {0, 1.5, 3.2}, {4, 1.5, 3.2}};
    model.faces = {{3, 2, 1, 0},    {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 9, 5},
                   {3, 0, 4, 8, 7}, {4, 5, 9, 8}, {6, 7, 8, 9}};
    return model;
}

//! Steps between two walls.
Model stairs(int steps)
{
    Model model;
    std::vector<int> left, right;
    const auto point = [&](double x, double z) {
        model.points.push_back({x, 0, z});
        model.points.push_back({x, 3, z});
        left.push_back(static_cast<int>(model.points.size()) - 2);
        right.push_back(static_cast<int>(model.points.size()) - 1);
    };
    point(0, 0);
    for (int i = 0; i < steps; ++i) {
        point(i, i + 1);
        point(i + 1, i + 1);
    }
    point(steps, 0);
    const int count = static_cast<int>(left.size());
    for (int i = 0; i < count; ++i) {
        const int next = (i + 1) % count;
        model.faces.push_back({left[i], right[i], right[next], left[next]});
    }
    model.faces.push_back({left.rbegin(), left.rend()});
    model.faces.push_back(right);
    for (std::vector<int> &face : model.faces)
        std::reverse(face.begin(), face.end());
    return model;
}

//! Boards on two uprights, as separate parts.
Model shelf()
{
    Model model = box({0, 0, 0}, {0.1, 1, 4});
    model.add(box({3, 0, 0}, {0.1, 1, 4}));
    for (int i = 0; i < 4; ++i)
        model.add(box({0.1, 0, 0.5 + i}, {2.9, 1, 0.1}));
    return model;
}

//! A sphere of quads with triangles at its poles.
Model sphere(int rows, double radius)
{
    Model model;
    const int columns = 2 * rows;
    model.points.push_back({0, 0, -radius});
    for (int r = 1; r < rows; ++r) {
        const double up = std::numbers::pi * r / rows;
        for (int c = 0; c < columns; ++c) {
            const double angle = 2 * std::numbers::pi * c / columns;
            model.points.push_back(
                radius * Vec3(std::sin(up) * std::cos(angle), std::sin(up) * std::sin(angle), -std::cos(up)));
        }
    }
    model.points.push_back({0, 0, radius});
    const int last = static_cast<int>(model.points.size()) - 1;
    for (int c = 0; c < columns; ++c) {
        const int next = (c + 1) % columns;
        model.faces.push_back({0, 1 + next, 1 + c});
        for (int r = 0; r + 2 < rows; ++r)
            model.faces.push_back({1 + r * columns + c, 1 + r * columns + next, 1 + (r + 1) * columns + next,
                                   1 + (r + 1) * columns + c});
        model.faces.push_back({last, 1 + (rows - 2) * columns + c, 1 + (rows - 2) * columns + next});
    }
    return model;
}

Model moved(Model model, const Vec3 &by)
{
    for (Vec3 &point : model.points)
        point += by;
    return model;
}

std::shared_ptr<const RigidRegions> regionsOf(const test::MeshPtr &mesh)
{
    return rigid::rigidRegions(mesh, preference::creases(*mesh, preference::dihedralAngles(*mesh)));
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
#include "tst_rigid.moc"
