#include "solver/straight/straightening.h"

#include "model/plain/parallel.h"
#include "solver/base/cornerat.h"
#include "solver/definite/definitemap.h"
#include "solver/preference/seampreference.h"
#include "solver/search/bentregions.h"
#include "solver/straight/chosenchains.h"
#include "solver/straight/islandlevels.h"
#include "solver/straight/islandmirror.h"
#include "solver/straight/turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace autocuts::straight {

namespace {

// Numbers in this file without another source were chosen by hand.

constexpr double leastEnergy = 4; //!< of a mean triangle
//! Share of the room below the bound that the search of seams may use. Measured on truck, beetle, teapot and
//! the machine sample: seams are 1.00 to 1.06 times as long with .85, up to 1.23 times with .7, where no more
//! becomes straight.
constexpr double searchShare = 0.85;
//! Most distortion for straightening, however large the bound is.
constexpr double mostSpent = 0.15;
constexpr double smallerBudget = 0.9; //!< factor when the whole map is above the bound
constexpr int mostStraightenings = 20;
// The same after a stop.
constexpr double hurriedBudget = 0.5;
constexpr int hurriedTries = 3;
//! How much stiffer a rigid region is than the rest, as in the search.
constexpr double rigidStiffness = 1000;

//! Per triangle: true in a rigid region that has its shape in the map. Empty: there is none.
std::vector<bool> shapesThatStay(const Soup &soup, const Snapshot &snapshot, const SeamedMap &map)
{
    const std::shared_ptr<const RigidRegions> regions =
        snapshot.rigid ? snapshot.rigid : preference::SeamPreference().applied(snapshot).rigid;
    if (!regions)
        return {};
    const std::vector<bool> bent = search::bentRegions(soup, *regions, map.x);
    std::vector<bool> stays(regions->region.size());
    for (std::size_t t = 0; t < stays.size(); ++t)
        stays[t] = regions->region[t] >= 0 && !bent[regions->region[t]];
    return stays;
}

//! The levels of an island that are worth their energy: each next one costs more for each length gained.
std::vector<Level> worthwhile(std::vector<Level> levels)
{
    std::stable_sort(levels.begin() + 1, levels.end(),
                     [](const Level &a, const Level &b) { return a.gain < b.gain; });
    const auto price = [](const Level &from, const Level &to) {
        return (to.energy - from.energy) / std::max(to.gain - from.gain, 1e-12);
    };
    std::vector<Level> hull;
    for (Level &level : levels) {
        while (hull.size() > 1 && price(hull[hull.size() - 2], hull.back()) >= price(hull.back(), level))
            hull.pop_back();
        hull.push_back(std::move(level));
    }
    return hull;
}

//! Per island: the level that it gets. Those that gain the most for their energy come first.
std::vector<std::size_t> chosenLevels(const std::vector<std::vector<Level>> &islands, double budget)
{
    struct Step
    {
        int island;
        double cost, price;
    };
    std::vector<Step> steps;
    for (std::size_t i = 0; i < islands.size(); ++i) {
        for (std::size_t l = 1; l < islands[i].size(); ++l) {
            const Level &from = islands[i][l - 1], &to = islands[i][l];
            const double cost = std::max(0.0, to.energy - from.energy);
            steps.push_back({static_cast<int>(i), cost, cost / std::max(to.gain - from.gain, 1e-12)});
        }
    }
    std::stable_sort(steps.begin(), steps.end(),
                     [](const Step &a, const Step &b) { return a.price < b.price; });
    std::vector<std::size_t> chosen(islands.size(), 0);
    std::vector<bool> ended(islands.size(), false);
    for (const Step &step : steps) {
        ended[step.island] = ended[step.island] || step.cost > budget;
        if (ended[step.island])
            continue;
        budget -= step.cost;
        ++chosen[step.island];
    }
    return chosen;
}

//! Straightens the islands of one map.
class Straightening
{
public:
    Straightening(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, const StraightPlan &plan,
                  const SeamedMap &map, StraightEffort effort)
        : mSoup(soup), mSnapshot(snapshot), mPlan(plan), mEffort(effort), mMap(map),
          mCharts(*soup->mesh, map.cut), mIslands(islandsOf(*soup, mCharts, map.x)), mLevels(mIslands.size())
    {
        const std::vector<bool> stays = shapesThatStay(*soup, snapshot, map);
        for (Island &island : mIslands) {
            for (std::size_t i = 0; i < island.triangles.size() && !stays.empty(); ++i)
                island.stiffness.push_back(stays[island.triangles[i]] ? rigidStiffness : 1);
        }
    }

