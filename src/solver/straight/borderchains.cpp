#include "solver/straight/borderchains.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <numeric>

namespace autocuts::straight {

namespace {

// Chosen by hand, by looking at maps of machines and vehicles.
constexpr double degree = std::numbers::pi / 180;
constexpr double straightRange = 20 * degree; //!< the directions of a chain differ by this at most
constexpr double sharpCorner = 15 * degree;   //!< no chain runs across a point at which the border turns more
constexpr double corner = 29 * degree;        //!< a chain ends where the border turns by this,
constexpr double cornerReach = 0.3;           //!< within this share of its length,
constexpr double contrast = 2;                //!< and by this many times the turn along as much of the chain
constexpr double shortest = 0.02;             //!< chain, as a share of the square root of the island's area

//! Finds the chains of one loop.
class LoopChains
{
public:
    LoopChains(const Island::Loop &loop, double least) : mLoop(loop), mLeast(least), mCount(loop.point.size())
    {
        // Begins where the border turns most, so that no chain runs across the beginning.
        mFirst = std::max_element(loop.turn.begin(), loop.turn.end(),
                                  [](double a, double b) { return std::abs(a) < std::abs(b); }) -
                 loop.turn.begin();
        mDirection.assign(mCount, 0);
        mDistance.assign(mCount + 1, 0);
        for (std::size_t i = 0; i < mCount; ++i) {
            if (i > 0)
                mDirection[i] = mDirection[i - 1] + loop.turn[at(i)];
            mDistance[i + 1] = mDistance[i] + loop.length[at(i)];
        }
    }

    void addTo(std::vector<Chain> &chains) const
    {
        std::vector<Run> runs = longestRuns();
        std::stable_sort(runs.begin(), runs.end(),
                         [&](const Run &a, const Run &b) { return lengthOf(a) > lengthOf(b); });
        std::vector<bool> taken(mCount, false);
        for (const Run &run : runs) {
            if (lengthOf(run) < mLeast)
                break;
            const auto first = taken.begin() + static_cast<std::ptrdiff_t>(run.first);
            const auto last = taken.begin() + static_cast<std::ptrdiff_t>(run.last);
            if (std::find(first, last, true) != last || !endsAtCorners(run))
                continue;
            std::fill(first, last, true);
            Chain chain{{}, lengthOf(run)};
            for (std::size_t i = run.first; i <= run.last; ++i)
                chain.points.push_back(mLoop.point[at(i)]);
            chains.push_back(std::move(chain));
        }
    }

private:
    //! Sides from `first` to before `last`.
    struct Run
    {
        std::size_t first, last;
    };

    std::size_t at(std::size_t i) const { return (mFirst + i) % mCount; }
    double lengthOf(const Run &run) const { return mDistance[run.last] - mDistance[run.first]; }

    //! For each side, the longest straight run that ends with it and is no part of the next one.
    std::vector<Run> longestRuns() const
    {
        std::vector<Run> runs;
        std::deque<std::size_t> least, most; // sides whose direction is the least or greatest from there on
        std::size_t first = 0;
        for (std::size_t i = 0; i < mCount; ++i) {
            const std::size_t before = first;
            if (i > 0 && std::abs(mLoop.turn[at(i)]) >= sharpCorner) {
                first = i;
                least.clear();
                most.clear();
            }
            while (!least.empty() && mDirection[least.back()] >= mDirection[i])
                least.pop_back();
            while (!most.empty() && mDirection[most.back()] <= mDirection[i])
                most.pop_back();
            least.push_back(i);
            most.push_back(i);
            while (mDirection[most.front()] - mDirection[least.front()] > straightRange) {
                ++first;
                if (least.front() < first)
                    least.pop_front();
                if (most.front() < first)
                    most.pop_front();
            }
            if (first != before)
                runs.push_back({before, i});
        }
        runs.push_back({first, mCount});
        return runs;
    }

    //! True when the border turns much more at both ends of the run than it does along it.
    bool endsAtCorners(const Run &run) const
    {
        const auto [least, most] =
            std::minmax_element(mDirection.begin() + static_cast<std::ptrdiff_t>(run.first),
                                mDirection.begin() + static_cast<std::ptrdiff_t>(run.last));
        const double bend = contrast * (*most - *least) / lengthOf(run), reach = cornerReach * lengthOf(run);
        const auto endsAt = [&](std::size_t i, int step, std::size_t side) {
            double turned = 0, way = 0;
            for (std::size_t n = run.last - run.first; n < mCount && way <= reach; ++n) {
                turned += mLoop.turn[at(i)];
                if (std::abs(turned) >= corner + bend * way)
                    return true;
                way += mLoop.length[at(i - side)];
                i += static_cast<std::size_t>(step);
            }
            return false;
        };
        return endsAt(run.last, 1, 0) && endsAt(run.first + mCount, -1, 1);
    }

    const Island::Loop &mLoop;
    const double mLeast;
    const std::size_t mCount;
    std::size_t mFirst;
    std::vector<double> mDirection; //!< per side, when the border is developed into the plane
    std::vector<double> mDistance;  //!< of its start from the beginning
};

} // namespace

std::vector<Chain> straightChains(const Island &island)
{
    std::vector<Chain> chains;
    for (const Island::Loop &loop : island.loops)
        LoopChains(loop, shortest * std::sqrt(island.area())).addTo(chains);
    return chains;
}

} // namespace autocuts::straight
