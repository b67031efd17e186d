#include "figures/mapwork.h"

#include "commands/setseamweights.h"
#include "model/plain/edgeangles.h"
#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "solver/definite/stitching.h"
#include "solver/homotopy/anneal.h"
#include "solver/homotopy/solver.h"
#include "solver/unwrap/unwrap.h"

#include <QTest>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace autocuts::figures {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double sharp = std::numbers::pi / 6;
constexpr double togetherWeight = 100, attractingWeight = 0.1; // painted
constexpr double bandShare = 0.03; // half the width of a painted band, of the width of the model
constexpr double seenFrom = 0.15;  // cosine: faces that are seen at a smaller angle count as hidden

//! Largest of the singular values and their inverses.
double stretchOf(const std::array<Vec3, 3> &p, const std::array<Vec2, 3> &q)
{
    const Vec3 x = (p[1] - p[0]).stableNormalized();
    const Vec3 b = p[2] - p[0];
    const double height = (b - b.dot(x) * x).norm();
    Eigen::Matrix2d model, map;
    model << (p[1] - p[0]).norm(), b.dot(x), 0, height;
    map << q[1] - q[0], q[2] - q[0];
    const Eigen::Vector2d values = Eigen::JacobiSVD<Eigen::Matrix2d>(map * model.inverse()).singularValues();
    return std::max(values[0], 1 / values[1]);
}

double worstStretch(const MeshData &mesh, const UvMatrix &uv, double scale)
{
    double worst = 1;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        std::array<Vec3, 3> p;
        std::array<Vec2, 3> q;
        for (int k = 0; k < 3; ++k) {
            p[k] = mesh.cornerPosition(mesh.cornerOfSoup(3 * t + k));
            q[k] = scale * uv.row(mesh.cornerOfSoup(3 * t + k)).transpose();
        }
        const double stretch = stretchOf(p, q);
        if (std::isfinite(stretch))
            worst = std::max(worst, stretch);
    }
    return worst;
}

//! Where a triangle lies, with the camera so near that it can be clicked.
QPoint nearPlaceOf(StudioPictures &studio, int triangle)
{
    UvView &view = studio.canvases().uv;
    const MeshData &mesh = studio.document().mesh();
    Eigen::AlignedBox2d box;
    Vec2 middle = Vec2::Zero();
    for (int k = 0; k < 3; ++k) {
        const Vec2 place = studio.document().uv().row(mesh.cornerOfSoup(3 * triangle + k));
        box.extend(place);
        middle += place / 3;
    }
    MapCamera camera = view.camera();
    camera.setCentre(middle);
    camera.setScale(0.2 * view.width() / std::max(box.sizes().maxCoeff(), 1e-6));
    view.setCamera(camera);
    QCoreApplication::processEvents();
    return view.camera().toScreen(middle).toPoint();
}

Snapshot snapshotOf(const Scene &scene)
{
    Snapshot snapshot;
    snapshot.mesh = scene.mesh;
    return snapshot;
}

//! The scene with these UVs, moved and scaled into the first tile.
Scene withMap(Scene scene, UvMatrix uv)
{
    const Eigen::AlignedBox2d box = layoutBox(uv);
    const double scale = 0.96 / box.sizes().maxCoeff();
    const Eigen::RowVector2d centre = box.center();
    uv = (scale * (uv.rowwise() - centre)).rowwise() + Eigen::RowVector2d(0.5, 0.5);
    scene.uvSets = {{u"UVMap"_s, uv}};
    return scene;
}

//! Gives all edges that are chosen a painted weight.
template <class Choose>
void paint(Document &document, double weight, Choose choose)
{
    const MeshData &mesh = document.mesh();
    IndexRanges pairs;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        if (choose(mesh.edgePairs[e])) {
            pairs.append(static_cast<int>(2 * e));
            pairs.append(static_cast<int>(2 * e + 1));
        }
    }
    const std::vector<double> weights(pairs.count(), weight);
    pushCommand(std::make_unique<SetSeamWeights>(document, pairs, weights));
}

} // namespace

Scene withSoupMap(Scene scene, double lambda)
{
    const Snapshot snapshot = snapshotOf(scene);
    homotopy::Solver solver;
    solver.load(snapshot);
    homotopy::annealSoup(solver, {.lambda = lambda}, {});
    const SeamedMap map = definite::stitchSoup(solver.sharedSoup(), solver.snapshot(), solver.coordinates());
    return withMap(std::move(scene), cornerUv(solver.soup(), map));
}

Scene withOverlaps(Scene scene)
{
    unwrap::UnwrapOptions options;
    options.quality = unwrap::UnwrapQuality::Draft;
    options.allowOverlaps = true;
    const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshotOf(scene), options);
    return withMap(std::move(scene), result.uv);
}

