// Options and result of the job "unwrap".
#pragma once

#include "model/plain/islandflags.h"
#include "solver/base/seamedmap.h"
#include "solver/packing/packing.h"
#include "solver/unwrap/unmetsteering.h"
#include "solver/unwrap/unwrapquality.h"

#include <functional>
#include <optional>

namespace autocuts::unwrap {

struct UnwrapResult;

struct UnwrapOptions
{
    double maxDistortion = 4.1;   //!< bound on the mean symmetric Dirichlet energy, > 4
    std::optional<double> lambda; //!< weight of the separation (paper, equation 1) in place of the bound
    UnwrapQuality quality = UnwrapQuality::Standard;
    bool allowOverlaps = false;
    //! The mesh is the coarse version of another one, whose seams get shortened with those of this one: a
    //! draft tries more.
    bool coarse = false;
    bool pack = true; //!< false: the islands are not packed, and the map is scaled into the first tile
    packing::PackOptions packing;
    //! Receives ever better maps, packed with little effort, while the search goes on. Called from a thread
    //! of its own; what it does has no effect on the result. May be empty.
    std::function<void(const UnwrapResult &)> better;
};

struct UnwrapResult
{
    UvMatrix uv;           //!< per corner, in the first tile or the bin of the packing
    CutFlags cut;          //!< per edge pair
    double distortion = 0; //!< mean symmetric Dirichlet energy, 4 is isometric
    double seamLength = 0; //!< 3D length in solver units (mesh area pi), seam_norm of the reports
    int iterations = 0;    //!< Newton steps of soup and seam search
    //! Lambda and delta of the separation at the end. The seam search has mu / (1 + mu) and 0.
    double lambda = 0, delta = 0;
    bool stopped = false;    //!< the job was stopped: this is the best map until then
    bool withinBound = true; //!< the whole map, or what may change, keeps to the bound
    //! No map was found but one of many near-flat patches: the job was stopped early, or the mesh is odd.
    bool onlyPatches = false;
    double hardShare =
        0; //!< share of the area in parts that count as hard surfaces, see preference/surfacekind.h
    //! Share of the seam length that is symmetric, 0 on a mesh that is not. Set when symmetry is asked for,
    //! and where it is left open and the seams are symmetric.
    std::optional<double> symmetry;
    bool symmetryMissed =
        false; //!< the mesh is symmetric, but no symmetric cuts met the bound: they are free
    //! Set when something was to be straight: false when stopped before all of that was done.
    std::optional<bool> straight;
    //! Per face: the flags of the islands, with the stacks of AlikeMode::Stack. Empty: they stay.
    std::vector<IslandFlags> flags;
    bool upright = false;     //!< the islands were turned as WorldUp::AutoY or AutoZ asks
    bool packed = false;      //!< false when packing was not asked for or there is no room
    bool madeSmaller = false; //!< islands should keep their scale, and there was no room for them
    //! Some of the map stays, by locks, pins, stacks or hidden faces, and no better one was found for the
    //! rest: uv is the map before the job.
    bool nothingGained = false;
    bool nothingFree = false; //!< locks or the scope leave nothing to change: uv is the map before the job
    UnmetSteering unmet;
};

} // namespace autocuts::unwrap
