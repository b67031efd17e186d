// Test whether boundary sides cross.
#pragma once

#include <utility>
#include <vector>

namespace autocuts::search {

//! Boundary sides in and around a patch: moving ones between points of the patch, fixed ones outside it.
class Segments
{
public:
    void clear();
    //! \param from,to indices of patch points
    void addMoving(int from, int to) { mMoving.push_back({from, to}); }
    void addFixed(double ax, double ay, double bx, double by) { mFixed.push_back({ax, ay, bx, by}); }
    //! True when there is no moving segment: then none can cross.
    bool empty() const { return mMoving.empty(); }

    //! True when a moving segment crosses another segment. Segments that only touch do not cross.
    //! \param position two coordinates per point of the patch
    //! \param touched receives the points of all moving segments that cross; null: stop at the first crossing
    bool cross(const std::vector<double> &position, std::vector<int> *touched = nullptr);

private:
    struct Fixed
    {
        double ax, ay, bx, by;
    };
    struct Box
    {
        double left, right, bottom, top;
        int segment; //!< index into mMoving, then (less their number) into mFixed
    };

    std::vector<std::pair<int, int>> mMoving;
    std::vector<Fixed> mFixed;
    std::vector<Box> mBoxes;
};

} // namespace autocuts::search
