#include "model/transfer/placement.h"

#include <algorithm>

namespace autocuts::transfer {

namespace {

//! Boxes agree when their corners are closer than this share of the diagonal. Chosen by hand.
constexpr double sameBox = 0.1;
constexpr double otherBox = 0.5;

//! Between metres, centimetres, millimetres, inches and feet.
constexpr double unitScales[] = {1,    100,        0.01,     1000,   0.001,      10,    0.1,      0.0254,
                                 2.54, 1 / 0.0254, 1 / 2.54, 0.3048, 1 / 0.3048, 30.48, 1 / 30.48};

struct Box
{
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
};

Vec3 turned(const Vec3 &p, const Placement &placement)
{
    const double sign = placement.turn;
    return placement.scale * (placement.turn == 0 ? p : Vec3(p.x(), sign * p.z(), -sign * p.y()));
}

Box boxOf(const MeshData &mesh)
{
    Box box;
    bool first = true;
    for (const int vertex : mesh.cornerVertex) {
        const Vec3 p = mesh.positions.row(vertex);
        box.low = first ? p : Vec3(box.low.cwiseMin(p));
        box.high = first ? p : Vec3(box.high.cwiseMax(p));
        first = false;
    }
    return box;
}

double mismatch(const Box &box, const Placement &placement, const Box &target)
{
    const Vec3 a = turned(box.low, placement), b = turned(box.high, placement);
    const double size = std::max((target.high - target.low).norm(), 1e-300);
    return ((a.cwiseMin(b) - target.low).norm() + (a.cwiseMax(b) - target.high).norm()) / size;
}

} // namespace

std::vector<Placement> likelyPlacements(const MeshData &mesh, const MeshData &target)
{
    const Box box = boxOf(mesh), wanted = boxOf(target);
    std::vector<std::pair<double, Placement>> found;
    for (const double scale : unitScales) {
        for (const int turn : {0, 1, -1}) {
            const Placement placement{scale, turn};
            const double error = mismatch(box, placement, wanted);
            if (!placement.isIdentity() && error < sameBox)
                found.emplace_back(error, placement);
        }
    }
    std::ranges::stable_sort(found, {}, [](const auto &entry) { return entry.first; });
    std::vector<Placement> result;
    for (const auto &[error, placement] : found)
        result.push_back(placement);
    return result;
}

bool liesElsewhere(const MeshData &mesh, const MeshData &target)
{
    return mismatch(boxOf(mesh), {}, boxOf(target)) > otherBox;
}

std::shared_ptr<const MeshData> placed(const MeshData &mesh, const Placement &placement)
{
    // All numbers of triangles and edges stay.
    auto result = std::make_shared<MeshData>(mesh);
    const double scale = placement.scale;
    for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v)
        result->positions.row(v) = turned(mesh.positions.row(v), placement);
    for (double &area : result->triangleArea)
        area *= scale * scale;
    for (EdgePair &pair : result->edgePairs)
        pair.length *= scale;
    result->area *= scale * scale;
    result->report.area *= scale * scale;
    result->report.boxDiagonal *= scale;
    result->report.distanceFromOrigin *= scale;
    return result;
}

Vec3 turnedOnly(const Vec3 &direction, const Placement &placement)
{
    return turned(direction, {1, placement.turn});
}

} // namespace autocuts::transfer
