// Boundary sides near each other: do they cross?
#pragma once

#include <utility>
#include <vector>

namespace autocuts::search {

//! Segments between points of a patch (they move) and around them (they do not).
class Segments
{
public:
    void clear();
    //! \param from,to points of the patch
    void addMoving(int from, int to) { mMoving.push_back({from, to}); }
    void addFixed(double ax, double ay, double bx, double by) { mFixed.push_back({ax, ay, bx, by}); }
    bool empty() const { return mMoving.empty(); }

    //! True when two segments cross, at least one of them moving; touching is no crossing.
    //! \param position two coordinates per point
    //! \param touched when given, receives the points of all crossing segments; else the first one ends it
    bool cross(const std::vector<double> &position, std::vector<int> *touched = nullptr);

private:
    struct Fixed
    {
        double ax, ay, bx, by;
    };
    struct Box
    {
        double left, right, bottom, top;
        int segment; //!< moving ones first
    };

    std::vector<std::pair<int, int>> mMoving;
    std::vector<Fixed> mFixed;
    std::vector<Box> mBoxes;
};

} // namespace autocuts::search
