#include "solver/multires/maprefiner.h"

#include "solver/base/constant.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts::multires {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Mean symmetric Dirichlet energy around a point above which its neighbours are moved to make room, and how
//! often at most.
AUTOCUTS_CONSTANT(double, crowded, 8);
constexpr int repairRounds = 6;
//! Largest ratio of new to old seam cost for which straighten() moves a triangle to the other side of a seam,
//! and the greatest symmetric Dirichlet energy that the triangle may have there.
constexpr double straighter = 0.97;
constexpr double roomy = 10;
//! Most passes of straightening seams and number of passes of relaxing points, each time the triangles have
//! doubled.
constexpr int straightenPasses = 20;
AUTOCUTS_CONSTANT(int, sweepsPerLevel, 3);

} // namespace

MapRefiner::MapRefiner(ProgressiveMesh &mesh, double scale) : mMesh(mesh), mScale(scale) {}

int MapRefiner::refineTo(int triangles, const JobContext &job)
{
    int folded = 0;
    int level = 2 * mMesh.triangleCount();
    while (mMesh.triangleCount() < triangles && !mMesh.collapses().empty() && !job.stopped()) {
        folded += !refineOne();
        if (mMesh.triangleCount() >= level || mMesh.collapses().empty()) {
            if (mayStraighten)
                straighten();
            for (int i = 0; i < sweepsPerLevel && !job.stopped(); ++i)
                sweep();
            level *= 2;
        }
    }
    return folded;
}

//! Moves every UV point once to where its triangles are distorted less.
void MapRefiner::sweep()
{
    std::vector<char> done(uv.size(), 0);
    for (int c = 0; c < static_cast<int>(uv.size()); ++c) {
        if (!mMesh.isAlive(c / 3) || done[c])
            continue;
        sectorOf(c);
        for (const int corner : mAround)
            done[corner] = 1;
        improve(c, 2);
    }
}

//! Writes the corners that share a UV point with `corner` to mAround, counter-clockwise.
//! \return true when they form a closed ring
bool MapRefiner::sectorOf(int corner)
{
    mAround.clear();
    int start = corner;
    for (std::size_t steps = 0; !cut[start] && mMesh.across(start) >= 0 && steps < uv.size(); ++steps) {
        start = ProgressiveMesh::next(mMesh.across(start));
        if (start == corner)
            break;
    }
    const bool closed = !cut[start] && mMesh.across(start) >= 0;
    for (int c = start;;) {
        mAround.push_back(c);
        const int side = ProgressiveMesh::previous(c);
        if (cut[side] || mMesh.across(side) < 0)
            break;
        c = mMesh.across(side);
        if (c == start)
            break;
    }
    return closed;
}

//! Moves the UV point of a corner to where its triangles are distorted less. Points on the outline may only
//! move into their own triangles, so that the outline never meets another part of itself.
//! \return the mean symmetric Dirichlet energy around the point
double MapRefiner::improve(int corner, int steps)
{
    const bool closed = sectorOf(corner);
    mPointFan.clear();
    for (const int c : mAround) {
        const int a = ProgressiveMesh::next(c), b = ProgressiveMesh::previous(c);
        addToFan(c / 3, mMesh.position(c), mMesh.position(a), mMesh.position(b), uv[a], uv[b]);
    }
    const double area = mPointFan.area();
    const Vec2 before = uv[corner];
    Vec2 p = before;
    double value = mPointFan.energy(p);
    if (!(area > 0) || !(value < infinite))
        return 0;
    mPointFan.descend(p, value, steps);
    if (!closed && !mPointFan.covers(before, p))
        return mPointFan.energy(before) / area;
    for (const int c : mAround)
        uv[c] = p;
    return value / area;
}

//! Moves a new point and its neighbours while the mean energy around it is too high.
void MapRefiner::makeRoom(int corner)
{
    for (int round = 0; round < repairRounds && improve(corner, descentSteps) > crowded; ++round) {
        const std::vector<int> around = mAround;
        for (const int c : around) {
            improve(ProgressiveMesh::next(c), descentSteps);
            improve(ProgressiveMesh::previous(c), descentSteps);
        }
    }
}

