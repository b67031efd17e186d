#include "solver/packing/segmentgrid.h"

#include <algorithm>

namespace autocuts::packing {

SegmentGrid::SegmentGrid(const std::vector<PlacedEdge> &edges, const Vec2 &lower, const Vec2 &upper,
                         double reach)
    : mLower(lower)
{
    const Vec2 size = (upper - lower).cwiseMax(Vec2::Constant(1e-300));
    const double cells = std::clamp(static_cast<double>(edges.size()), 16.0, 1048576.0);
    // About one cell per edge; cells smaller than the reach would only add entries.
    const double wanted =
        std::max({std::sqrt(size.x() * size.y() / cells), 1.5 * reach, std::max(size.x(), size.y()) / 4096});
    mInverse = 1 / wanted;
    mColumns = std::clamp(static_cast<int>(std::min(size.x() * mInverse, 4096.0)) + 1, 1, 4096);
    mRows = std::clamp(static_cast<int>(std::min(size.y() * mInverse, 4096.0)) + 1, 1, 4096);

    mStart.assign(cellCount() + 1, 0);
    for (const PlacedEdge &e : edges)
        visitCells(e, reach, [&](int cell) { ++mStart[cell + 1]; });
    for (int c = 0; c < cellCount(); ++c)
        mStart[c + 1] += mStart[c];
    mEntries.resize(mStart.back());
    std::vector<int> next(mStart.begin(), mStart.end() - 1);
    for (int i = 0; i < static_cast<int>(edges.size()); ++i)
        visitCells(edges[i], reach, [&](int cell) { mEntries[next[cell]++] = i; });
}

template <class Visit>
void SegmentGrid::visitCells(const PlacedEdge &edge, double reach, Visit visit) const
{
    const Vec2 &a = edge.a.y() <= edge.b.y() ? edge.a : edge.b;
    const Vec2 &b = edge.a.y() <= edge.b.y() ? edge.b : edge.a;
    const double rise = b.y() - a.y();
    const int lastRow = row(b.y() + reach);
    for (int r = row(a.y() - reach); r <= lastRow; ++r) {
        // The part of the edge within reach of this row. The first and last row extend to infinity.
        double t0 = 0, t1 = 1;
        if (rise > 0) {
            if (r > 0)
                t0 = std::clamp((mLower.y() + r / mInverse - reach - a.y()) / rise - 1e-9, 0.0, 1.0);
            if (r + 1 < mRows)
                t1 = std::clamp((mLower.y() + (r + 1) / mInverse + reach - a.y()) / rise + 1e-9, 0.0, 1.0);
        }
        const double x0 = a.x() + t0 * (b.x() - a.x()), x1 = a.x() + t1 * (b.x() - a.x());
        const int lastColumn = column(std::max(x0, x1) + reach);
        for (int c = column(std::min(x0, x1) - reach); c <= lastColumn; ++c)
            visit(r * mColumns + c);
    }
}

} // namespace autocuts::packing
