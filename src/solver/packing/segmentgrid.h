// Uniform grid over the edges or points of a layout.
#pragma once

#include "solver/packing/layout.h"

namespace autocuts::packing {

//! An edge of an island where the layout puts it. A point is an edge whose ends are equal.
struct PlacedEdge
{
    Vec2 a, b;
    int island;
};

//! Lists per cell the edges that come within `reach` of it. Edges and points outside the grid belong to the
//! cells at its border.
class SegmentGrid
{
public:
    //! \pre edges are sorted by island, so that the entries of a cell are too
    SegmentGrid(const std::vector<PlacedEdge> &edges, const Vec2 &lower, const Vec2 &upper, double reach);

    int cellCount() const { return mColumns * mRows; }
    int cellOf(const Vec2 &p) const { return row(p.y()) * mColumns + column(p.x()); }
    //! Calls visit(cell) for each cell that the box touches, until it returns false.
    //! \return false when visit returned false
    template <class Visit>
    bool visitCellsOf(const Eigen::AlignedBox2d &box, Visit visit) const;
    //! Range of the edge indices of a cell.
    const int *begin(int cell) const { return mEntries.data() + mStart[cell]; }
    const int *end(int cell) const { return mEntries.data() + mStart[cell + 1]; }
    int entryCount() const { return static_cast<int>(mEntries.size()); }

private:
    int column(double x) const { return clampedCell((x - mLower.x()) * mInverse, mColumns); }
    int row(double y) const { return clampedCell((y - mLower.y()) * mInverse, mRows); }
    static int clampedCell(double cell, int count)
    {
        return cell < 1 ? 0 : cell < count ? static_cast<int>(cell) : count - 1;
    }
    template <class Visit>
    void visitCells(const PlacedEdge &edge, double reach, Visit visit) const;

    Vec2 mLower;
    double mInverse = 1;
    int mColumns = 1, mRows = 1;
    std::vector<int> mStart, mEntries;
};

template <class Visit>
bool SegmentGrid::visitCellsOf(const Eigen::AlignedBox2d &box, Visit visit) const
{
    const int firstColumn = column(box.min().x()), lastColumn = column(box.max().x());
    const int firstRow = row(box.min().y()), lastRow = row(box.max().y());
    for (int r = firstRow; r <= lastRow; ++r) {
        for (int c = firstColumn; c <= lastColumn; ++c) {
            if (!visit(r * mColumns + c))
                return false;
        }
    }
    return true;
}

} // namespace autocuts::packing
