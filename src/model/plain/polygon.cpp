#include "model/plain/polygon.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace autocuts {

Vec3 polygonNormal(const std::vector<Vec3> &points)
{
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        normal += (points[i] - points[0]).cross(points[i + 1] - points[0]);
    return normal;
}

namespace {

//! Scales the points by a power of two so that the polygon has a size of about one. The tests below multiply
//! four lengths, which would leave the range of doubles otherwise; a power of two changes no sign.
std::vector<Vec3> rescaled(const std::vector<Vec3> &points)
{
    double extent = 0;
    for (const Vec3 &p : points)
        extent = std::max(extent, (p - points[0]).cwiseAbs().maxCoeff());
    if (!(extent > 0))
        return points;
    const int exponent = -std::ilogb(extent);
    std::vector<Vec3> result;
    result.reserve(points.size());
    for (const Vec3 &p : points)
        result.emplace_back(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                            std::ldexp(p.z(), exponent));
    return result;
}

//! Tests whether a fan from an apex turns no triangle over. Most apexes fail, so the sides that are most
//! likely to fail are tested first: those on which the last apexes failed, then those next to the apex.
class FanTest
{
public:
    explicit FanTest(const std::vector<Vec3> &points) : mPoints(points), mNormal(polygonNormal(points)) {}

    bool isGood(int apex)
    {
        const int n = static_cast<int>(mPoints.size());
        for (std::size_t k = 0; k < mCulprits.size(); ++k) {
            const int side = mCulprits[k];
            if (side != apex && (side + 1) % n != apex && turnsBack(apex, side)) {
                std::rotate(mCulprits.begin(), mCulprits.begin() + static_cast<std::ptrdiff_t>(k),
                            mCulprits.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                return false;
            }
        }
        for (int low = 1, high = n - 2; low <= high; ++low, --high) {
            for (const int i : {low, high}) {
                const int side = (apex + i) % n;
                if (turnsBack(apex, side)) {
                    mCulprits.insert(mCulprits.begin(), side);
                    if (mCulprits.size() > 16)
                        mCulprits.pop_back();
                    return false;
                }
            }
        }
        return true;
    }

private:
    //! True when the triangle made of the apex and a side points against the polygon's normal.
    bool turnsBack(int apex, int side) const
    {
        const Vec3 &o = mPoints[apex];
        const Vec3 x = (mPoints[side] - o).cross(mPoints[(side + 1) % mPoints.size()] - o);
        // Written out because other tools sum in this order: Eigen's dot() may round differently, and only
        // the sign counts.
        return !(x.x() * mNormal.x() + x.y() * mNormal.y() + x.z() * mNormal.z() >= 0);
    }

    const std::vector<Vec3> &mPoints;
    Vec3 mNormal;
    std::vector<int> mCulprits; //!< sides on which an apex failed, the latest first
};

//! The polygon projected along the coordinate axis nearest to its normal, counter-clockwise.
std::vector<Vec2> projected(const std::vector<Vec3> &points)
{
    const Vec3 normal = polygonNormal(points);
    int drop = 0;
    normal.cwiseAbs().maxCoeff(&drop);
    const int x = (drop + 1) % 3;
    const int y = (drop + 2) % 3;
    std::vector<Vec2> flat;
    flat.reserve(points.size());
    for (const Vec3 &p : points)
        flat.emplace_back(p[x], p[y]);
    if (normal[drop] < 0) {
        for (Vec2 &p : flat)
            p.x() = -p.x();
    }
    return flat;
}

bool insideTriangle(const Vec2 &p, const Vec2 &a, const Vec2 &b, const Vec2 &c)
{
    return cross2(a, b, p) >= 0 && cross2(b, c, p) >= 0 && cross2(c, a, p) >= 0;
}

//! Ear clipping: cuts off the ear with the best shape until three corners are left.
class EarClipper
{
public:
    explicit EarClipper(std::vector<Vec2> points)
        : mPoints(std::move(points)), mCount(static_cast<int>(mPoints.size())), mBefore(mCount),
          mAfter(mCount), mScore(mCount), mReflex(mCount)
    {
        for (int i = 0; i < mCount; ++i) {
            mBefore[i] = (i + mCount - 1) % mCount;
            mAfter[i] = (i + 1) % mCount;
        }
        fillGrid();
        for (int i = 0; i < mCount; ++i)
            evaluate(i);
    }

    std::vector<std::array<int, 3>> clip()
    {
        std::vector<std::array<int, 3>> triangles;
        int lookAgainAt = mCount;
        for (int left = mCount; left > 3; --left) {
            // No ear is left, so the polygon crosses itself. Earlier cuts may have made other corners ears,
            // so all scores are computed again; not before half of the corners are gone, because that would
            // take quadratic time.
            if (mOrder.begin()->first > -isEar && left <= lookAgainAt) {
                lookAgainAt = left / 2;
                evaluateAll();
            }
            const int corner = mOrder.begin()->second;
            const int before = mBefore[corner];
            const int after = mAfter[corner];
            triangles.push_back({before, corner, after});
            mOrder.erase(mOrder.begin());
            mReflex[corner] = false;
            mAfter[before] = after;
            mBefore[after] = before;
            for (const int neighbour : {before, after}) {
                mOrder.erase({-mScore[neighbour], neighbour});
                evaluate(neighbour);
            }
        }
        const int last = mOrder.begin()->second;
        triangles.push_back({mBefore[last], last, mAfter[last]});
        return triangles;
    }

private:
    //! Added to the score of a corner that is an ear, so that ears come first.
    static constexpr double isEar = 10;

