// Makes straight in a map what is straight on the model.
#pragma once

#include "model/plain/packingsettings.h"
#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/base/seamedmap.h"

#include <memory>

namespace autocuts::straight {

//! Which parts of a map are turned or made straight, as the settings ask for it on this mesh.
struct StraightPlan
{
    std::vector<bool> aligned; //!< per connected component, see SolveSettings::align; empty: none
    bool mirror = false;       //!< see SolveSettings::mirrorMaps
    WorldUp up = WorldUp::Off; //!< see SolveSettings::worldUp; AutoY and AutoZ count as Off
    bool loops = false;        //!< the user has chosen edge loops

    static StraightPlan of(const Snapshot &snapshot);
    bool aligns() const { return !aligned.empty(); }
    bool aligns(int component) const { return aligns() && aligned[component]; }
    //! True when it changes shapes of islands.
    bool deforms() const { return aligns() || mirror || loops; }
    bool isEmpty() const { return !deforms() && up == WorldUp::Off; }
    //! The bound for the search of seams: a part of the bound is kept for straightening.
    double searchBound(double maxDistortion) const;
    //! The rotations that keep islands as they were turned.
    PackRotation rotation(PackRotation wanted) const;
};

//! How much is done: islands are only turned, or all that the plan says.
enum class StraightEffort { Turn, Full };

//! Does to a map what a plan asks for. Align: turns the islands to the axes and straightens their borders
//! there, as far as the bound on the distortion allows; of what is too dear, the longest for its price.
//! Mirror: gives symmetric islands a symmetric map about an axis, within the same bound, and islands that are
//! mirror images the mirrored map of the better one. Up: turns islands, by right angles where they are
//! aligned. Chosen loops become straight also without all that. The seams stay as they are, no triangle flips
//! and no island comes to overlap itself. Points of a straightened border have one coordinate exactly in
//! common. Islands with pins stay as they are. The result does not depend on the number of threads.
//! \param maxDistortion bound on the mean symmetric Dirichlet energy of the map at one texel density
//! \returns false when stopped before all was done; then islands that were not reached stay as they are
bool straighten(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, const StraightPlan &plan,
                double maxDistortion, SeamedMap &map, const JobContext &job = {},
                StraightEffort effort = StraightEffort::Full);

//! Brings the charts of a map that nothing holds back to where their centres were in another map with the
//! same charts.
void restoreCentres(const Soup &soup, const Snapshot &snapshot, const SeamedMap &before, SeamedMap &map);

} // namespace autocuts::straight
