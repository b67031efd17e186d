#include "model/document/makesnapshot.h"

#include "model/document/document.h"
#include "model/plain/uvlayout.h"

namespace autocuts {

namespace {

//! For every corner, its soup corners in ascending order.
std::vector<std::vector<int>> soupCornersByCorner(const MeshData &mesh)
{
    std::vector<std::vector<int>> result(mesh.cornerCount());
    for (int s = 0; s < mesh.soupCornerCount(); ++s)
        result[mesh.cornerOfSoup(s)].push_back(s);
    return result;
}

void addConstraints(Steering &steering, const Document &document)
{
    const MeshData &mesh = document.mesh();
    const double toSolver = 1 / document.uvScale();
    const auto soupCorners = soupCornersByCorner(mesh);
    for (const UvPin &pin : document.constraints().pins) {
        for (int s : soupCorners[pin.corner])
            steering.pins.push_back({s, toSolver * pin.position, pin.hard, pin.weight});
    }
    for (const LayoutRectangle &rectangle : document.constraints().rectangles) {
        UvRectangle box;
        box.lower = toSolver * rectangle.lower;
        box.upper = toSolver * rectangle.upper;
        box.hard = rectangle.hard;
        box.weight = rectangle.weight;
        for (int face : rectangle.faces) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                box.soupCorners.insert(box.soupCorners.end(), soupCorners[c].begin(), soupCorners[c].end());
        }
        if (!box.soupCorners.empty())
            steering.rectangles.push_back(std::move(box));
    }
}

} // namespace

bool hasUvs(const Document &document)
{
    const UvMatrix &uv = document.uv();
    for (Eigen::Index i = 0; i < uv.rows(); ++i) {
        if (uv.row(i).allFinite())
            return true;
    }
    return false;
}

Snapshot makeSnapshot(const Document &document, std::optional<StartMode> start)
{
    const DocumentState &state = document.state();
    Snapshot snapshot;
    snapshot.mesh = state.scene.mesh;
    snapshot.settings = state.solveSettings;
    snapshot.settings.start = start.value_or(snapshot.settings.start);
    Steering &steering = snapshot.editSteering();
    steering.pairState = state.seams.states;
    steering.pairWeight = state.seams.weights;
    steering.givenSeams = document.givenSeams();
    steering.faceFlags = state.marks.faceFlags;
    addConstraints(steering, document);
    snapshot.token = document.token();
    snapshot.uvScale = document.uvScale();
    snapshot.keepTiles = state.packingSettings.udimTile == PackingSettings::firstTile;
    if (hasUvs(document)) {
        snapshot.uv = std::make_shared<const UvMatrix>(document.uv());
        if (snapshot.settings.start == StartMode::ExistingUv)
            snapshot.startUv =
                std::make_shared<const UvMatrix>(soupUv(*snapshot.mesh, document.uv()) / document.uvScale());
    }
    return snapshot;
}

UvMatrix documentUvs(const Document &document, const UvMatrix &soupUv)
{
    const MeshData &mesh = document.mesh();
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int s = mesh.soupCornerCount() - 1; s >= 0; --s)
        uv.row(mesh.cornerOfSoup(s)) = document.uvScale() * soupUv.row(s);
    return uv;
}

} // namespace autocuts