    //! Puts the reflex corners into a grid: only they can lie inside an ear of a simple polygon.
    void fillGrid()
    {
        mLow = mHigh = mPoints[0];
        std::vector<int> reflex;
        for (int i = 0; i < mCount; ++i) {
            mLow = mLow.cwiseMin(mPoints[i]);
            mHigh = mHigh.cwiseMax(mPoints[i]);
            mReflex[i] = cross2(mPoints[mBefore[i]], mPoints[i], mPoints[mAfter[i]]) <= 0;
            if (mReflex[i])
                reflex.push_back(i);
        }
        mCells = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(reflex.size()))));
        mGrid.resize(static_cast<std::size_t>(mCells) * mCells);
        for (int i : reflex)
            mGrid[cell(mPoints[i].y(), 1) * mCells + cell(mPoints[i].x(), 0)].push_back(i);
    }

    int cell(double coordinate, int axis) const
    {
        const double size = mHigh[axis] - mLow[axis];
        const double place = size > 0 ? (coordinate - mLow[axis]) / size * mCells : 0;
        return std::clamp(static_cast<int>(place), 0, mCells - 1);
    }

    bool containsReflexCorner(const Vec2 &a, const Vec2 &b, const Vec2 &c) const
    {
        const Vec2 low = a.cwiseMin(b).cwiseMin(c);
        const Vec2 high = a.cwiseMax(b).cwiseMax(c);
        const int right = cell(high.x(), 0);
        const int top = cell(high.y(), 1);
        for (int y = cell(low.y(), 1); y <= top; ++y) {
            for (int x = cell(low.x(), 0); x <= right; ++x) {
                for (int i : mGrid[y * mCells + x]) {
                    const Vec2 &p = mPoints[i];
                    if (mReflex[i] && p != a && p != b && p != c && insideTriangle(p, a, b, c))
                        return true;
                }
            }
        }
        return false;
    }

    //! Computes the score of a corner. Ears come first, the best shape first; then the least bad other
    //! corner.
    void evaluate(int corner)
    {
        const Vec2 &a = mPoints[mBefore[corner]];
        const Vec2 &b = mPoints[corner];
        const Vec2 &c = mPoints[mAfter[corner]];
        const double area = cross2(a, b, c);
        mReflex[corner] = mReflex[corner] && area <= 0;
        const bool ear = area > 0 && !containsReflexCorner(a, b, c);
        const double longest =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        mScore[corner] = (longest > 0 ? area / longest : 0) + (ear ? isEar : 0);
        mOrder.insert({-mScore[corner], corner});
    }

    void evaluateAll()
    {
        const auto order = std::exchange(mOrder, {});
        for (const auto &[score, corner] : order)
            evaluate(corner);
    }

    std::vector<Vec2> mPoints;
    int mCount;
    std::vector<int> mBefore, mAfter;
    std::vector<double> mScore;
    std::vector<bool> mReflex;               //!< reflex and still in the polygon
    std::set<std::pair<double, int>> mOrder; //!< (-score, corner) of the remaining corners
    Vec2 mLow, mHigh;
    int mCells = 1;
    std::vector<std::vector<int>> mGrid;
};

} // namespace

int fanApex(const std::vector<Vec3> &points)
{
    const std::vector<Vec3> scaled = rescaled(points);
    FanTest test(scaled);
    for (int apex = 0; apex < static_cast<int>(points.size()); ++apex) {
        if (test.isGood(apex))
            return apex;
    }
    return -1;
}

std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Vec3> &points, int apex)
{
    if (apex < 0) {
        const std::vector<Vec3> unit = rescaled(points);
        const Vec3 normal = polygonNormal(unit);
        std::vector<std::array<int, 3>> ears = EarClipper(projected(unit)).clip();
        const bool covers = std::all_of(ears.begin(), ears.end(), [&](const std::array<int, 3> &t) {
            return (unit[t[1]] - unit[t[0]]).cross(unit[t[2]] - unit[t[0]]).dot(normal) >= -1e-12;
        });
        if (covers)
            return ears;
        // The polygon is so twisted that ear clipping turns triangles over as well. The fan from corner 0 is
        // no worse, and other tools that measure UV maps use it.
        apex = 0;
    }
    const int n = static_cast<int>(points.size());
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(n - 2);
    for (int i = 1; i + 1 < n; ++i)
        triangles.push_back({apex, (apex + i) % n, (apex + i + 1) % n});
    return triangles;
}

std::vector<std::array<int, 3>> triangulatePolygon(const std::vector<Vec3> &points)
{
    return triangulatePolygon(points, points.size() > 3 ? fanApex(points) : 0);
}

} // namespace autocuts