    SeamedMap run(double maxDistortion, const JobContext &job)
    {
        const double before = mMap.distortion(*mSoup);
        findLevels(std::clamp(maxDistortion - leastEnergy, 0.0, mostSpent), job);
        const bool stopped = job.stopped();
        if (stopped &&
            std::all_of(mLevels.begin(), mLevels.end(), [](const auto &own) { return own.empty(); }))
            return mMap;
        const int tries = stopped ? hurriedTries : mostStraightenings;
        double budget = std::clamp(maxDistortion - freeEnergy(), 0.0, mostSpent);
        for (int attempt = 0; attempt < tries; ++attempt, budget *= stopped ? hurriedBudget : smallerBudget) {
            SeamedMap straight = mapFor(budget);
            if (straight.distortion(*mSoup) <= std::max(maxDistortion, before) &&
                straight.validate(*mSoup).empty())
                return straight;
        }
        return mMap;
    }

private:
    void findLevels(double most, const JobContext &job)
    {
        const std::vector<bool> pinned = heldCharts(mSnapshot, mCharts);
        const auto isHeld = [&](int i) { return !pinned.empty() && pinned[i]; };
        const std::vector<std::vector<Chain>> chosen =
            chosenChains(*mSoup, mCharts, mIslands, mSnapshot.steering->straightLoops);
        if (mPlan.mirror && mEffort == StraightEffort::Full)
            mMirrors = mirrorsOf(*mSoup->mesh, mIslands, job);
        mMirrors.resize(mIslands.size());
        mOriginal.assign(mIslands.size(), -1);
        for (int i = 0; i < static_cast<int>(mIslands.size()); ++i) {
            const int other = mMirrors[i].island;
            if (other > i && mMirrors[other].island == i && !isHeld(i) && !isHeld(other) &&
                chosen[i].empty() && chosen[other].empty())
                pairUp(i, other);
        }
        parallelFor(static_cast<int>(mIslands.size()), job.threads(), [&](int i) {
            if (!isHeld(i) && mOriginal[i] < 0 && !job.stopped())
                mLevels[i] = worthwhile(levelsOf(i, chosen[i], most, job.alone()));
        });
    }

    //! Makes the worse of two islands a copy of the other one.
    void pairUp(int one, int other)
    {
        const double energyOfOne = mIslands[one].energy(mIslands[one].position);
        const double energyOfOther = mIslands[other].energy(mIslands[other].position);
        const int original = energyOfOne <= energyOfOther ? one : other;
        const int copy = original == one ? other : one;
        if (std::isfinite(mIslands[copy].energy(mirrored(copy, mIslands[original].position))))
            mOriginal[copy] = original;
    }

    //! An island's positions from those of its mirror image.
    Positions mirrored(int island, const Positions &original) const
    {
        Positions positions;
        for (const int p : mMirrors[island].points)
            positions.emplace_back(-original[p].x(), original[p].y());
        return positions;
    }

    std::vector<Level> levelsOf(int i, const std::vector<Chain> &chosen, double most, const JobContext &job)
    {
        Island &island = mIslands[i];
        if (!chosen.empty())
            island.stiffness.clear(); // what users choose comes before the shape of flat faces
        std::vector<Chain> chains = chosen;
        const bool aligns = mPlan.aligns(mSoup->mesh->component[island.triangles.front()]);
        if (aligns) {
            const std::vector<Chain> own = straightChains(island);
            chains.insert(chains.end(), own.begin(), own.end());
        }
        std::vector<Level> levels;
        if (mMirrors[i].island == i)
            levels = symmetricLevels(i, chains, most, job);
        if (levels.empty()) {
            if (aligns || !chosen.empty())
                turnIfValid(island, angleToAxes(island, chosen.empty() ? chains : chosen));
            if (mEffort == StraightEffort::Full && (aligns || !chains.empty()))
                levels = islandLevels(island, chains, {}, most, job);
            else
                levels = {{island.energy(island.position), 0, island.position}};
        }
        const auto copy = std::find(mOriginal.begin(), mOriginal.end(), i);
        if (copy != mOriginal.end())
            countTwice(levels, static_cast<int>(copy - mOriginal.begin()));
        return levels;
    }

    //! Rounding may turn over a triangle that is very thin.
    static void turnIfValid(Island &island, double angle)
    {
        Positions turned = island.position;
        turn(turned, angle);
        if (std::isfinite(island.energy(turned)))
            island.position = std::move(turned);
    }

    //! The levels of a symmetric island, after the map as it is; none when it cannot be made symmetric.
    std::vector<Level> symmetricLevels(int i, const std::vector<Chain> &chains, double most,
                                       const JobContext &job)
    {
        Island island = mIslands[i];
        placeAtAxis(island.position, mMirrors[i].points);
        if (!std::isfinite(island.energy(island.position)))
            return {};
        std::vector<Level> levels = islandLevels(island, chains, mMirrors[i].points, most, job);
        if (levels.empty())
            return levels;
        double border = 0;
        for (const Island::Loop &loop : island.loops)
            border = std::accumulate(loop.length.begin(), loop.length.end(), border);
        for (Level &level : levels)
            level.gain += border;
        levels.insert(levels.begin(), {island.energy(island.position), 0, island.position});
        return levels;
    }

