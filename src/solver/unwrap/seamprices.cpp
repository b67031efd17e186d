#include "solver/unwrap/seamprices.h"

#include "model/plain/parallel.h"
#include "solver/preference/seampreference.h"
#include "solver/search/resteering.h"
#include "solver/search/seamsearch.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/mapbefore.h"

#include <algorithm>
#include <atomic>

namespace autocuts::unwrap {

namespace {

// Chosen by hand.
constexpr int seamlessSteps = 40;  // Newton steps on the map without a seam
constexpr int proposalTries = 60;  // new seams that are tried for one proposal
constexpr double proposalMu = 0.1; // see SearchOptions

//! The map relaxed with the seams that it has.
void relax(search::CutState &state, const JobContext &job)
{
    search::SeamTrial trial(state);
    trial.relaxAll(seamlessSteps, true, job);
}

class SeamPricing
{
public:
    SeamPricing(const FreePart &part, const SeamedMap &map, bool onlyGiven, const JobContext &job)
        : mPart(part), mJob(job), mOnlyGiven(onlyGiven)
    {
        mProblem = preference::SeamPreference().applied(part.withoutRectangles(), job.threads());
        mProblem.rigid = nullptr; // prices are in the distortion that users see
        // With SeamMode::Only all edges but the given ones are joined, also those of seams that had to be
        // added.
        std::vector<PairState> &states = mProblem.editSteering().pairState;
        for (std::size_t e = 0; onlyGiven && !states.empty() && e < map.cut.size(); ++e) {
            if (map.cut[e] && mProblem.isJoined(e))
                states[2 * e] = states[2 * e + 1] = PairState::Free;
        }
        mSoup = Soup::build(mProblem.mesh);
        mGraph = search::SeamGraph::build(mSoup, mProblem);
        mState = search::CutState::from(mGraph, map, true);
        relax(mState, job);
    }

    double distortion() const { return mState.distortion; }

    std::vector<SeamPrice> seams() const
    {
        std::vector<std::vector<int>> chains;
        std::vector<char> seen(mState.cut.size(), 0);
        for (std::size_t e = 0; e < mState.cut.size(); ++e) {
            if (!mState.cut[e] || seen[e])
                continue;
            chains.push_back({});
            for (const int edge : search::chainOf(mState, static_cast<int>(e)).edges) {
                seen[edge] = 1;
                if (!mOnlyGiven || mGraph->rule[edge] == search::SeamGraph::Rule::AlwaysCut)
                    chains.back().push_back(edge);
            }
            if (chains.back().empty())
                chains.pop_back();
        }
        std::vector<SeamPrice> prices(chains.size());
        std::atomic<int> done = 0;
        parallelFor(static_cast<int>(chains.size()), mJob.threads(), [&](int i) {
            if (!mJob.stopped())
                prices[i] = priceOf(chains[i]);
            mJob.report(double(++done) / static_cast<double>(chains.size()));
        });
        std::erase_if(prices, [](const SeamPrice &price) { return price.edges.empty(); });
        std::stable_sort(prices.begin(), prices.end(), [this](const SeamPrice &a, const SeamPrice &b) {
            return a.distortion.has_value() != b.distortion.has_value() ? a.distortion.has_value()
                                                                        : perLength(a) < perLength(b);
        });
        return prices;
    }

    std::optional<SeamPrice> proposal() const
    {
        // Where only given seams may be seams, all other edges are joined: then no new seam could be
        // proposed.
        Snapshot open = mProblem;
        std::vector<PairState> &states = open.editSteering().pairState;
        if (mOnlyGiven)
            std::replace(states.begin(), states.end(), PairState::Joined, PairState::Free);
        search::CutState state = mState;
        state.graph = mGraph->steeredBy(open);
        search::SeamSearch search(state, open.settings.seed, {proposalMu, true, mJob.quiet()});
        SeamPrice price;
        for (const int e : search.bestNewSeam(proposalTries)) {
            price.edges.push_back(mPart.wholeEdge(e));
            price.length += mGraph->length[e];
            state.cut[e] = 1;
        }
        if (price.edges.empty() || mJob.stopped())
            return std::nullopt;
        state.updateTopology();
        state.spreadCharts();
        relax(state, mJob);
        price.distortion = state.distortion;
        return price;
    }

private:
    //! Distortion that dropping the seam adds per length that it saves.
    double perLength(const SeamPrice &price) const
    {
        return price.distortion ? (*price.distortion - mState.distortion) / std::max(price.length, 1e-12) : 0;
    }

    SeamPrice priceOf(const std::vector<int> &chain) const
    {
        SeamPrice price;
        for (const int e : chain) {
            price.edges.push_back(mPart.wholeEdge(e));
            price.length += mGraph->length[e];
        }
        Snapshot without = mProblem;
        std::vector<PairState> &states = without.editSteering().pairState;
        states.resize(mProblem.mesh->cornerPairCount(), PairState::Free);
        for (const int e : chain)
            states[2 * e] = states[2 * e + 1] = PairState::Joined;
        std::optional<search::CutState> state =
            search::resteered(mState, mGraph->steeredBy(without), mJob.quiet());
        if (!state)
            return price;
        const double saved = mState.length - state->length;
        if (!(saved > 0))
            return price;
        relax(*state, mJob);
        price.length = saved;
        price.distortion = state->distortion;
        return price;
    }

    const FreePart &mPart;
    const JobContext &mJob;
    const bool mOnlyGiven;
    Snapshot mProblem;
    std::shared_ptr<const Soup> mSoup;
    std::shared_ptr<const search::SeamGraph> mGraph;
    search::CutState mState;
};

} // namespace

SeamPrices priceSeams(const Snapshot &snapshot, const JobContext &job)
{
    SeamPrices prices;
    const std::optional<FreePart> part = FreePart::of(snapshot);
    if (!part)
        return prices;
    const std::shared_ptr<const Soup> soup = Soup::build(part->snapshot().mesh);
    const bool onlyGiven = snapshot.settings.seams != SeamMode::Free;
    const bool joinsOthers = snapshot.settings.seams == SeamMode::Only;
    const std::optional<SeamedMap> map = mapBefore(*soup, part->snapshot(), joinsOthers);
    prices.hasMap = map.has_value();
    if (!map)
        return prices;
    const SeamPricing pricing(*part, *map, onlyGiven, job);
    prices.distortion = pricing.distortion();
    prices.seams = pricing.seams();
    prices.proposal = pricing.proposal();
    return prices;
}

} // namespace autocuts::unwrap
