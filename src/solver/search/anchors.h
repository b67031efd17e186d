// What holds corners at places in the plane: pins and rectangles, for the seam search.
#pragma once

#include "model/plain/csrlist.h"
#include "model/plain/snapshot.h"

#include <span>
#include <vector>

namespace autocuts::search {

//! A box that a soup corner is pulled into: stiffness * squared distance to the box. A pin is a box without
//! size.
struct Anchor
{
    int soupCorner = 0;
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero(); //!< solver units
    double stiffness = 0;   //!< of a hard pin: relative to the stiffness of hard pins, see CutState
    bool isHardPin = false; //!< the corner has to lie exactly at the place
    bool isBox = false;     //!< from a rectangle

    //! From the box to a point outside of it; zero inside.
    Vec2 outside(const Vec2 &p) const { return p - p.cwiseMax(lower).cwiseMin(upper); }
    bool operator==(const Anchor &) const = default;
};

//! The pins and rectangles of a snapshot, by soup corner. Energies as in energy/constraintterms.h.
class Anchors
{
public:
    Anchors() = default;
    explicit Anchors(const Snapshot &snapshot);

    bool empty() const { return mAnchors.empty(); }
    const std::vector<Anchor> &all() const { return mAnchors; }
    //! Indices into all() of the anchors of a soup corner. \pre not empty()
    std::span<const int> at(int soupCorner) const { return mOfCorner[soupCorner]; }
    //! True when a corner of the triangle has an anchor.
    bool onTriangle(int t) const { return !mOnTriangle.empty() && mOnTriangle[t] != 0; }
    //! True when there are hard pins.
    bool hasHardPins() const { return mHardPins > 0; }

private:
    std::vector<Anchor> mAnchors;
    CsrList mOfCorner;
    std::vector<char> mOnTriangle;
    int mHardPins = 0;
};

} // namespace autocuts::search
