#include "solver/search/anchors.h"

#include "solver/energy/constraintterms.h"

namespace autocuts::search {

Anchors::Anchors(const Snapshot &snapshot)
{
    for (const Pin &pin : snapshot.steering->pins) {
        mAnchors.push_back(
            {pin.soupCorner, pin.target, pin.target, pin.hard ? 1 : 0.5 * pin.weight, pin.hard, false});
        mHardPins += pin.hard;
    }
    for (const UvRectangle &box : snapshot.steering->rectangles) {
        const double stiffness = energy::boxStiffness(box, snapshot.settings.boxWeight);
        for (const int corner : box.soupCorners)
            mAnchors.push_back({corner, box.lower, box.upper, stiffness, false, true});
    }
    if (mAnchors.empty())
        return;
    std::vector<std::pair<int, int>> ofCorner;
    mOnTriangle.assign(snapshot.mesh->triangleCount(), 0);
    for (std::size_t i = 0; i < mAnchors.size(); ++i) {
        ofCorner.emplace_back(mAnchors[i].soupCorner, static_cast<int>(i));
        mOnTriangle[mAnchors[i].soupCorner / 3] = 1;
    }
    mOfCorner = {snapshot.mesh->soupCornerCount(), ofCorner};
}

} // namespace autocuts::search
