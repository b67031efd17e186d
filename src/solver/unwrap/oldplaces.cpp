#include "solver/unwrap/oldplaces.h"

#include "solver/base/rigidfit.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts::unwrap {

namespace {

//! Where a chart without a place before is put. Texture space.
constexpr double nowhere = 1e3;

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

} // namespace

UvMatrix atOldPlaces(const MeshData &mesh, const ChartMap &charts, const std::vector<bool> &held,
                     const OldPlaces &before, PackRotation turns, const UvMatrix &uv)
{
    const std::vector<std::vector<int>> faces = charts.faces();
    UvMatrix placed = uv;
    for (int chart = 0; chart < charts.count; ++chart) {
        if (!held.empty() && held[chart])
            continue;
        std::map<int, std::pair<double, std::vector<PointMatch>>> byOldChart; // area, points
        for (const int face : faces[chart]) {
            auto &[area, points] = byOldChart[before.charts.faceChart[face]];
            const int first = mesh.faceStart[face], last = mesh.faceStart[face + 1];
            double own = 0;
            for (int c = first + 1; c + 1 < last; ++c)
                own += 0.5 * cross2(Vec2(uv.row(first)), Vec2(uv.row(c)), Vec2(uv.row(c + 1)));
            area += own;
            for (int c = first; c < last && before.uv.row(c).allFinite(); ++c)
                points.push_back({before.uv.row(c).transpose(), uv.row(c).transpose(), std::max(own, 1e-12)});
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

} // namespace autocuts::unwrap
