// Checks the mesh and the options of a call and makes of them what the jobs of the engine take.
#pragma once

#include "model/plain/packingsettings.h"
#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/unwrap/unwrapoptions.h"

#include <autocuts/autocuts.h>

#include <atomic>
#include <functional>

namespace autocuts::api {

//! What a call works on. Not to be moved: the context refers to it.
struct Job
{
    Snapshot snapshot;
    unwrap::UnwrapOptions options;              //!< with the packing
    double density = 0;                         //!< texels per unit; 0: the islands fill one tile
    std::function<void(autocuts_map *)> better; //!< takes each better map; empty: nobody wants them
    std::atomic<bool> stop = false;
    JobContext context;
};

//! Whether a call works on the map that is there.
enum class MapNeed { None, Needed };

//! The options of the caller, those of older versions with defaults for what they lack.
autocuts_options optionsOf(const autocuts_options *options);
SolveSettings settingsOf(const autocuts_options &options);
PackingSettings packingOf(const autocuts_options &options);

//! Calls of a caller's progress function set the flag when it says so. Null: nobody listens.
JobContext::Sink sinkOf(autocuts_progress progress, void *user, std::atomic<bool> &stop);

//! \throws Failure for what cannot be used
void fill(const autocuts_mesh *mesh, const autocuts_options *options, MapNeed need, Job &job);

} // namespace autocuts::api
