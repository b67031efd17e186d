// Triangles of a map of which some move: bars moves that bring new overlaps.
#pragma once

#include "model/plain/types.h"

#include <map>
#include <span>
#include <vector>

namespace autocuts::overlap {

using TrianglePlace = std::array<Vec2, 3>;

//! A triangle of the map.
struct MovingTriangle
{
    TrianglePlace place;
    int chart = -1;      //!< negative: it has no UVs and lies on nothing
    int stack = 0;       //!< charts of one stack may lie on each other; 0: in none
    bool border = false; //!< it touches the border of its chart
};

//! Finds overlaps of the triangles that move with all others near them, so that a step of a gesture costs as
//! much as what moves in it. Pairs of which neither touches a border are not compared: while no triangle is
//! turned over, charts begin to overlap at their borders.
class MovingTriangles
{
public:
    explicit MovingTriangles(std::vector<MovingTriangle> triangles);

    //! Moves triangles, or leaves all of them where they are when two charts, or two parts of one chart,
    //! would overlap there that did not before. Charts that overlap already may overlap more.
    //! \param moving indices, each once \param places one per index \return true when they were moved
    bool move(std::span<const int> moving, std::span<const TrianglePlace> places);

private:
    using Charts = std::pair<int, int>;
    //! Columns and rows of cells, both ends included.
    struct Cells
    {
        int left, right, bottom, top;
        int count() const { return (right - left + 1) * (top - bottom + 1); }
    };

    Cells cellsOf(const TrianglePlace &place) const;
    void place(int triangle, const TrianglePlace &place);
    void leave(int triangle);
    //! The overlap of each two charts that the moving triangles take part in.
    std::map<Charts, double> overlaps(std::span<const int> moving);
    void addOverlaps(int triangle, std::map<Charts, double> &found);
    bool mayTouch(int a, int b) const;

    std::vector<MovingTriangle> mTriangles;
    Vec2 mOrigin = Vec2::Zero();
    double mCell = 1; //!< size of a cell
    int mColumns = 1, mRows = 1;
    std::vector<std::vector<int>> mInCell;
    std::vector<int> mLarge; //!< triangles in so many cells that they are in none
    double mLeastArea = 0;   //!< smaller overlaps come from rounding
    std::vector<int> mSeen;  //!< per triangle, the last search that has met it
    int mSearch = 0;
    std::vector<char> mMoves;
};

} // namespace autocuts::overlap
