#include "model/document/makesnapshot.h"

#include "model/document/document.h"
#include "model/document/straightloops.h"
#include "model/plain/uvlayout.h"

#include <algorithm>

namespace autocuts {

namespace {

int faceOfCorner(const MeshData &mesh, int corner)
{
    const auto next = std::upper_bound(mesh.faceStart.begin(), mesh.faceStart.end(), corner);
    return static_cast<int>(next - mesh.faceStart.begin()) - 1;
}

//! The flags of all faces. Faces without UVs have no place that a lock, a stack or a group could hold.
std::vector<IslandFlags> flagsOfPlaced(const Document &document)
{
    std::vector<IslandFlags> flags = document.state().marks.faceFlags;
    const MeshData &mesh = document.mesh();
    for (std::size_t face = 0; face < flags.size(); ++face) {
        const int first = mesh.faceStart[face], end = mesh.faceStart[face + 1];
        if (!document.uv().middleRows(first, end - first).allFinite())
            flags[face].locked = flags[face].stack = flags[face].group = 0;
    }
    return flags;
}

void addConstraints(Steering &steering, const Document &document)
{
    const MeshData &mesh = document.mesh();
    const double toSolver = 1 / document.uvScale();
    for (const UvPin &pin : document.constraints().pins) {
        for (int s : mesh.soupCornersOf(faceOfCorner(mesh, pin.corner))) {
            if (mesh.cornerOfSoup(s) == pin.corner)
                steering.pins.push_back({s, toSolver * pin.position, pin.hard, pin.weight});
        }
    }
    for (const LayoutRectangle &rectangle : document.constraints().rectangles) {
        UvRectangle box;
        box.lower = toSolver * rectangle.lower;
        box.upper = toSolver * rectangle.upper;
        box.hard = rectangle.hard;
        box.weight = rectangle.weight;
        for (int face : rectangle.faces) {
            const auto own = mesh.soupCornersOf(face);
            box.soupCorners.insert(box.soupCorners.end(), own.begin(), own.end());
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
    snapshot.mesh = document.weightedMesh();
    snapshot.settings = state.solveSettings;
    snapshot.settings.start = start.value_or(snapshot.settings.start);
    Steering &steering = snapshot.editSteering();
    steering.pairState = state.seams.states;
    steering.pairWeight = state.seams.weights;
    steering.givenSeams = document.givenSeams();
    steering.straightLoops = straightLoops(document);
    steering.faceFlags = flagsOfPlaced(document);
    addConstraints(steering, document);
    snapshot.token = document.token();
    snapshot.uvScale = document.uvScale();
    snapshot.tileHeight = state.packingSettings.tileHeight();
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
