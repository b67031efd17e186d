// Finds the pairs of UV triangles whose interiors intersect.
#pragma once

#include "model/plain/types.h"
#include "solver/base/jobcontext.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace autocuts::overlap {

//! Share of a map's UV area above which an overlap counts wherever people see it: smaller ones come from
//! rounding.
inline constexpr double visibleOverlap = 1e-9;

//! What counts as an overlap, how many are reported, and the job.
struct OverlapOptions
{
    //! A pair counts when its intersection exceeds this share of totalArea. Chosen by hand.
    double minAreaRatio = 1e-10;
    double totalArea = 0;              //!< UV area to compare with; 0: the total of the given triangles
    std::size_t maxPairs = 50'000'000; //!< findOverlaps() stops there; bounds memory, chosen by hand
    JobContext job;                    //!< may be stopped from any thread
};

//! Two triangles, first < second, and the UV area of their intersection.
struct OverlapPair
{
    int first = 0, second = 0;
    double area = 0;
    bool operator==(const OverlapPair &) const = default;
};

//! Overlapping pairs in ascending order.
struct OverlapList
{
    std::vector<OverlapPair> pairs;
    bool complete = true; //!< false when cancelled or stopped at maxPairs
};

//! Area of the intersection of two triangles. Exactly 0 when their interiors do not meet, which is decided
//! without rounding errors.
//! \pre both are counter-clockwise
double intersectionArea(const std::array<Vec2, 3> &a, const std::array<Vec2, 3> &b);

//! Sum of the absolute areas of all finite triangles. \param uv three rows per triangle
double totalUvArea(const UvMatrix &uv);

//! Calls visit(a, b, area) for every two overlapping triangles, a < b, in an order that depends on the UVs
//! only, until it returns false. Triangles may be oriented either way; those with a non-finite corner or an
//! area of exactly 0 overlap nothing.
//! \param uv three rows per triangle
//! \return false when visit returned false or when cancelled
bool visitOverlaps(const UvMatrix &uv, const OverlapOptions &options,
                   const std::function<bool(int, int, double)> &visit);

//! The same for triangles of one group only. Groups may lie on each other at no cost.
//! \param group of each triangle, from 0
bool visitOverlapsWithin(const UvMatrix &uv, const std::vector<int> &group, const OverlapOptions &options,
                         const std::function<bool(int, int, double)> &visit);

//! All overlapping pairs. \param uv three rows per triangle
[[nodiscard]] OverlapList findOverlaps(const UvMatrix &uv, const OverlapOptions &options = {});

//! The overlapping pairs among some triangles. \param triangles indices of triangles of uv, each once
OverlapList findOverlapsAmong(const UvMatrix &uv, const std::vector<int> &triangles,
                              const OverlapOptions &options = {});

} // namespace autocuts::overlap
