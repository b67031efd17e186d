#include "api/meshinput.h"

#include "api/failure.h"
#include "model/plain/givenseams.h"
#include "model/plain/hardedges.h"
#include "model/plain/texelweights.h"
#include "model/plain/uvlayout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts::api {

namespace {

std::vector<int> faceStarts(const autocuts_mesh &mesh)
{
    constexpr std::size_t most = std::numeric_limits<int>::max();
    std::vector<int> starts{0};
    starts.reserve(mesh.face_count + 1);
    std::size_t corner = 0;
    for (std::size_t face = 0; face < mesh.face_count; ++face) {
        const std::uint32_t size = mesh.face_sizes ? mesh.face_sizes[face] : 3;
        if (size < 3)
            throw badInput("face " + std::to_string(face) + " has fewer than three corners", "Leave it out");
        corner += size;
        if (corner > most)
            throw badInput("the mesh has more than 2^31 corners", "Divide it");
        starts.push_back(static_cast<int>(corner));
    }
    return starts;
}

PositionMatrix positionsOf(const autocuts_mesh &mesh)
{
    PositionMatrix positions(static_cast<Eigen::Index>(mesh.vertex_count), 3);
    for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
        for (int k = 0; k < 3; ++k) {
            const double value = mesh.positions[3 * v + std::size_t(k)];
            if (!(std::abs(value) <= 1e150))
                throw badInput("the position of vertex " + std::to_string(v) +
                                   " is not a number that can be used",
                               "Leave out the faces at it");
            positions(static_cast<Eigen::Index>(v), k) = value;
        }
    }
    return positions;
}

//! Takes the map that is there, in texture space.
void takeUvs(const autocuts_mesh &mesh, Snapshot &snapshot)
{
    const MeshData &data = *snapshot.mesh;
    UvMatrix uv(data.cornerCount(), 2);
    for (Eigen::Index c = 0; c < uv.rows(); ++c)
        uv.row(c) << mesh.uvs[2 * c], mesh.uvs[2 * c + 1] * snapshot.tileHeight;
    snapshot.uvScale = layoutScale(data, uv);
    snapshot.uv = std::make_shared<const UvMatrix>(std::move(uv));
}

void takeLocks(const autocuts_mesh &mesh, Steering &steering)
{
    steering.faceFlags.resize(mesh.face_count);
    for (std::size_t face = 0; face < mesh.face_count; ++face)
        steering.faceFlags[face].locked = mesh.locked_faces[face] != 0;
}

//! For each edge pair of two faces, the corners at which its edge begins in these faces.
template <class Take>
void forEdges(const MeshData &data, Take take)
{
    std::vector<int> next(static_cast<std::size_t>(data.cornerCount()));
    for (int face = 0; face < data.faceCount(); ++face) {
        const int first = data.faceStart[std::size_t(face)], end = data.faceStart[std::size_t(face) + 1];
        for (int c = first; c < end; ++c)
            next[std::size_t(c)] = c + 1 < end ? c + 1 : first;
    }
    for (std::size_t e = 0; e < data.edgePairs.size(); ++e) {
        const EdgePair &pair = data.edgePairs[e];
        if (pair.diagonal)
            continue;
        std::array<std::size_t, 2> corners{};
        for (std::size_t side = 0; side < 2; ++side) {
            const int a = data.cornerOfSoup(pair.corner[0][side]),
                      b = data.cornerOfSoup(pair.corner[1][side]);
            corners[side] = static_cast<std::size_t>(next[std::size_t(a)] == b ? a : b);
        }
        take(e, corners);
    }
}

//! Takes the edges that must, or must not, be seams.
void takeEdges(const autocuts_mesh &mesh, const MeshData &data, Steering &steering)
{
    for (int c = 0; c < data.cornerCount(); ++c) {
        if (mesh.edges[c] > AUTOCUTS_EDGE_JOINED)
            throw badInput("the edge of corner " + std::to_string(c) + " is neither free, a seam nor joined");
    }
    std::vector<PairState> &states = steering.pairState;
    states.assign(std::size_t(data.cornerPairCount()), PairState::Free);
    forEdges(data, [&](std::size_t e, const std::array<std::size_t, 2> &corners) {
        const auto is = [&](autocuts_edge wish) {
            return mesh.edges[corners[0]] == wish || mesh.edges[corners[1]] == wish;
        };
        if (is(AUTOCUTS_EDGE_SEAM) || is(AUTOCUTS_EDGE_JOINED))
            states[2 * e] = states[2 * e + 1] = is(AUTOCUTS_EDGE_SEAM) ? PairState::Cut : PairState::Joined;
    });
}

void takeEdgeWeights(const autocuts_mesh &mesh, const MeshData &data, Steering &steering)
{
    for (int c = 0; c < data.cornerCount(); ++c) {
        if (!(mesh.edge_weights[c] >= 0) || !std::isfinite(mesh.edge_weights[c]))
            throw badInput("the edge weight of corner " + std::to_string(c) +
                           " is not a number that can be used");
    }
    std::vector<double> &weights = steering.pairWeight;
    weights.assign(std::size_t(data.cornerPairCount()), 1);
    forEdges(data, [&](std::size_t e, const std::array<std::size_t, 2> &corners) {
        weights[2 * e] = weights[2 * e + 1] =
            0.5 * (mesh.edge_weights[corners[0]] + mesh.edge_weights[corners[1]]);
    });
}

