#include "solver/packing/distancefield.h"

#include "solver/base/segmentcrossing.h"
#include "solver/packing/segmentgrid.h"

#include <algorithm>

namespace autocuts::packing {

DistanceField::DistanceField(const Outline &outline, double cell, double reach, WorkMeter &work)
{
    Eigen::AlignedBox2d box;
    for (const Vec2 &p : outline.hull)
        box.extend(p);
    if (box.isEmpty())
        box.extend(Vec2::Zero()); // an island without usable points
    mBoxLower = box.min();
    mBoxUpper = box.max();
    const Vec2 size = box.sizes() + Vec2::Constant(2 * reach);
    constexpr double mostNodes = 1 << 18;
    mCell = std::max(cell, std::sqrt(size.x() * size.y() / mostNodes));
    mInverse = 1 / mCell;
    mLower = box.min() - Vec2::Constant(reach);
    mColumns = static_cast<int>(size.x() * mInverse) + 3;
    mRows = static_cast<int>(size.y() * mInverse) + 3;
    findNearestEdges(outline, work);
    findSigns(outline, work);
}

void DistanceField::findNearestEdges(const Outline &outline, WorkMeter &work)
{
    const auto nodes = static_cast<std::size_t>(mColumns) * mRows;
    mDistance.assign(nodes, 1e30F);
    std::vector<int> nearest(nodes, -1);
    double tests = 0;
    const auto offer = [&](int i, int j, int e) {
        const std::size_t node = static_cast<std::size_t>(j) * mColumns + i;
        if (nearest[node] == e)
            return;
        ++tests;
        const Outline::Edge &edge = outline.edges[e];
        const auto d = static_cast<float>(
            pointSegmentSquared(mLower + mCell * Vec2(i, j), outline.points[edge.a], outline.points[edge.b]));
        if (d < mDistance[node]) {
            mDistance[node] = d;
            nearest[node] = e;
        }
    };
    for (int e = 0; e < static_cast<int>(outline.edges.size()); ++e) {
        const Vec2 a = (outline.points[outline.edges[e].a] - mLower) * mInverse;
        const Vec2 b = (outline.points[outline.edges[e].b] - mLower) * mInverse;
        const int steps = static_cast<int>((b - a).norm()) + 1;
        for (int k = 0; k <= steps; ++k) {
            const Vec2 p = a + (b - a) * (static_cast<double>(k) / steps);
            const int i = static_cast<int>(p.x()), j = static_cast<int>(p.y());
            for (int corner = 0; corner < 4; ++corner)
                offer(std::min(i + corner % 2, mColumns - 1), std::min(j + corner / 2, mRows - 1), e);
        }
    }
    // One sweep upwards and one downwards pass the nearest edge on from node to node.
    const auto take = [&](int i, int j, int di, int dj) {
        const int x = i + di, y = j + dj;
        if (x < 0 || y < 0 || x >= mColumns || y >= mRows)
            return;
        const int e = nearest[static_cast<std::size_t>(y) * mColumns + x];
        if (e >= 0)
            offer(i, j, e);
    };
    for (int j = 0; j < mRows; ++j) {
        for (int i = 0; i < mColumns; ++i) {
            for (const int di : {-1, 0, 1})
                take(i, j, di, -1);
            take(i, j, -1, 0);
        }
        for (int i = mColumns - 1; i >= 0; --i)
            take(i, j, 1, 0);
    }
    for (int j = mRows - 1; j >= 0; --j) {
        for (int i = mColumns - 1; i >= 0; --i) {
            for (const int di : {-1, 0, 1})
                take(i, j, di, 1);
            take(i, j, 1, 0);
        }
        for (int i = 0; i < mColumns; ++i)
            take(i, j, -1, 0);
    }
    for (float &d : mDistance)
        d = std::sqrt(d);
    work.add(25 * static_cast<double>(nodes) + 8 * tests);
}

void DistanceField::findSigns(const Outline &outline, WorkMeter &work)
{
    struct Crossing
    {
        int row;
        double column;
        int winding;
    };
    std::vector<Crossing> crossings;
    for (const Outline::Edge &e : outline.edges) {
        Vec2 a = (outline.points[e.a] - mLower) * mInverse, b = (outline.points[e.b] - mLower) * mInverse;
        if (e.winding == 0 || a.y() == b.y())
            continue;
        const int winding = a.y() < b.y() ? -e.winding : e.winding;
        if (a.y() > b.y())
            std::swap(a, b);
        for (int j = static_cast<int>(std::ceil(a.y())); j < std::min(std::ceil(b.y()), 1.0 * mRows); ++j)
            crossings.push_back({j, a.x() + (j - a.y()) * (b.x() - a.x()) / (b.y() - a.y()), winding});
    }
    std::sort(crossings.begin(), crossings.end(), [](const Crossing &p, const Crossing &q) {
        return p.row < q.row || (p.row == q.row && p.column < q.column);
    });
    int winding = 0;
    for (std::size_t k = 0; k < crossings.size(); ++k) {
        if (k > 0 && crossings[k].row != crossings[k - 1].row) {
            winding = 0;
        } else if (k > 0 && winding != 0) {
            const int last = std::min(mColumns - 1, static_cast<int>(std::floor(crossings[k].column)));
            for (int i = static_cast<int>(std::ceil(crossings[k - 1].column)); i <= last; ++i) {
                float &d = mDistance[static_cast<std::size_t>(crossings[k].row) * mColumns + i];
                d = -std::abs(d);
            }
        }
        winding += crossings[k].winding;
    }
    work.add(30 * static_cast<double>(crossings.size()));
}

Vec2 DistanceField::gradientAt(const Vec2 &p) const
{
    const double x = (p.x() - mLower.x()) * mInverse, y = (p.y() - mLower.y()) * mInverse;
    if (!(x >= 0 && y >= 0 && x < mColumns - 1 && y < mRows - 1))
        return Vec2::Zero();
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const double u = x - i, v = y - j;
    const float *d = mDistance.data() + static_cast<std::size_t>(j) * mColumns + i;
    const float *above = d + mColumns;
    return Vec2((1 - v) * (d[1] - d[0]) + v * (above[1] - above[0]),
                (1 - u) * (above[0] - d[0]) + u * (above[1] - d[1])) *
           mInverse;
}

} // namespace autocuts::packing