    //! The levels of an island with a copy: those that are valid there, too.
    void countTwice(std::vector<Level> &levels, int copy) const
    {
        const auto isInvalid = [&](const Level &level) {
            return !std::isfinite(mIslands[copy].energy(mirrored(copy, level.position)));
        };
        levels.erase(std::remove_if(levels.begin() + 1, levels.end(), isInvalid), levels.end());
        for (Level &level : levels) {
            level.energy *= 2;
            level.gain *= 2;
        }
    }

    //! The energy of the map without any line.
    double freeEnergy() const
    {
        double sum = 0;
        for (std::size_t i = 0; i < mIslands.size(); ++i) {
            if (mOriginal[i] < 0)
                sum +=
                    mLevels[i].empty() ? mIslands[i].energy(mIslands[i].position) : mLevels[i].front().energy;
        }
        return sum;
    }

    SeamedMap mapFor(double budget) const
    {
        SeamedMap straight = mMap;
        const std::vector<std::size_t> chosen = chosenLevels(mLevels, budget);
        for (int i = 0; i < static_cast<int>(mIslands.size()); ++i) {
            const int from = mOriginal[i] < 0 ? i : mOriginal[i];
            if (mLevels[from].empty())
                continue;
            Positions positions = mLevels[from][chosen[from]].position;
            if (from != i)
                positions = mirrored(i, positions);
            turnUp(mIslands[i], positions);
            store(mIslands[i], positions, straight.x);
        }
        definite::equalizeDensity(*mSoup, mSnapshot, straight);
        return straight;
    }

    void turnUp(const Island &island, Positions &positions) const
    {
        if (mPlan.up == WorldUp::Off)
            return;
        const double angle = angleToUp(*mSoup, island, positions, mPlan.up);
        if (mPlan.deforms())
            turnQuarters(positions, static_cast<int>(std::lround(angle / (std::numbers::pi / 2))));
        else
            turn(positions, angle);
    }

    const std::shared_ptr<const Soup> &mSoup;
    const Snapshot &mSnapshot;
    const StraightPlan &mPlan;
    const StraightEffort mEffort;
    const SeamedMap &mMap;
    const CutMesh mCharts;
    std::vector<Island> mIslands;
    std::vector<IslandMirror> mMirrors;      //!< per island
    std::vector<int> mOriginal;              //!< per island: the one whose mirrored map it gets; -1: none
    std::vector<std::vector<Level>> mLevels; //!< per island; none when it stays, or is a copy
};

} // namespace

StraightPlan StraightPlan::of(const Snapshot &snapshot)
{
    const SolveSettings &settings = snapshot.settings;
    const bool turns = settings.worldUp == WorldUp::Y || settings.worldUp == WorldUp::Z;
    return {preference::alignedParts(settings, *snapshot.mesh), settings.mirrorMaps,
            turns ? settings.worldUp : WorldUp::Off, !snapshot.steering->straightLoops.empty()};
}

double StraightPlan::searchBound(double maxDistortion) const
{
    const double kept = std::min((1 - searchShare) * (maxDistortion - leastEnergy), mostSpent);
    return deforms() ? maxDistortion - kept : maxDistortion;
}

PackRotation StraightPlan::rotation(PackRotation wanted) const
{
    if (up != WorldUp::Off)
        return PackRotation::None;
    return deforms() && directionsOf(wanted) % 4 == 0 ? PackRotation::Quarter : wanted;
}

bool straighten(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, const StraightPlan &plan,
                double maxDistortion, SeamedMap &map, const JobContext &job, StraightEffort effort)
{
    if (plan.isEmpty())
        return true;
    map = Straightening(soup, snapshot, plan, map, effort).run(maxDistortion, job);
    return !job.stopped();
}

void restoreCentres(const Soup &soup, const Snapshot &snapshot, const SeamedMap &before, SeamedMap &map)
{
    const CutMesh charts(*soup.mesh, map.cut);
    const std::vector<bool> held = heldCharts(snapshot, charts);
    const int corners = soup.mesh->soupCornerCount();
    std::vector<Vec2> way(charts.chartCount, Vec2::Zero());
    std::vector<int> count(charts.chartCount, 0);
    for (int c = 0; c < corners; ++c) {
        way[charts.chart[c / 3]] += cornerAt(before.x, c) - cornerAt(map.x, c);
        ++count[charts.chart[c / 3]];
    }
    for (int c = 0; c < corners; ++c) {
        const int chart = charts.chart[c / 3];
        if (held.empty() || !held[chart])
            cornerAt(map.x, c) += way[chart] / count[chart];
    }
}

} // namespace autocuts::straight
