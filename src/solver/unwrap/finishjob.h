// The job "finish" of the window and the command line: makes a usable map of a live solve or of a given map.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/unmetsteering.h"

#include <optional>

namespace autocuts::unwrap {

//! State of the solver when a live solve was paused.
struct LiveState
{
    std::vector<double> coordinates{}; //!< of the soup, see Soup
    double lambda = 0, delta = 0;
    bool hasMoreToDo = false; //!< paused before the end of the schedule
};

struct FinishInput
{
    Snapshot snapshot{};             //!< with the map to finish
    std::optional<LiveState> live{}; //!< the live solve that the map was made from
    double maxDistortion = 4.1;      //!< bound on the mean symmetric Dirichlet energy, > 4
    packing::PackOptions packing{};  //!< used when islands overlap or leave their place
};

struct FinishResult
{
    UvMatrix uv;                //!< per corner, texture space; no rows when stopped before there was a map
    double distortion = 0;      //!< of the whole map: UvMetrics::tileDirichlet
    bool withinBound = false;   //!< the whole map, or what may change, keeps to the bound
    bool noRoom = false;        //!< the islands had to be packed and there is no room for them
    bool madeSmaller = false;   //!< there was no room at their scale: the islands of some tiles are smaller
    bool nothingGained = false; //!< no better map was found: uv is the map before the job
    int notReplaced = 0;        //!< islands that stay as they were, because there is no room for better ones
    //! The map still has overlaps; edges joined by the user prevent cutting them apart.
    bool heldTogether = false;
    //! Set when something was to be straight: false when stopped before all of that was done.
    std::optional<bool> straight;
    bool nothingFree = false; //!< locks or the scope leave nothing to change: uv is the map before the job
    UnmetSteering unmet;
};

//! The whole finish: runs a paused solve to the end of its schedule, makes the refined map (a definite map
//! whose seams the seam search has improved), and packs when islands overlap or leave their tile or
//! rectangle. Without a live solve it starts from the seams of the given map, and islands of a document keep
//! their scale, direction and place, see keepPlaces(). \pre the snapshot has a map
[[nodiscard]] FinishResult finishMap(const FinishInput &input, const JobContext &job = {});

} // namespace autocuts::unwrap
