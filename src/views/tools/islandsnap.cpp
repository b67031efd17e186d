#include "views/tools/islandsnap.h"

#include "model/document/document.h"
#include "model/plain/chart.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

IslandSnap::IslandSnap(const Document &document, const std::vector<int> &moving,
                       const Eigen::AlignedBox2d &start)
    : mStart(start)
{
    const Islands &islands = document.islands();
    std::vector<bool> moves(islands.count());
    Eigen::AlignedBox2d now;
    for (int island : moving) {
        moves[island] = true;
        now.extend(islands.box(island));
    }
    if (now.isEmpty())
        return;
    const PackingSettings &packing = document.packingSettings();
    for (int island = 0; island < islands.count(); ++island) {
        if (!moves[island])
            addSides(islands.box(island), packing.margin / packing.textureSize);
    }
    const Vec2 done = now.min() - start.min();
    const UvTopology topology = findUvTopology(document.mesh(), document.uv());
    for (const UvEdge &edge : topology.uvEdges) {
        if (!edge.open)
            continue;
        const bool itMoves = moves[islands.islandOfFace(document.adjacency().faceOfCorner(edge.corner[0]))];
        for (int corner : edge.corner) {
            const Vec2 place = document.uv().row(corner).transpose();
            (itMoves ? mMoving : mStaying).push_back(itMoves ? Vec2(place - done) : place);
        }
    }
    const auto before = [](const Vec2 &a, const Vec2 &b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    };
    for (std::vector<Vec2> *points : {&mMoving, &mStaying}) {
        std::sort(points->begin(), points->end(), before);
        points->erase(std::unique(points->begin(), points->end()), points->end());
    }
}

void IslandSnap::addSides(const Eigen::AlignedBox2d &box, double margin)
{
    for (int axis = 0; axis < 2; ++axis) {
        const double low = mStart.min()[axis], high = mStart.max()[axis];
        const double otherLow = box.min()[axis], otherHigh = box.max()[axis];
        for (const Side &side :
             {Side{low, otherLow}, Side{high, otherHigh}, Side{low, otherHigh}, Side{high, otherLow},
              Side{low, otherHigh + margin}, Side{high, otherLow - margin},
              Side{mStart.center()[axis], box.center()[axis]}})
            mSides[axis].push_back(side);
    }
}

bool IslandSnap::snapToCorner(double reach, IslandSnapResult &result) const
{
    double best = reach;
    Vec2 shift = Vec2::Zero();
    for (const Vec2 &point : mMoving) {
        const Vec2 at = point + result.move;
        auto next = std::lower_bound(mStaying.begin(), mStaying.end(), at.x() - best,
                                     [](const Vec2 &p, double u) { return p.x() < u; });
        for (; next != mStaying.end() && next->x() <= at.x() + best; ++next) {
            const double distance = (*next - at).norm();
            if (distance >= best)
                continue;
            best = distance;
            shift = *next - at;
            result.corner = *next;
        }
    }
    result.move += shift;
    return result.corner.has_value();
}

IslandSnapResult IslandSnap::snapped(const Vec2 &move, double reach) const
{
    IslandSnapResult result;
    result.move = move;
    if (snapToCorner(reach, result))
        return result;
    for (int axis = 0; axis < 2; ++axis) {
        double best = reach;
        for (const Side &side : mSides[axis]) {
            const double wanted = side.to - side.from;
            const double distance = std::abs(wanted - move[axis]);
            if (distance >= best)
                continue;
            best = distance;
            result.move[axis] = wanted;
            (axis == 0 ? result.u : result.v) = side.to;
        }
    }
    return result;
}

} // namespace autocuts
