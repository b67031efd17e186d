// Tells what a map does not obey.
#pragma once

#include "model/plain/snapshot.h"

#include <vector>

namespace autocuts::unwrap {

//! The hard steering that a map does not obey: what contradicts itself, or what would need a flip or an
//! overlap. The order in which jobs give way is in docs/steering.md.
struct UnmetSteering
{
    std::vector<int> pins;       //!< corners of hard pins that are not on their pins
    std::vector<int> joins;      //!< joined edge pairs that are seams
    std::vector<int> rectangles; //!< indices of rectangles that islands of theirs reach out of
    //! Edge pairs that are seams although they are not given and only given ones may be: without them a chart
    //! is not a disk, or cannot be laid flat without overlapping itself.
    std::vector<int> missingSeams;
    std::vector<int> bent; //!< edge pairs of edge loops that the user wants straight, in islands without pins

    std::size_t count() const
    {
        return pins.size() + joins.size() + rectangles.size() + missingSeams.size() + bent.size();
    }
    bool empty() const { return count() == 0; }
    //! True when nothing is unmet but where islands are.
    bool onlyRectangles() const { return count() == rectangles.size(); }
};

//! The edges of Steering::straightLoops that are not on one line with the others of their loop in an island.
//! \param uv per corner, in any unit
[[nodiscard]] std::vector<int> bentEdges(const Snapshot &snapshot, const UvMatrix &uv);

//! \param uv per corner, texture space. Faces outside the scope are not looked at
[[nodiscard]] UnmetSteering unmetSteering(const Snapshot &snapshot, const UvMatrix &uv);

} // namespace autocuts::unwrap
