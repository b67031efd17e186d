#include "solver/definite/relaxing.h"

#include "solver/energy/boundarybarrier.h"
#include "solver/energy/constraintterms.h"
#include "solver/energy/distortion.h"
#include "solver/newton/minimizer.h"
#include "solver/overlap/overlapfinder.h"

#include <cmath>

namespace autocuts::definite {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Distance below which two places of a boundary repel each other, in mean edge lengths.
constexpr double barrierReach = 0.1;
//! Weight of one contact relative to that of a mean triangle.
constexpr double barrierWeight = 0.05;
//! Least relative change of the energy.
constexpr double stall = 1e-6;

} // namespace

bool coversItself(const Soup &soup, const SeamedMap &map)
{
    const CutMesh state(*soup.mesh, map.cut);
    return !overlap::visitOverlapsWithin(rowsOf(map.x), state.chart, {},
                                         [](int, int, double) { return false; });
}

int relaxWithoutOverlaps(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map,
                         int steps, const JobContext &job)
{
    const CutMesh state(*soup->mesh, map.cut);
    const auto distortion = energy::makeDistortionTerm(soup, snapshot.settings.energy);
    const energy::BoundaryBarrierTerm barrier(*soup, state, map.x, barrierWeight / soup->triangleCount(),
                                              barrierReach * soup->meanEdgeLength);
    const energy::PinTerm pins(snapshot.steering->pins);
    newton::Minimizer minimizer(soup,
                                newton::makeExactDirection(soup, {state.uvVertex, state.uvVertexCount}));
    minimizer.setTerms({distortion.get(), &barrier, &pins});
    if (!std::isfinite(minimizer.energy(map.x)))
        return 0;
    int done = 0;
    while (done < steps && !job.stopped()) {
        const newton::Minimizer::Step step = minimizer.step(map.x);
        job.addWork(soup->triangleCount());
        ++done;
        if (step.before - step.after <= stall * std::abs(step.before))
            break;
    }
    return done;
}

} // namespace autocuts::definite