double MapRefiner::costOf(int side) const
{
    const int from = mMesh.point(side), to = mMesh.point(ProgressiveMesh::next(side));
    const double length = (mMesh.pointPosition(from) - mMesh.pointPosition(to)).norm();
    return pointCost.empty() ? length : 0.5 * length * (pointCost[from] + pointCost[to]);
}

//! Shortens seams by moving single triangles to the other side of a seam.
void MapRefiner::straighten()
{
    for (int pass = 0, changed = 1; changed > 0 && pass < straightenPasses; ++pass) {
        changed = 0;
        for (int t = 0; t < static_cast<int>(uv.size()) / 3; ++t)
            changed += mMesh.isAlive(t) && changeBank(t);
    }
}

//! Moves a triangle with seams on two sides across them when that makes the seam cheaper and the triangle
//! fits into the gap there.
bool MapRefiner::changeBank(int triangle)
{
    int open = -1, seams = 0;
    for (int side = 3 * triangle; side < 3 * triangle + 3; ++side) {
        if (mMesh.across(side) < 0)
            return false;
        if (cut[side])
            ++seams;
        else
            open = side;
    }
    if (seams != 2)
        return false;
    // The third side runs from b to a; w is opposite to it.
    const int b = open, a = ProgressiveMesh::next(open), w = ProgressiveMesh::previous(open);
    if (costOf(open) > straighter * (costOf(a) + costOf(w)))
        return false;
    const int acrossA = mMesh.across(a), acrossB = mMesh.across(w); // across a-w and w-b
    const int otherA = ProgressiveMesh::next(acrossA), otherB = acrossB;
    // Both neighbours must be connected at w over uncut sides.
    sectorOf(acrossA);
    if (std::find(mAround.begin(), mAround.end(), ProgressiveMesh::next(acrossB)) == mAround.end() ||
        acrossA / 3 == triangle || acrossB / 3 == triangle)
        return false;
    const Vec2 placeA = uv[otherA], placeB = uv[otherB], placeW = uv[acrossA];
    mPointFan.clear();
    addToFan(triangle, mMesh.position(w), mMesh.position(b), mMesh.position(a), placeB, placeA);
    if (!(mPointFan.energy(placeW) < roomy * mPointFan.area()))
        return false;
    uv[a] = placeA;
    uv[b] = placeB;
    uv[w] = placeW;
    cut[a] = cut[w] = cut[acrossA] = cut[acrossB] = 0;
    cut[open] = cut[mMesh.across(open)] = 1;
    return true;
}

void MapRefiner::addToFan(int triangle, const Vec3 &p, const Vec3 &a3, const Vec3 &b3, const Vec2 &a,
                          const Vec2 &b)
{
    const double scale = mScale * mMesh.texelWeight(triangle);
    mPointFan.add(scale * p, scale * a3, scale * b3, a, b);
}

//! Splits the fan at the cuts that run from the kept point into it.
void MapRefiner::findSectors(const std::vector<int> &fan, bool hasFirst, bool hasLast)
{
    const int count = static_cast<int>(fan.size());
    mSectors.clear();
    for (int i = 0, begin = 0; i < count; ++i) {
        if (i + 1 < count && !cut[ProgressiveMesh::previous(fan[i])])
            continue;
        mSectors.push_back({begin, i + 1, begin == 0 && hasFirst, i + 1 == count && hasLast});
        begin = i + 1;
    }
}

