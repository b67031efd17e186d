#include "solver/unwrap/finishjob.h"

#include "model/plain/uvlayout.h"
#include "solver/definite/refinedmap.h"
#include "solver/definite/seamopening.h"
#include "solver/homotopy/liveschedule.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/preference/seampreference.h"

#include <algorithm>

namespace autocuts::unwrap {

namespace {

//! Delta of the separation energy for a given map, solver units squared: corners much nearer to each other
//! than its square root count as joined. Chosen by hand far above rounding and far below the edge lengths.
constexpr double touchingDelta = 1e-9;
//! Rough number of steps of a live solve. A guess that only the progress depends on.
constexpr double usualSteps = 1000;

void load(const FinishInput &input, int threads, homotopy::Solver &solver)
{
    Snapshot snapshot = input.snapshot;
    if (input.live) {
        snapshot.settings.lambda = input.live->lambda;
        snapshot.settings.delta = input.live->delta;
    } else {
        snapshot.settings.start = StartMode::ExistingUv;
        snapshot.settings.delta = touchingDelta;
        snapshot.startUv = std::make_shared<const UvMatrix>(soupUv(*snapshot.mesh, input.uv) / input.uvScale);
    }
    solver.setThreads(threads);
    solver.load(preference::SeamPreference().applied(snapshot, threads));
    if (input.live)
        solver.setCoordinates(input.live->coordinates);
}

//! True when all islands lie in the unit square and no triangles overlap.
bool liesFree(const MeshData &mesh, const UvMatrix &uv, const JobContext &job)
{
    overlap::OverlapOptions options;
    options.maxPairs = 1;
    options.job = job.quiet();
    return uv.minCoeff() >= 0 && uv.maxCoeff() <= 1 &&
           overlap::findOverlaps(soupUv(mesh, uv), options).pairs.empty();
}

} // namespace

FinishResult finishMap(const FinishInput &input, const JobContext &job)
{
    const MeshData &mesh = *input.snapshot.mesh;
    homotopy::Solver solver;
    load(input, job.threads(), solver);
    double begun = 0;
    if (input.live && input.live->hasMoreToDo) {
        int steps = 0;
        const JobContext toTheEnd = job.part(0, 1, JobStage::SolvingToTheEnd);
        homotopy::runToTheEnd(solver, input.maxDistortion, job, [&] {
            ++steps;
            begun = 0.5 * steps / (steps + usualSteps); // the number of steps is not known beforehand
            toTheEnd.report(begun);
        });
    }
    FinishResult result;
    const std::optional<SeamedMap> map =
        definite::makeRefinedMap(solver, {.maxDistortion = input.maxDistortion}, job.part(begun, 1));
    if (!map)
        return result;
    result.uv = input.uvScale * cornerUv(solver.soup(), *map);
    result.distortion = map->distortion(solver.soup());
    // Islands that grew or were cut off may overlap others. Where pins or rectangles place islands they stay.
    if (!input.snapshot.placesIslands() && !liesFree(mesh, result.uv, job)) {
        const bool packed = packCharts(mesh, findCharts(mesh, result.uv), {.options = input.packing},
                                       result.uv, job.part(0, 1, JobStage::Packing));
        result.noRoom = !packed && !job.stopped();
    }
    definite::openCuts(input.snapshot, result.uv);
    const std::vector<PairState> &states = input.snapshot.steering->pairState;
    const bool joins = std::find(states.begin(), states.end(), PairState::Joined) != states.end();
    result.heldTogether =
        joins && !result.noRoom && !overlap::findOverlaps(soupUv(mesh, result.uv)).pairs.empty();
    return result;
}

} // namespace autocuts::unwrap
