#include "solver/definite/mapbrush.h"

#include "model/plain/chart.h"
#include "solver/search/trianglekernel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace autocuts::definite {

namespace {

// Chosen by hand.
constexpr double leastAreaShare = 0.02; //!< of its right area, that a triangle keeps
constexpr int relaxSweeps = 6, shorteningRounds = 24, mostPullSteps = 16;

double distanceToSegment(const Vec2 &place, const Vec2 &a, const Vec2 &b)
{
    const double squared = (b - a).squaredNorm();
    const double along = squared > 0 ? std::clamp((place - a).dot(b - a) / squared, 0.0, 1.0) : 0;
    return (place - a - along * (b - a)).norm();
}

} // namespace

MapBrush::MapBrush(std::shared_ptr<const MeshData> mesh, const UvMatrix &uv, const std::vector<bool> &held,
                   const std::vector<IslandFlags> &faceFlags)
    : mMesh(std::move(mesh)), mSoup(Soup::build(mMesh)), mUv(uv), mSeen(mMesh->triangleCount(), 0)
{
    const UvTopology topology = findUvTopology(*mMesh, uv);
    findPoints(topology, held);
    findScales(topology, faceFlags);
}

void MapBrush::findPoints(const UvTopology &topology, const std::vector<bool> &held)
{
    std::vector<int> pointOf(mMesh->cornerCount(), -1);
    std::vector<std::pair<int, int>> corners, triangles;
    for (int c = 0; c < mMesh->cornerCount(); ++c) {
        const int root = topology.cornerRoot[c];
        if (pointOf[root] < 0) {
            pointOf[root] = static_cast<int>(mPoints.size());
            mPoints.emplace_back(mUv.row(root));
        }
        pointOf[c] = pointOf[root];
        corners.emplace_back(pointOf[c], c);
    }
    mHeld.assign(mPoints.size(), 0);
    mBorder.assign(mPoints.size(), 0);
    for (int c = 0; c < mMesh->cornerCount(); ++c) {
        if (held[c])
            mHeld[pointOf[c]] = 1;
    }
    for (const UvEdge &edge : topology.uvEdges) {
        for (int c : edge.corner)
            mBorder[pointOf[c]] |= edge.open;
    }
    mTrianglePoints.assign(mMesh->triangleCount(), {-1, -1, -1});
    mChart.assign(mMesh->triangleCount(), -1);
    for (int t = 0; t < mMesh->triangleCount(); ++t) {
        mChart[t] = topology.charts.faceChart[mMesh->triangleFace[t]];
        for (int k = 0; k < 3 && mChart[t] >= 0; ++k) {
            mTrianglePoints[t][k] = pointOf[mMesh->triangles[t][k]];
            triangles.emplace_back(mTrianglePoints[t][k], t);
        }
    }
    mCornersOf = CsrList(static_cast<int>(mPoints.size()), corners);
    mTrianglesOf = CsrList(static_cast<int>(mPoints.size()), triangles);
}

void MapBrush::findScales(const UvTopology &topology, const std::vector<IslandFlags> &faceFlags)
{
    const ChartMap &charts = topology.charts;
    mScale.assign(charts.count, 1);
    std::vector<double> area(charts.count, 0), covered(charts.count, 0), rest(charts.count, 0);
    for (int t = 0; t < mMesh->triangleCount(); ++t) {
        if (mChart[t] < 0)
            continue;
        area[mChart[t]] += areaOf(t);
        covered[mChart[t]] += std::abs(areaOf(t));
        rest[mChart[t]] += 2 * std::numbers::pi * mSoup->targetWeight(t);
    }
    std::vector<int> stack(charts.count, 0);
    const auto faces = charts.faces();
    for (int chart = 0; chart < charts.count; ++chart) {
        const double scale = rest[chart] > 0 ? std::sqrt(covered[chart] / rest[chart]) : 0;
        mScale[chart] = std::copysign(scale, area[chart]);
        stack[chart] = flagsOf(faceFlags, faces[chart]).stack;
    }
    mLeastArea.assign(mMesh->triangleCount(), 0);
    std::vector<overlap::MovingTriangle> all(mMesh->triangleCount());
    for (int t = 0; t < mMesh->triangleCount(); ++t) {
        if (mChart[t] < 0)
            continue;
        const double right = 2 * std::numbers::pi * mSoup->targetWeight(t) * std::pow(mScale[mChart[t]], 2);
        mLeastArea[t] = std::min(areaOf(t), leastAreaShare * right);
        all[t].place = placeOf(t);
        all[t].chart = mChart[t];
        all[t].stack = stack[mChart[t]];
        for (int point : mTrianglePoints[t])
            all[t].border |= mBorder[point] != 0;
    }
    mAll = std::make_unique<overlap::MovingTriangles>(std::move(all));
}

overlap::TrianglePlace MapBrush::placeOf(int triangle) const
{
    const auto &[a, b, c] = mTrianglePoints[triangle];
    return {mPoints[a], mPoints[b], mPoints[c]};
}