MapNumbers numbersOf(StudioPictures &studio)
{
    const metrics::UvMetrics &metrics = studio.canvases().map.figures()->metrics;
    const Document &document = studio.document();
    MapNumbers numbers;
    numbers.distortion = metrics.symDirichlet;
    numbers.seamLength = metrics.seamNorm;
    numbers.islands = metrics.charts;
    numbers.overlaps = metrics.overlapPairs;
    for (int island = 0; island < document.islands().count(); ++island)
        numbers.singleTriangles += document.islands().faces(island).size() == 1;
    numbers.worstStretch = worstStretch(document.mesh(), document.uv(), metrics.symDirichletScale);
    return numbers;
}

Column columnOf(StudioPictures &studio, const QString &title, const Look &look, const QSize &size)
{
    const MapNumbers n = numbersOf(studio);
    const ViewOptions before = studio.options();
    Column column;
    if (before.pattern == Pattern::Checker)
        studio.options().checkerSize = fittingCheckerSize(studio.document().mesh(), studio.document().uv());
    column.pictures.push_back(studio.model(size, look));
    studio.options().pattern = Pattern::None;
    column.pictures.push_back(studio.map(size));
    studio.options() = before;
    column.title = title;
    column.lines << u"D %1, seam length %2"_s.arg(n.distortion, 0, 'f', 3).arg(n.seamLength, 0, 'f', 2)
                 << u"islands: %1, overlaps: %2"_s.arg(n.islands).arg(n.overlaps);
    return column;
}

int dragRegionsAway(StudioPictures &studio, int most)
{
    test::Canvases &canvases = studio.canvases();
    canvases.tools.setTool(u"region"_s);
    int drags = 0;
    for (; drags < most && !canvases.map.figures()->overlapPairs.empty(); ++drags) {
        const Document &document = studio.document();
        const QPoint place = nearPlaceOf(studio, canvases.map.figures()->overlapPairs.front()[0]);
        canvases.select(SelectionMode::Faces);
        QTest::mouseClick(&canvases.uv, Qt::LeftButton, {}, place);
        if (!QTest::qWaitFor([&] { return !document.selection().faces.isEmpty(); }, 5000))
            break;
        Eigen::AlignedBox2d region;
        for (const int face : document.selection().faces) {
            for (int c = document.mesh().faceStart[face]; c < document.mesh().faceStart[face + 1]; ++c)
                region.extend(Vec2(document.uv().row(c)));
        }
        const double way = layoutBox(document.uv()).max().x() + 0.02 - region.min().x();
        const double pixels = way * canvases.uv.camera().scale();
        test::Canvases::drag(canvases.uv, {place, place + QPoint(static_cast<int>(pixels), 0)});
        studio.rest();
    }
    canvases.tools.setTool(u"select"_s);
    return drags;
}

void keepSeenTogether(Document &document, const Look &look)
{
    const MeshData &mesh = document.mesh();
    const double yaw = look.yaw * std::numbers::pi / 180, pitch = look.pitch * std::numbers::pi / 180;
    const Vec3 toEye(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
    const auto isSeen = [&](int t) {
        std::array<Vec3, 3> p;
        for (int k = 0; k < 3; ++k)
            p[k] = mesh.cornerPosition(mesh.cornerOfSoup(3 * t + k));
        return (p[1] - p[0]).cross(p[2] - p[0]).stableNormalized().dot(toEye) > seenFrom;
    };
    paint(document, togetherWeight,
          [&](const EdgePair &edge) { return isSeen(edge.triangle[0]) && isSeen(edge.triangle[1]); });
}

void attractCutsToMiddle(Document &document)
{
    const MeshData &mesh = document.mesh();
    const Eigen::VectorXd x = mesh.positions.col(0);
    const double middle = 0.5 * (x.minCoeff() + x.maxCoeff());
    const double reach = bandShare * (x.maxCoeff() - x.minCoeff());
    const auto isNear = [&](int soupCorner) {
        return std::abs(mesh.cornerPosition(mesh.cornerOfSoup(soupCorner)).x() - middle) < reach;
    };
    paint(document, attractingWeight,
          [&](const EdgePair &edge) { return isNear(edge.corner[0][0]) && isNear(edge.corner[1][0]); });
}

double shareOnSharpEdges(const Document &document)
{
    const MeshData &mesh = document.mesh();
    const std::vector<bool> open = openCornerPairs(mesh, document.uv());
    const std::vector<double> angles = edgeAngles(mesh);
    double all = 0, onSharp = 0;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        if (!open[2 * e] && !open[2 * e + 1])
            continue;
        all += mesh.edgePairs[e].length;
        onSharp += angles[e] > sharp ? mesh.edgePairs[e].length : 0;
    }
    return all > 0 ? onSharp / all : 0;
}

int componentsOf(const MeshData &mesh)
{
    std::vector<int> root(mesh.triangleCount());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int t) {
        while (root[t] != t)
            t = root[t] = root[root[t]];
        return t;
    };
    int components = mesh.triangleCount();
    for (const EdgePair &pair : mesh.edgePairs) {
        const int a = find(pair.triangle[0]), b = find(pair.triangle[1]);
        components -= a != b;
        root[a] = b;
    }
    return components;
}

} // namespace autocuts::figures
