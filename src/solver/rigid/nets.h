// Joins rigid regions to nets: maps without stretch and with short seams.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"
#include "solver/rigid/hinges.h"

#include <cstdint>
#include <memory>

namespace autocuts::rigid {

//! The rigid regions of a problem, in the plane, with the hinges between them. Regions that overlap
//! themselves in the plane count as if they did not work, see Unrolled: maps keep them as they are.
//! Immutable.
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

    //! The same with the charts of the rest of a map as further regions. Those that are nearly isometric join
    //! along hinges, too. \param map as for joined()
    Nets withCharts(const SeamedMap &map, const Snapshot &snapshot) const;

    //! Per triangle: true in regions, but for thin triangles, which are in any shape where a region is flat.
    std::vector<bool> keepsShape() const;
    //! The soup in which the triangles that keep their shape are to have the one that they have where their
    //! region is laid in the plane. Regions are never quite flat: there they are without energy.
    std::shared_ptr<const Soup> flatSoup() const { return mSoup->shapedAs(mUnrolled.x, keepsShape()); }

    //! Takes some regions out of a map and lays them in the plane as they are.
    //! \param which per region \param joining also joins them to the rest along hinges, as joined() does
    SeamedMap cutOut(const std::vector<bool> &which, SeamedMap map, bool joining,
                     const JobContext &job = {}) const;

private:
    void findHinges(const Snapshot &snapshot);
    std::vector<bool> overlapThemselves() const;

    std::shared_ptr<const Soup> mSoup;
    std::shared_ptr<const RigidRegions> mRegions;
    Unrolled mUnrolled;
    CutFlags mAlwaysCut;
    std::vector<Hinge> mHinges;
    std::vector<double> mCost; //!< per hinge, of a seam there
};

} // namespace autocuts::rigid