//! The place of the removed point in a sector.
//! \param good set to false when a triangle flips there
Vec2 MapRefiner::placeIn(const Sector &sector, const Comeback &back, bool &good)
{
    const auto next = ProgressiveMesh::next, previous = ProgressiveMesh::previous;
    const std::vector<int> &fan = back.fan;
    const Vec3 removed3 = mMesh.pointPosition(back.removed), kept3 = mMesh.pointPosition(back.kept);
    const Vec2 kept = back.keptUv[sector.begin];
    mPointFan.clear();
    if (sector.hasFirst)
        addToFan(back.triangle[0], removed3, kept3, mMesh.position(next(fan.front())), kept, back.firstEnd);
    for (int i = sector.begin; i < sector.end; ++i)
        addToFan(fan[i] / 3, removed3, mMesh.position(next(fan[i])), mMesh.position(previous(fan[i])),
                 uv[next(fan[i])], uv[previous(fan[i])]);
    if (sector.hasLast)
        addToFan(back.triangle[1], removed3, mMesh.position(previous(fan.back())), kept3, back.lastEnd, kept);
    const int begin = fan[sector.begin], end = fan[sector.end - 1];
    const auto share = [&](const Vec3 &far) {
        const double near = (removed3 - kept3).norm(), rest = (removed3 - far).norm();
        // Not too near to either end.
        return near + rest > 0 ? std::clamp(near / (near + rest), 0.05, 0.95) : 0.5;
    };
    if (sector.hasFirst && sector.hasLast)
        return mPointFan.placeInside(kept, good);
    if (sector.hasFirst)
        return mPointFan.placeOnSide(kept, uv[previous(end)], share(mMesh.position(previous(end))), true,
                                     good);
    if (sector.hasLast)
        return mPointFan.placeOnSide(kept, uv[next(begin)], share(mMesh.position(next(begin))), false, good);
    return kept;
}

bool MapRefiner::refineOne()
{
    const ProgressiveMesh::Collapse record = mMesh.collapses().back();
    Comeback back;
    back.removed = record.removed;
    back.kept = record.kept;
    back.triangle = record.triangle;
    back.fan.assign(mMesh.fan().begin() + record.fanBegin, mMesh.fan().begin() + record.fanEnd);
    const std::vector<int> &fan = back.fan;
    const int first = record.triangle[0], last = record.triangle[1];
    const auto next = ProgressiveMesh::next, previous = ProgressiveMesh::previous;
    const int count = static_cast<int>(fan.size());
    findSectors(fan, first >= 0, last >= 0);
    const bool opened = mSectors.size() > 1;
    const char cutFirst = cut[fan.front()], cutLast = cut[previous(fan.back())];
    for (const int corner : fan)
        back.keptUv.push_back(uv[corner]);
    back.firstEnd = uv[next(fan.front())];
    back.lastEnd = uv[previous(fan.back())];

    mMesh.refine();
    Vec2 firstPlace = Vec2::Zero(), lastPlace = Vec2::Zero();
    bool allGood = true;
    for (const Sector &sector : mSectors) {
        bool good = true;
        const Vec2 place = placeIn(sector, back, good);
        allGood = allGood && good;
        for (int i = sector.begin; i < sector.end; ++i)
            uv[fan[i]] = place;
        if (sector.begin == 0)
            firstPlace = place;
        if (sector.end == count)
            lastPlace = place;
    }
    // Sets the UVs and cut flags of the returning triangles.
    const auto comeBack = [&](int triangle, bool before) {
        int c = 3 * triangle;
        while (mMesh.point(c) != record.removed)
            ++c;
        const int keptCorner = before ? next(c) : previous(c), far = before ? previous(c) : next(c);
        uv[c] = before ? firstPlace : lastPlace;
        uv[keptCorner] = before ? back.keptUv.front() : back.keptUv.back();
        uv[far] = before ? back.firstEnd : back.lastEnd;
        const int between = before ? c : previous(c); // the side from removed to kept
        const int inner = before ? previous(c) : c, outer = next(c);
        cut[between] = opened;
        cut[inner] = 0;
        cut[outer] = before ? cutFirst : cutLast;
        cut[before ? fan.front() : previous(fan.back())] = 0;
    };
    if (first >= 0)
        comeBack(first, true);
    if (last >= 0)
        comeBack(last, false);
    for (const Sector &sector : mSectors)
        makeRoom(fan[sector.begin]);
    return allGood;
}

} // namespace autocuts::multires
