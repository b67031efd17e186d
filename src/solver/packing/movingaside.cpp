#include "solver/packing/movingaside.h"

#include "model/plain/udimtiles.h"
#include "solver/packing/layoutcheck.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::packing {

namespace {

// Numbers in this file without another source were chosen by hand.

//! A distance to try, and the distance to others that a place there must keep, in gutters. Near places with
//! room come first, then nearer ones with less room.
struct Try
{
    double way, clearance;
};
constexpr Try nearTries[] = {{1, 1}, {1.5, 1}, {2, 1}, {3, 1}, {4, 1}, {0.5, 0.25}, {0.25, 0.125}};
//! Farther places are tried at distances that grow by this factor.
constexpr double growth = 1.5;
constexpr int directions = 16;

std::vector<Try> triesUpTo(double farthest)
{
    std::vector<Try> tries(std::begin(nearTries), std::end(nearTries));
    for (double way = 6; way <= farthest; way *= growth)
        tries.push_back({way, 1});
    return tries;
}

//! Unit vectors all around, the nearest to the given one first.
std::vector<Vec2> directionsFrom(const Vec2 &first)
{
    const double start = first.norm() > 0 ? std::atan2(first.y(), first.x()) : 0;
    std::vector<Vec2> result;
    for (int i = 0; i < directions; ++i) {
        const int steps = i % 2 == 0 ? -i / 2 : (i + 1) / 2;
        const double angle = start + steps * 2 * std::numbers::pi / directions;
        result.emplace_back(std::cos(angle), std::sin(angle));
    }
    return result;
}

//! The tile of the texture that contains the box; empty when it lies in several.
Eigen::AlignedBox2d tileOf(const Eigen::AlignedBox2d &box, double tileHeight)
{
    const Eigen::AlignedBox2d tile = tileAt(box.min(), tileHeight);
    return tile.contains(box) ? tile : Eigen::AlignedBox2d();
}

//! True when a point of the island, the first of the problem, lies inside an obstacle. Rules out most places
//! much faster than the exact test.
bool hitsObstacle(const PackProblem &problem, const std::vector<Eigen::AlignedBox2d> &boxes,
                  const Vec2 &place)
{
    for (const Vec2 &p : problem.outlines[0].points) {
        const Vec2 q = p + place;
        for (std::size_t i = 1; i < boxes.size(); ++i) {
            if (boxes[i].contains(q) && problem.outlines[i].windingAt(q - problem.given[i].position) != 0)
                return true;
        }
    }
    return false;
}

} // namespace

AsideMover::AsideMover(std::vector<PackIsland> islands, double gutter, double tileHeight)
    : mIslands(std::move(islands)), mBoxes(mIslands.size()), mWays(mIslands.size(), Vec2::Zero()),
      mOutlines(mIslands.size()), mGutter(gutter), mTileHeight(tileHeight)
{
    for (std::size_t i = 0; i < mIslands.size(); ++i) {
        for (const Vec2 &p : mIslands[i].points) {
            if (isUsablePoint(p))
                mBoxes[i].extend(p);
        }
    }
}

Eigen::AlignedBox2d AsideMover::boxOf(int island) const
{
    return mBoxes[island].translated(mWays[island]);
}

const Outline &AsideMover::outlineOf(int island)
{
    if (!mOutlines[island])
        mOutlines[island] = makeOutline(mIslands[island], 1);
    return *mOutlines[island];
}

//! The island, as the first and only movable one, and all obstacles within reach.
PackProblem AsideMover::problemAround(int island, double reach)
{
    const Eigen::AlignedBox2d box = boxOf(island);
    const Vec2 room = Vec2::Constant(2 * reach);
    Eigen::AlignedBox2d bounds(Vec2(box.min() - room), Vec2(box.max() + room));
    PackProblem problem;
    const auto add = [&](int i) {
        problem.outlines.push_back(outlineOf(i));
        problem.locked.push_back(i != island);
        problem.given.push_back({0, outlineOf(i).centre + mWays[i]});
        bounds.extend(boxOf(i));
    };
    add(island);
    for (int i = 0; i < static_cast<int>(mIslands.size()); ++i) {
        if (i != island && !mBoxes[i].isEmpty() && areNear(box, boxOf(i), reach + mGutter))
            add(i);
    }
    if (const Eigen::AlignedBox2d tile = tileOf(box, mTileHeight); !tile.isEmpty())
        bounds = tile;
    problem.lower = bounds.min();
    problem.upper = bounds.max();
    return problem;
}

std::optional<Vec2> AsideMover::moveAside(int island, const Vec2 &direction, const JobContext &job)
{
    if (mBoxes[island].isEmpty() || outlineOf(island).points.empty())
        return std::nullopt;
    const double size = mBoxes[island].diagonal().norm();
    const std::vector<Try> tries = triesUpTo(size / mGutter);
    PackProblem problem = problemAround(island, std::max(size, 4 * mGutter));
    std::vector<Eigen::AlignedBox2d> boxes(problem.outlines.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (const Vec2 &p : problem.outlines[i].points)
            boxes[i].extend(Vec2(p + problem.given[i].position));
    }
    Layout layout{problem.unit, problem.given};
    WorkMeter work(0);
    for (const Try &t : tries) {
        problem.gutter = t.clearance * mGutter;
        for (const Vec2 &unit : directionsFrom(direction)) {
            if (job.stopped())
                return std::nullopt;
            const Vec2 way = t.way * mGutter * unit;
            layout.poses[0].position = problem.given[0].position + way;
            if (!hitsObstacle(problem, boxes, layout.poses[0].position) &&
                isValidLayout(problem, layout, work)) {
                mWays[island] += way;
                return way;
            }
        }
    }
    return std::nullopt;
}

} // namespace autocuts::packing