//! Twice the area, positive when the triangle is oriented like its chart.
double MapBrush::areaOf(int triangle) const
{
    const auto [a, b, c] = placeOf(triangle);
    return std::copysign(1.0, mScale[mChart[triangle]]) * cross2(a, b, c);
}

double MapBrush::distanceTo(int triangle, const Vec2 &place) const
{
    const auto [a, b, c] = placeOf(triangle);
    const double side = cross2(a, b, c) < 0 ? -1 : 1;
    if (side * cross2(a, b, place) >= 0 && side * cross2(b, c, place) >= 0 && side * cross2(c, a, place) >= 0)
        return 0;
    return std::min(
        {distanceToSegment(place, a, b), distanceToSegment(place, b, c), distanceToSegment(place, c, a)});
}

std::vector<MapBrush::Reached> MapBrush::reached(const BrushSpot &spot, bool withBorder)
{
    std::vector<Reached> points;
    if (spot.triangle < 0 || spot.triangle >= mMesh->triangleCount() || mChart[spot.triangle] < 0)
        return points;
    ++mSearch;
    std::vector<int> queue{spot.triangle};
    mSeen[spot.triangle] = mSearch;
    std::vector<int> found;
    for (std::size_t head = 0; head < queue.size(); ++head) {
        for (int point : mTrianglePoints[queue[head]]) {
            found.push_back(point);
            for (int next : mTrianglesOf[point]) {
                if (std::exchange(mSeen[next], mSearch) != mSearch &&
                    distanceTo(next, spot.centre) < spot.radius)
                    queue.push_back(next);
            }
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (int point : found) {
        const double distance = (mPoints[point] - spot.centre).norm();
        const double effect = distance < spot.radius ? spot.effect(distance) : 0;
        if (effect > 0 && !mHeld[point] && (withBorder || !mBorder[point]))
            points.push_back({point, effect});
    }
    return points;
}

std::vector<int> MapBrush::trianglesAt(const std::vector<Reached> &points)
{
    ++mSearch;
    std::vector<int> triangles;
    for (const Reached &reached : points) {
        for (int t : mTrianglesOf[reached.point]) {
            if (std::exchange(mSeen[t], mSearch) != mSearch)
                triangles.push_back(t);
        }
    }
    return triangles;
}

std::vector<Vec2> MapBrush::placesOf(const std::vector<Reached> &points) const
{
    std::vector<Vec2> places;
    places.reserve(points.size());
    for (const Reached &reached : points)
        places.push_back(mPoints[reached.point]);
    return places;
}

void MapBrush::restore(const std::vector<Reached> &points, const std::vector<Vec2> &before)
{
    for (std::size_t i = 0; i < points.size(); ++i)
        mPoints[points[i].point] = before[i];
}

bool MapBrush::keep(const std::vector<Reached> &points, const std::vector<Vec2> &before)
{
    const std::vector<int> triangles = trianglesAt(points);
    std::vector<overlap::TrianglePlace> places;
    places.reserve(triangles.size());
    for (int t : triangles)
        places.push_back(placeOf(t));
    if (!mAll->move(triangles, places)) {
        restore(points, before);
        return false;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int point = points[i].point;
        if (mPoints[point] == before[i])
            continue;
        for (int corner : mCornersOf[point])
            mUv.row(corner) = mPoints[point].transpose();
    }
    return true;
}

//! Makes a step with the border, or without it where that would overlap something.
template <typename Change>
bool MapBrush::step(const BrushSpot &spot, Change change)
{
    for (const bool withBorder : {true, false}) {
        const std::vector<Reached> points = reached(spot, withBorder);
        const std::vector<Vec2> before = placesOf(points);
        change(points);
        if (placesOf(points) == before)
            return false;
        if (keep(points, before))
            return true;
    }
    return false;
}

double MapBrush::energyAround(int point, Vec2 *gradient, std::array<double, 3> *hessian) const
{
    double sum = 0;
    for (int t : mTrianglesOf[point]) {
        const double scale = mScale[mChart[t]];
        double p[6];
        for (int k = 0; k < 3; ++k) {
            p[2 * k] = mPoints[mTrianglePoints[t][k]].x() / scale;
            p[2 * k + 1] = mPoints[mTrianglePoints[t][k]].y() / std::abs(scale);
        }
        const double energy = search::triangleEnergy(p, mSoup->basis[t]);
        if (!std::isfinite(energy))
            continue; // it was turned over before: it may stay so, and does not pull
        sum += mSoup->weight[t] * energy;
        if (!gradient)
            continue;
        double g[6], h[21];
        search::triangleDerivatives(p, mSoup->basis[t], mSoup->weight[t], g, h);
        for (int k = 0; k < 3; ++k) {
            if (mTrianglePoints[t][k] != point)
                continue;
            const int x = 2 * k, y = x + 1; // rows of the lower triangle
            *gradient += Vec2(g[x], g[y]);
            (*hessian)[0] += h[x * (x + 1) / 2 + x];
            (*hessian)[1] += h[y * (y + 1) / 2 + x];
            (*hessian)[2] += h[y * (y + 1) / 2 + y];
        }
    }
    return sum;
}

//! Makes a part of a Newton step of one point.
void MapBrush::relaxPoint(const Reached &reached)
{
    const int point = reached.point;
    const auto triangles = mTrianglesOf[point];
    const double scale = triangles.empty() ? 0 : mScale[mChart[triangles.front()]];
    if (scale == 0)
        return;
    Vec2 gradient = Vec2::Zero();
    std::array<double, 3> hessian{0, 0, 0};
    const double energy = energyAround(point, &gradient, &hessian);
    const double determinant = hessian[0] * hessian[2] - hessian[1] * hessian[1];
    if (!(determinant > 0))
        return;
    const Vec2 way = Vec2(hessian[1] * gradient.y() - hessian[2] * gradient.x(),
                          hessian[1] * gradient.x() - hessian[0] * gradient.y()) /
                     determinant;
    const Vec2 before = mPoints[point];
    for (double share = reached.effect; share > reached.effect / 20; share /= 2) {
        mPoints[point] = before + share * Vec2(way.x() * scale, way.y() * std::abs(scale));
        const bool sound =
            std::all_of(triangles.begin(), triangles.end(), [this](int t) { return isSound(t); });
        if (sound && energyAround(point, nullptr, nullptr) < energy)
            return;
    }
    mPoints[point] = before;
}

bool MapBrush::relax(const BrushSpot &spot)
{
    return step(spot, [this](const std::vector<Reached> &points) {
        for (int sweep = 0; sweep < relaxSweeps; ++sweep) {
            // Back and forth, so that no direction is preferred.
            for (std::size_t i = 0; i < points.size(); ++i)
                relaxPoint(points[sweep % 2 == 0 ? i : points.size() - 1 - i]);
        }
    });
}

//! Shortens the ways of the points around triangles that are turned over or too small, until there are none.
void MapBrush::shorten(const std::vector<Reached> &points, const std::vector<Vec2> &before)
{
    std::unordered_map<int, std::size_t> indexOf;
    for (std::size_t i = 0; i < points.size(); ++i)
        indexOf[points[i].point] = i;
    const std::vector<int> triangles = trianglesAt(points);
    for (int round = 0; round < shorteningRounds; ++round) {
        std::vector<char> shortened(points.size(), 0);
        for (int t : triangles) {
            if (isSound(t))
                continue;
            for (int point : mTrianglePoints[t]) {
                if (const auto found = indexOf.find(point); found != indexOf.end())
                    shortened[found->second] = 1;
            }
        }
        if (std::find(shortened.begin(), shortened.end(), 1) == shortened.end())
            return;
        const double share = round < shorteningRounds / 2 ? 0.5 : 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            Vec2 &place = mPoints[points[i].point];
            if (shortened[i])
                place = share > 0 ? Vec2(before[i] + share * (place - before[i])) : before[i];
        }
    }
    restore(points, before);
}

bool MapBrush::pinch(const BrushSpot &spot, double amount)
{
    return step(spot, [&](const std::vector<Reached> &points) {
        const std::vector<Vec2> before = placesOf(points);
        for (const Reached &reached : points)
            mPoints[reached.point] += amount * reached.effect * (spot.centre - mPoints[reached.point]);
        shorten(points, before);
    });
}

void MapBrush::grab(const BrushSpot &spot)
{
    mGrabbed = reached(spot, true);
    mGrabbedFrom = placesOf(mGrabbed);
    mGrabRadius = spot.radius;
    mPulled = Vec2::Zero();
}

//! Moves what was grabbed to a displacement. \return false when that cannot be, and it stays
bool MapBrush::pullTo(const Vec2 &way)
{
    const std::vector<Vec2> before = placesOf(mGrabbed);
    for (std::size_t i = 0; i < mGrabbed.size(); ++i)
        mPoints[mGrabbed[i].point] = mGrabbedFrom[i] + mGrabbed[i].effect * way;
    const std::vector<int> triangles = trianglesAt(mGrabbed);
    if (!std::all_of(triangles.begin(), triangles.end(), [this](int t) { return isSound(t); })) {
        restore(mGrabbed, before);
        return false;
    }
    if (!keep(mGrabbed, before))
        return false;
    mPulled = way;
    return true;
}

bool MapBrush::pull(const Vec2 &way)
{
    // In steps, so that nothing is jumped over.
    const double length = (way - mPulled).norm();
    const int steps = std::clamp(static_cast<int>(std::ceil(length / (0.1 * mGrabRadius))), 1, mostPullSteps);
    const Vec2 each = (way - mPulled) / steps;
    bool moved = false;
    for (int i = 1; i <= steps && !mGrabbed.empty(); ++i) {
        if (pullTo(i == steps ? way : Vec2(mPulled + each))) {
            moved = true;
            continue;
        }
        for (double share : {0.5, 0.25, 0.125}) {
            const Vec2 part = mPulled + share * each;
            moved = pullTo(part) || moved;
        }
        break;
    }
    return moved;
}

} // namespace autocuts::definite
