#include "solver/overlap/movingtriangles.h"

#include "solver/overlap/overlapfinder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace autocuts::overlap {

namespace {

constexpr int mostCellsOfTriangle = 256, mostColumns = 1024; // chosen by hand

//! The place with its corners counter-clockwise.
TrianglePlace upright(const TrianglePlace &place)
{
    const auto &[a, b, c] = place;
    return cross2(a, b, c) < 0 ? TrianglePlace{a, c, b} : place;
}

Eigen::AlignedBox2d boxOf(const TrianglePlace &place)
{
    Eigen::AlignedBox2d box;
    for (const Vec2 &point : place)
        box.extend(point);
    return box;
}

bool boxesMeet(const TrianglePlace &a, const TrianglePlace &b)
{
    return boxOf(a).intersects(boxOf(b));
}

} // namespace

MovingTriangles::MovingTriangles(std::vector<MovingTriangle> triangles)
    : mTriangles(std::move(triangles)), mSeen(mTriangles.size(), 0), mMoves(mTriangles.size(), 0)
{
    Eigen::AlignedBox2d box;
    double area = 0;
    int count = 0;
    for (const MovingTriangle &triangle : mTriangles) {
        if (triangle.chart < 0)
            continue;
        box.extend(boxOf(triangle.place));
        area += std::abs(cross2(triangle.place[0], triangle.place[1], triangle.place[2])) / 2;
        ++count;
    }
    mLeastArea = OverlapOptions().minAreaRatio * area;
    if (count > 0) {
        mOrigin = box.min();
        const double longest = std::max(box.sizes().maxCoeff(), 1e-300);
        mCell = std::max(std::sqrt(2 * area / count), longest / mostColumns);
        const auto cells = [&](double size) {
            return std::clamp(static_cast<int>(size / mCell) + 1, 1, mostColumns);
        };
        mColumns = cells(box.sizes().x());
        mRows = cells(box.sizes().y());
    }
    mInCell.resize(static_cast<std::size_t>(mColumns) * mRows);
    for (std::size_t t = 0; t < mTriangles.size(); ++t) {
        if (mTriangles[t].chart >= 0)
            place(static_cast<int>(t), mTriangles[t].place);
    }
}

//! What lies outside of the cells counts to those at the rim.
MovingTriangles::Cells MovingTriangles::cellsOf(const TrianglePlace &place) const
{
    const Eigen::AlignedBox2d box = boxOf(place);
    const auto at = [&](double position, double origin, int count) {
        const double cell = (position - origin) / mCell;
        return cell > 0 ? static_cast<int>(std::min(cell, count - 1.0)) : 0; // 0 also when it is not a number
    };
    return {at(box.min().x(), mOrigin.x(), mColumns), at(box.max().x(), mOrigin.x(), mColumns),
            at(box.min().y(), mOrigin.y(), mRows), at(box.max().y(), mOrigin.y(), mRows)};
}

void MovingTriangles::place(int triangle, const TrianglePlace &place)
{
    mTriangles[triangle].place = place;
    const Cells cells = cellsOf(place);
    if (cells.count() > mostCellsOfTriangle) {
        mLarge.push_back(triangle);
        return;
    }
    for (int row = cells.bottom; row <= cells.top; ++row) {
        for (int column = cells.left; column <= cells.right; ++column)
            mInCell[static_cast<std::size_t>(row) * mColumns + column].push_back(triangle);
    }
}

void MovingTriangles::leave(int triangle)
{
    const Cells cells = cellsOf(mTriangles[triangle].place);
    if (cells.count() > mostCellsOfTriangle) {
        std::erase(mLarge, triangle);
        return;
    }
    for (int row = cells.bottom; row <= cells.top; ++row) {
        for (int column = cells.left; column <= cells.right; ++column)
            std::erase(mInCell[static_cast<std::size_t>(row) * mColumns + column], triangle);
    }
}

bool MovingTriangles::mayTouch(int a, int b) const
{
    const MovingTriangle &first = mTriangles[a], &second = mTriangles[b];
    if (!first.border && !second.border)
        return false;
    const bool stacked = first.stack != 0 && first.stack == second.stack && first.chart != second.chart;
    return !stacked && boxesMeet(first.place, second.place);
}

void MovingTriangles::addOverlaps(int triangle, std::map<Charts, double> &found)
{
    ++mSearch;
    const MovingTriangle &own = mTriangles[triangle];
    const TrianglePlace place = upright(own.place);
    const auto compare = [&](int other) {
        if (other == triangle || std::exchange(mSeen[other], mSearch) == mSearch ||
            (mMoves[other] && other < triangle) || !mayTouch(triangle, other))
            return;
        const double area = intersectionArea(place, upright(mTriangles[other].place));
        if (area > mLeastArea)
            found[std::minmax(own.chart, mTriangles[other].chart)] += area;
    };
    const Cells cells = cellsOf(own.place);
    for (int row = cells.bottom; row <= cells.top; ++row) {
        for (int column = cells.left; column <= cells.right; ++column) {
            for (int other : mInCell[static_cast<std::size_t>(row) * mColumns + column])
                compare(other);
        }
    }
    for (int other : mLarge)
        compare(other);
}

std::map<MovingTriangles::Charts, double> MovingTriangles::overlaps(std::span<const int> moving)
{
    std::map<Charts, double> found;
    for (int triangle : moving)
        addOverlaps(triangle, found);
    return found;
}

bool MovingTriangles::move(std::span<const int> moving, std::span<const TrianglePlace> places)
{
    std::vector<TrianglePlace> before;
    before.reserve(moving.size());
    for (std::size_t i = 0; i < moving.size(); ++i) {
        before.push_back(mTriangles[moving[i]].place);
        mMoves[moving[i]] = 1;
        leave(moving[i]);
        place(moving[i], places[i]);
    }
    const std::map<Charts, double> after = overlaps(moving);
    bool allowed = true;
    if (!after.empty()) {
        const auto exchange = [&](std::span<const TrianglePlace> others) {
            for (std::size_t i = 0; i < moving.size(); ++i) {
                leave(moving[i]);
                place(moving[i], others[i]);
            }
        };
        exchange(before);
        const std::map<Charts, double> known = overlaps(moving);
        allowed = std::all_of(after.begin(), after.end(),
                              [&](const auto &entry) { return known.count(entry.first) > 0; });
        if (allowed)
            exchange(places);
    }
    for (int triangle : moving)
        mMoves[triangle] = 0;
    return allowed;
}

} // namespace autocuts::overlap
