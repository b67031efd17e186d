// Joins rigid regions to nets: maps without stretch and with short seams.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/rigid/hinges.h"

#include <cstdint>
#include <memory>

namespace autocuts::rigid {

//! The rigid regions of a problem, in the plane, with the hinges between them. Immutable.
class Nets
{
public:
    //! \param snapshot with its rigid regions \pre snapshot.rigid
    Nets(std::shared_ptr<const Soup> soup, const Snapshot &snapshot);

    //! Joins regions along hinges, the dearest seams first, as long as no net overlaps itself.
    //! \param number 0: by cost alone; every other number changes the costs at random and gives other nets
    //! \param map a map with seams at the borders of all regions, for the other triangles; its seams and
    //! coordinates are replaced inside of regions \returns the map with the nets, each in a place that may
    //! overlap others; as it was when stopped
    SeamedMap joined(int number, SeamedMap map, const JobContext &job = {}) const;

    const Unrolled &unrolled() const { return mUnrolled; }

private:
    std::shared_ptr<const Soup> mSoup;
    std::shared_ptr<const RigidRegions> mRegions;
    Unrolled mUnrolled;
    CutFlags mAlwaysCut;
    std::vector<Hinge> mHinges;
    std::vector<double> mCost; //!< per hinge, of a seam there
};

} // namespace autocuts::rigid