void takePins(const autocuts_mesh &mesh, Snapshot &snapshot)
{
    const MeshData &data = *snapshot.mesh;
    Steering &steering = snapshot.editSteering();
    for (std::size_t i = 0; i < mesh.pin_count; ++i) {
        const autocuts_pin &pin = mesh.pins[i];
        if (pin.corner >= std::size_t(data.cornerCount()))
            throw badInput("pin " + std::to_string(i) + " is at corner " + std::to_string(pin.corner) +
                           ", out of range: there are " + std::to_string(data.cornerCount()) + " corners");
        if (!std::isfinite(pin.u) || !std::isfinite(pin.v) || !(pin.weight >= 0) ||
            !std::isfinite(pin.weight))
            throw badInput("pin " + std::to_string(i) + " has a number that cannot be used");
        const int corner = static_cast<int>(pin.corner);
        const auto after = std::upper_bound(data.faceStart.begin(), data.faceStart.end(), corner);
        const Vec2 target = Vec2(pin.u, pin.v * snapshot.tileHeight) / snapshot.uvScale;
        for (const int soup : data.soupCornersOf(static_cast<int>(after - data.faceStart.begin()) - 1)) {
            if (data.cornerOfSoup(soup) == corner)
                steering.pins.push_back({soup, target, pin.weight == 0, pin.weight > 0 ? pin.weight : 1});
        }
    }
}

void takeTexelWeights(const autocuts_mesh &mesh, Snapshot &snapshot)
{
    const std::vector<double> weights =
        storedTexelWeights({mesh.texel_weights, mesh.texel_weights + mesh.face_count});
    if (!areTexelWeights(weights, snapshot.mesh->faceCount()))
        throw badInput("a texel weight is out of range", "Use .125 to 8");
    snapshot.mesh = withTexelWeights(snapshot.mesh, weights);
}

void takeGivenSeams(const autocuts_mesh &mesh, Snapshot &snapshot)
{
    std::vector<int> materials;
    if (mesh.face_materials)
        materials.assign(mesh.face_materials, mesh.face_materials + mesh.face_count);
    const std::vector<bool> hard = hardEdgesOf(mesh, *snapshot.mesh);
    Steering &steering = snapshot.editSteering();
    steering.givenSeams = givenSeams({*snapshot.mesh, snapshot.uv.get(), steering.pairState, hard, materials},
                                     snapshot.settings.givenSeams);
}

} // namespace

std::shared_ptr<const MeshData> meshOf(const autocuts_mesh &mesh)
{
    if (mesh.vertex_count > std::size_t(std::numeric_limits<int>::max()))
        throw badInput("the mesh has more than 2^31 vertices", "Divide it");
    if ((!mesh.positions && mesh.vertex_count > 0) || (!mesh.indices && mesh.face_count > 0))
        throw badInput("the arrays of the mesh are missing");
    if (mesh.face_count == 0)
        throw badInput("the mesh has no faces");
    PositionMatrix positions = positionsOf(mesh);
    std::vector<int> starts = faceStarts(mesh);
    std::vector<int> corners;
    corners.reserve(std::size_t(starts.back()));
    for (std::size_t c = 0; c < std::size_t(starts.back()); ++c) {
        if (mesh.indices[c] >= mesh.vertex_count)
            throw badInput("index " + std::to_string(c) + " is " + std::to_string(mesh.indices[c]) +
                           ", out of range: there are " + std::to_string(mesh.vertex_count) + " vertices");
        corners.push_back(static_cast<int>(mesh.indices[c]));
    }
    std::vector<int> objects(mesh.face_count, 0);
    for (std::size_t face = 0; mesh.face_objects && face < mesh.face_count; ++face) {
        objects[face] = mesh.face_objects[face];
        if (objects[face] < 0)
            throw badInput("the object of face " + std::to_string(face) + " is below 0");
    }
    return MeshData::build(std::move(positions), std::move(starts), std::move(corners), std::move(objects));
}

std::vector<bool> hardEdgesOf(const autocuts_mesh &mesh, const MeshData &data)
{
    if (!mesh.normals)
        return {};
    FileShading shading;
    shading.normals = Eigen::Map<const PositionMatrix>(mesh.normals, data.cornerCount(), 3);
    return hardEdges(data, shading);
}

void takeWishes(const autocuts_mesh &mesh, Snapshot &snapshot)
{
    if (mesh.texel_weights)
        takeTexelWeights(mesh, snapshot);
    if (mesh.uvs)
        takeUvs(mesh, snapshot);
    Steering &steering = snapshot.editSteering();
    if (mesh.locked_faces && mesh.uvs)
        takeLocks(mesh, steering);
    if (mesh.edges)
        takeEdges(mesh, *snapshot.mesh, steering);
    if (mesh.edge_weights)
        takeEdgeWeights(mesh, *snapshot.mesh, steering);
    if (mesh.pins)
        takePins(mesh, snapshot);
    if (snapshot.settings.seams != SeamMode::Free)
        takeGivenSeams(mesh, snapshot);
}

} // namespace autocuts::api
