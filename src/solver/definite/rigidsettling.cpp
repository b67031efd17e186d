#include "solver/definite/rigidsettling.h"

#include "solver/base/constant.h"
#include "solver/definite/relaxing.h"
#include "solver/rigid/nets.h"
#include "solver/search/bentregions.h"
#include "solver/search/seamsearch.h"
#include "solver/search/trianglekernel.h"

#include <algorithm>

namespace autocuts::definite {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Factor on the stiffness of rigid regions, beside that of the search.
AUTOCUTS_CONSTANT(double, finalStiffness, 100);
AUTOCUTS_CONSTANT(int, settlingSteps, 30); // Newton steps
constexpr int mostRounds = 3;              // of cutting out what bends, or bends after that
constexpr double atRest = 1e-9;    // energy of a triangle that has its shape, above that of an isometry
constexpr int settlingMoves = 100; // large moves when seams have to be opened

bool any(const std::vector<bool> &flags)
{
    return std::find(flags.begin(), flags.end(), true) != flags.end();
}

//! True for a triangle of a rigid region that is not an isometry in the map.
bool losesShape(const Soup &soup, const RigidRegions &regions, const std::vector<double> &x, int t)
{
    return regions.region[t] >= 0 &&
           search::triangleEnergy(&x[6 * static_cast<std::size_t>(t)], soup.basis[t]) > 4 + atRest;
}

bool anyLosesShape(const Soup &soup, const RigidRegions &regions, const std::vector<double> &x)
{
    for (int t = 0; t < soup.triangleCount(); ++t) {
        if (losesShape(soup, regions, x, t))
            return true;
    }
    return false;
}

//! The search with stiffer regions that are flat, see settleRigidRegions().
class Settling
{
public:
    Settling(const search::SeamGraph &graph, const Snapshot &snapshot, const search::OptimizeOptions &options,
             double mu, double bound)
        : mOptions(options), mPlain(*graph.soup), mNets(graph.soup, snapshot), mMu(mu), mBound(bound)
    {
        const auto stiff = std::make_shared<search::SeamGraph>(graph);
        stiff->soup = mNets.flatSoup();
        stiff->rigid = stiffened(*snapshot.rigid);
        mGraph = stiff;
    }

    SeamedMap settled(const SeamedMap &found) const
    {
        SeamedMap map = relaxed(found, false);
        const std::vector<bool> bent = bentRegions(map);
        std::vector<bool> still = bent;
        for (int round = 0; round < mostRounds && any(still); ++round) {
            // Where hinges stretch a region, it bends again: then it stays by itself.
            map = relaxed(cutOut(still, map, round == 0), true);
            still = bentRegions(map);
        }
        if (fits(map))
            return map;
        // The rest cannot take over what the regions had of the stretch: cuts in it may help, or around them.
        std::vector<SeamedMap> starts{map};
        if (const std::vector<bool> before = bentRegions(found); !any(bent) && any(before))
            starts.push_back(cutOut(before, map, true));
        return takenToBound(std::move(starts)).value_or(found);
    }

    bool fits(const SeamedMap &map) const
    {
        return (mOptions.mu || map.distortion(mPlain) <= mBound) &&
               (mOptions.allowOverlaps || !coversItself(mPlain, map));
    }

private:
    std::shared_ptr<const RigidRegions> stiffened(const RigidRegions &regions) const
    {
        const auto stiff = std::make_shared<RigidRegions>(regions);
        const std::vector<bool> keeps = mNets.keepsShape();
        const double soft = *std::min_element(stiff->stiffness.begin(), stiff->stiffness.end());
        for (std::size_t t = 0; t < stiff->stiffness.size(); ++t) {
            const int r = regions.region[t];
            const bool isStiff = keeps[t] || (r >= 0 && regions.curved[r]);
            stiff->stiffness[t] = isStiff ? finalStiffness * stiff->stiffness[t] : soft;
        }
        return stiff;
    }

    SeamedMap relaxed(const SeamedMap &map, bool absorbing) const
    {
        search::CutState state = search::CutState::from(mGraph, map, true);
        search::SeamSearch search(state, mOptions.seed, {mMu, !mOptions.allowOverlaps, mOptions.job.quiet()});
        if (!mGraph->anchors.empty())
            search.anchor(); // regions give way to hard pins
        search.relaxCharts(unsettledCharts(state), settlingSteps);
        if (absorbing) {
            search.absorbSmallCharts();
            search.relaxCharts(unsettledCharts(state), settlingSteps);
        }
        return state.map();
    }

    //! The charts that may change: in others there is nothing left to relax.
    std::vector<char> unsettledCharts(const search::CutState &state) const
    {
        std::vector<char> found(state.chartCount(), 0);
        for (int t = 0; t < mGraph->triangleCount(); ++t)
            found[state.chart[t]] |= losesShape(mPlain, *mGraph->rigid, state.x, t);
        return found;
    }

    //! Per region: true when it has lost its shape in a map and may be cut out.
    std::vector<bool> bentRegions(const SeamedMap &map) const
    {
        const Soup &soup = *mGraph->soup;
        const RigidRegions &regions = *mGraph->rigid;
        if (!mGraph->anchors.empty())
            return std::vector<bool>(regions.count, false);
        std::vector<bool> bent = search::bentRegions(soup, regions, map.x);
        for (std::size_t e = 0; e < mGraph->rule.size(); ++e) {
            const EdgePair &pair = soup.mesh->edgePairs[e];
            for (const int t : pair.triangle) {
                const int r = regions.region[t];
                if (r >= 0 && !pair.diagonal && mGraph->rule[e] == search::SeamGraph::Rule::NeverCut)
                    bent[r] = false;
            }
        }
        return bent;
    }

    //! \param joining along hinges, unless charts would overlap themselves
    SeamedMap cutOut(const std::vector<bool> &bent, const SeamedMap &map, bool joining) const
    {
        SeamedMap apart = mNets.cutOut(bent, map, joining, mOptions.job);
        mGraph->makeSymmetric(apart.cut);
        if (joining && !mOptions.allowOverlaps && coversItself(mPlain, apart))
            return cutOut(bent, map, false);
        return apart;
    }

    std::optional<SeamedMap> takenToBound(std::vector<SeamedMap> starts) const
    {
        search::OptimizeOptions again = mOptions;
        again.given = std::move(starts);
        again.effort.seeds = 0;
        again.effort.rounds = {{settlingMoves, 1}};
        again.start = {};
        again.progress = {};
        again.improved = {};
        std::optional<search::OptimizedMap> found = search::optimizeSeams(mGraph, again);
        return found ? std::optional(std::move(found->map)) : std::nullopt;
    }

    const search::OptimizeOptions &mOptions;
    const Soup &mPlain;
    const rigid::Nets mNets;
    const double mMu, mBound;
    std::shared_ptr<const search::SeamGraph> mGraph; //!< with stiffer regions that are flat
};

} // namespace

SeamedMap settleRigidRegions(const std::shared_ptr<const search::SeamGraph> &graph, const Snapshot &snapshot,
                             const search::OptimizeOptions &options, SeamedMap map, double mu)
{
    if (!snapshot.rigid || options.job.stopped() || !anyLosesShape(*graph->soup, *snapshot.rigid, map.x))
        return map;
    const double bound = std::max(options.maxDistortion, map.distortion(*graph->soup));
    const Settling settling(*graph, snapshot, options, mu, bound);
    SeamedMap settled = settling.settled(map);
    return settling.fits(settled) && !options.job.stopped() ? std::move(settled) : std::move(map);
}

} // namespace autocuts::definite
