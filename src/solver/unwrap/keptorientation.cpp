#include "solver/unwrap/keptorientation.h"

#include "solver/base/rigidfit.h"

#include <algorithm>
#include <cmath>

namespace autocuts::unwrap {

namespace {

//! Radians. Smaller turns are left out, so that charts that were turned rightly keep their bits.
constexpr double smallestTurn = 1e-9;

bool isKept(const PackJob &pack, const std::vector<int> &faces)
{
    const IslandFlags flags = flagsOf(pack.faceFlags, faces);
    const auto stays = [&](int face) { return !pack.stays.empty() && pack.stays[face]; };
    return flags.upright + flags.aligned != 0 && flags.locked == 0 &&
           std::none_of(faces.begin(), faces.end(), stays);
}

} // namespace

void keepOrientations(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                      const UvMatrix &before, UvMatrix &uv)
{
    if (std::none_of(pack.faceFlags.begin(), pack.faceFlags.end(),
                     [](const IslandFlags &flags) { return flags.upright + flags.aligned != 0; }))
        return;
    for (const std::vector<int> &faces : charts.faces()) {
        if (!isKept(pack, faces))
            continue;
        std::vector<PointMatch> matches;
        for (const int face : faces) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
                if (before.row(c).allFinite())
                    matches.push_back({before.row(c).transpose(), uv.row(c).transpose()});
            }
        }
        if (matches.empty())
            continue;
        const RigidMotion motion = fitRigid(matches);
        if (motion.c > 0 && std::abs(motion.s) < smallestTurn)
            continue;
        for (const int face : faces) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                uv.row(c) = motion.turned(uv.row(c).transpose()).transpose();
        }
    }
}

} // namespace autocuts::unwrap
