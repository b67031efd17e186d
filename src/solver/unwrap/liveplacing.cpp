#include "solver/unwrap/liveplacing.h"

#include "solver/base/cornerat.h"
#include "solver/base/rigidfit.h"
#include "solver/definite/seamopening.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts::unwrap {

namespace {

//! Where a chart without a place before is put, so that it counts as outside of its bin. Texture space.
constexpr double nowhere = 1e3;

double areaOf(const MeshData &mesh, const UvMatrix &uv)
{
    double area = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const auto &[a, b, c] = mesh.triangles[t];
        area += 0.5 * cross2(Vec2(uv.row(a)), Vec2(uv.row(b)), Vec2(uv.row(c)));
    }
    return area;
}

//! The motion with an angle that is allowed.
RigidMotion limited(RigidMotion motion, PackRotation turns)
{
    if (turns == PackRotation::Free)
        return motion;
    const bool upright = turns == PackRotation::None || std::abs(motion.c) >= std::abs(motion.s);
    motion.c = turns == PackRotation::None ? 1 : upright ? std::copysign(1.0, motion.c) : 0;
    motion.s = upright ? 0 : std::copysign(1.0, motion.s);
    motion.shift = motion.fixedCentre - motion.turned(motion.movingCentre);
    return motion;
}

//! Makes islands larger whose rectangles have become much larger than they are.
void growIntoRectangles(const MeshData &mesh, const ChartMap &charts, PackJob pack, UvMatrix &uv)
{
    constexpr double leastGain = 1.1; // of the area; less is not worth that islands move
    pack.fillRectangles = true;
    UvMatrix larger = uv;
    if (packCharts(mesh, charts, pack, larger) && areaOf(mesh, larger) > leastGain * areaOf(mesh, uv))
        uv = std::move(larger);
}

} // namespace

void LivePlacing::beginWith(const FreePart &part)
{
    const Snapshot &own = part.snapshot();
    mBefore.reset();
    if (own.uv)
        mBefore = Before{own.mesh, *own.uv, findCharts(*own.mesh, *own.uv), own.uvScale};
}

void LivePlacing::returnTo(const FreePart &part, const UvMatrix &uv)
{
    const MeshData &mesh = *part.snapshot().mesh;
    const double scale = mBefore ? mBefore->scale : part.snapshot().uvScale;
    mBefore = Before{part.snapshot().mesh, uv, findCharts(mesh, uv), scale};
}

//! Moves every chart that is not held onto the place of the old chart that it has most in common with.
UvMatrix LivePlacing::atOldPlaces(const MeshData &mesh, const ChartMap &charts, const std::vector<bool> &held,
                                  const UvMatrix &uv, PackRotation turns) const
{
    const std::vector<std::vector<int>> faces = charts.faces();
    UvMatrix placed = uv;
    for (int chart = 0; chart < charts.count; ++chart) {
        if (!held.empty() && held[chart])
            continue;
        std::map<int, std::pair<double, std::vector<PointMatch>>> byOldChart; // area, points
        for (const int face : faces[chart]) {
            auto &[area, points] = byOldChart[mBefore->charts.faceChart[face]];
            const int first = mesh.faceStart[face], last = mesh.faceStart[face + 1];
            double own = 0;
            for (int c = first + 1; c + 1 < last; ++c)
                own += 0.5 * cross2(Vec2(uv.row(first)), Vec2(uv.row(c)), Vec2(uv.row(c + 1)));
            area += own;
            for (int c = first; c < last && mBefore->uv.row(c).allFinite(); ++c)
                points.push_back(
                    {mBefore->uv.row(c).transpose(), uv.row(c).transpose(), std::max(own, 1e-12)});
        }
        byOldChart.erase(-1);
        const auto most =
            std::max_element(byOldChart.begin(), byOldChart.end(),
                             [](const auto &a, const auto &b) { return a.second.first < b.second.first; });
        RigidMotion motion;
        if (most != byOldChart.end() && !most->second.second.empty())
            motion = limited(fitRigid(most->second.second), turns);
        else
            motion.shift = Vec2::Constant(nowhere);
        for (const int face : faces[chart]) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                placed.row(c) = motion(uv.row(c).transpose()).transpose();
        }
    }
    return placed;
}

UvMatrix LivePlacing::place(const Snapshot &snapshot, const FreePart &part, const Soup &soup,
                            const SeamedMap &map, const packing::PackOptions &options, bool afresh,
                            PackRotation turns)
{
    const Snapshot own = part.withoutRectangles();
    // True when some islands are where they belong, so that the scale is given.
    const bool stays = !part.isWhole() || snapshot.placesIslands();
    if (afresh && !stays)
        mBefore.reset();
    else if (!mBefore || !samePolygons(*mBefore->mesh, *own.mesh))
        beginWith(part);
    const MeshData &mesh = *own.mesh;
    const CutMesh state(mesh, map.cut);
    const ChartMap charts = chartsOf(mesh, state);
    UvMatrix shape = cornerUv(soup, map);
    definite::openCuts(own, shape);
    PackJob pack = steeredPackJob(snapshot, options);
    pack.options.effort = std::min(pack.options.effort, packing::hurriedEffort);
    pack.options.keepScale = false;
    pack.keepScaleIfPossible = stays || mBefore;
    pack.hurry = PackHurry::WhenStopped;
    const ChartMap whole = part.wholeCharts(charts);
    UvMatrix uv;
    mHadRoom = true;
    if (!mBefore) {
        uv = part.wholeUv((stays ? own.uvScale : 1) * shape);
        mHadRoom = packCharts(*snapshot.mesh, whole, pack, uv);
    } else {
        const double scale = stays ? own.uvScale : mBefore->scale;
        uv = part.wholeUv(atOldPlaces(mesh, charts, heldCharts(own, state), scale * shape, turns));
        const std::vector<bool> misplaced = misplacedFaces(*snapshot.mesh, whole, pack, uv);
        if (std::find(misplaced.begin(), misplaced.end(), true) != misplaced.end()) {
            PackJob around = pack;
            for (std::size_t face = 0; face < misplaced.size(); ++face)
                around.stays[face] = around.stays[face] || !misplaced[face];
            around.options.keepScale = true;
            if (!packCharts(*snapshot.mesh, whole, around, uv))
                mHadRoom = packCharts(*snapshot.mesh, whole, pack, uv);
        } else if (onlyRectangles(pack)) {
            growIntoRectangles(*snapshot.mesh, whole, pack, uv);
        }
    }
    Before before{own.mesh, part.partUv(uv), charts, own.uvScale};
    if (!stays)
        before.scale = std::sqrt(areaOf(mesh, before.uv) / areaOf(mesh, shape));
    mBefore = std::move(before);
    return uv;
}

} // namespace autocuts::unwrap
