#include "solver/straight/islandlevels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace autocuts::straight {

namespace {

// Chosen by hand.
constexpr int newtonSteps = 10;
constexpr double nearAxisSine = 0.5; //!< sine of the angle to an axis below which a chain is to run along it
constexpr double diagonalGain = 0.1; //!< what a straight chain counts that runs along no axis
constexpr double chosenGain = 1000;  //!< factor on what a chain counts that the user has chosen
constexpr double kept = 0.6;         //!< share of the cost that the next level may have
constexpr double leastCost = 1e-9;   //!< energy that counts as none
//! How many combinations of lines are tried: triangles of all of them together, and the least and most.
constexpr int triedTriangles = 300'000, fewestTries = 10, mostTries = 500;

//! A chain as a line of the map.
struct Candidate
{
    const Chain *chain;
    Vec2 normal;
    bool alongAxis;
    double way = 0; //!< the farthest that one of its points has to go

    double gain() const
    {
        return chain->length * (alongAxis ? 1 : diagonalGain) * (chain->chosen ? chosenGain : 1);
    }
};

//! From the first point of a chain to the last one; zero when these are one.
Vec2 directionOf(const Chain &chain, const Positions &at)
{
    return (at[chain.points.back()] - at[chain.points.front()]).normalized();
}

//! Where more than two lines meet, the first ones count.
bool countsBefore(const Candidate &a, const Candidate &b)
{
    return a.alongAxis != b.alongAxis ? a.alongAxis : a.gain() > b.gain();
}

class LevelMaker
{
public:
    LevelMaker(const Island &island, const MirrorPoints &mirror, double most, const JobContext &job)
        : mIsland(island), mMirror(mirror), mMost(most), mJob(job),
          mTries(
              std::clamp(triedTriangles / static_cast<int>(island.triangles.size()), fewestTries, mostTries))
    {}

    std::vector<Level> make(const std::vector<Chain> &chains)
    {
        std::optional<Level> free = solved({}, mIsland.position);
        if (!free && !mMirror.empty())
            return {};
        mFree = free.value_or(Level{mIsland.energy(mIsland.position), 0, mIsland.position});
        std::vector<Level> levels{mFree};
        addLines(candidatesOf(chains));
        std::optional<Level> level = std::move(mTop);
        mCosts = mTopCosts;
        while (level) {
            levels.push_back(*level);
            const double cost = level->energy - mFree.energy;
            if (cost <= leastCost || mJob.stopped())
                break;
            giveUp(mLines, kept * cost);
            level = mLines.empty() ? std::nullopt : solved(mLines, level->position);
        }
        return levels;
    }

private:
    std::vector<Candidate> candidatesOf(const std::vector<Chain> &chains) const
    {
        std::vector<Candidate> lines;
        for (const Chain &chain : chains) {
            Candidate line{&chain, Vec2::UnitY(), true};
            const Vec2 along = directionOf(chain, mFree.position).cwiseAbs();
            if (along.isZero())
                continue;
            if (along.x() <= nearAxisSine)
                line.normal = Vec2::UnitX();
            else if (along.y() > nearAxisSine && !makeDiagonal(line))
                continue;
            line.way = farthestFrom(line);
            lines.push_back(line);
        }
        dropMeeting(lines);
        std::stable_sort(lines.begin(), lines.end(), [](const Candidate &a, const Candidate &b) {
            return a.way * a.way * b.gain() < b.way * b.way * a.gain();
        });
        return lines;
    }

    //! Where two chains meet, the border has a corner: of those along one axis only the better one is kept.
    //! Else round borders of long edges would become flat.
    void dropMeeting(std::vector<Candidate> &lines) const
    {
        const auto merit = [&](const Candidate &line) {
            const double slope =
                std::abs(directionOf(*line.chain, mFree.position).dot(line.normal)) / nearAxisSine;
            return line.gain() * (1 - slope * slope);
        };
        std::stable_sort(lines.begin(), lines.end(),
                         [&](const Candidate &a, const Candidate &b) { return merit(a) > merit(b); });
        std::vector<std::vector<Vec2>> normalsAt(mIsland.pointCount());
        std::erase_if(lines, [&](const Candidate &line) {
            const std::array<int, 2> ends{line.chain->points.front(), line.chain->points.back()};
            for (const int end : ends) {
                for (const Vec2 &normal : normalsAt[end]) {
                    if (normal == line.normal)
                        return true;
                }
            }
            for (const int end : ends)
                normalsAt[end].push_back(line.normal);
            return false;
        });
    }

    //! The farthest that a point of the chain is from its line.
    double farthestFrom(const Candidate &line) const
    {
        double mean = 0, way = 0;
        for (const int p : line.chain->points)
            mean += line.normal.dot(mFree.position[p]) / double(line.chain->points.size());
        for (const int p : line.chain->points)
            way = std::max(way, std::abs(line.normal.dot(mFree.position[p]) - mean));
        return way;
    }

    //! \returns false when the chain cannot be bent, since it is a single edge
    bool makeDiagonal(Candidate &line) const
    {
        const Vec2 along = directionOf(*line.chain, mFree.position);
        line.alongAxis = false;
        line.normal = Vec2(-along.y(), along.x());
        return line.chain->points.size() > 2;
    }

    //! The map with these lines; nothing when it has overlaps or cannot be reached. Sets mCosts.
    std::optional<Level> solved(const std::vector<Candidate> &candidates, const Positions &from)
    {
        std::vector<Line> lines;
        Level level;
        level.position = from;
        for (const Candidate &line : candidates) {
            lines.push_back({line.chain->points, line.normal});
            level.gain += line.gain();
        }
        LineNewton newton(mIsland, lines, mMirror);
        const std::optional<double> energy = newton.minimize(level.position, newtonSteps, mJob);
        if (!energy || mIsland.coversItself(level.position, mJob))
            return std::nullopt;
        level.energy = *energy;
        if (!candidates.empty())
            mCosts = newton.costs(level.position, mFree.position);
        return level;
    }

    //! Gives up lines, the dearest for their gain first, until the others cost no more than `budget`; one at
    //! least. \pre mCosts is of these lines
    void giveUp(std::vector<Candidate> &lines, double budget) const
    {
        const std::vector<double> &costs = mCosts;
        std::vector<std::size_t> order(lines.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return costs[a] * lines[b].gain() > costs[b] * lines[a].gain();
        });
        double rest = std::accumulate(costs.begin(), costs.end(), 0.0);
        std::vector<char> dropped(lines.size(), 0);
        for (std::size_t i = 0; i < order.size() && (i == 0 || rest > budget); ++i) {
            dropped[order[i]] = 1;
            rest -= costs[order[i]];
        }
        drop(lines, dropped);
    }

    //! Adds lines to mLines as far as the island stays valid; where it does not, half of them at a time.
    void addLines(const std::vector<Candidate> &more)
    {
        if (more.empty() || mTries-- <= 0 || mJob.stopped())
            return;
        std::vector<Candidate> lines = mLines;
        lines.insert(lines.end(), more.begin(), more.end());
        std::stable_sort(lines.begin(), lines.end(), countsBefore);
        std::optional<Level> level = solved(lines, mTop ? mTop->position : mFree.position);
        if (level && level->energy - mFree.energy <= mMost) {
            mTop = std::move(level);
            mLines = std::move(lines);
            mTopCosts = mCosts;
        } else if (more.size() > 1) {
            const auto middle = more.begin() + static_cast<std::ptrdiff_t>(more.size() / 2);
            addLines({more.begin(), middle});
            addLines({middle, more.end()});
        }
    }

    //! A chain that no longer runs along an axis may still be straight.
    void drop(std::vector<Candidate> &lines, const std::vector<char> &dropped) const
    {
        std::vector<Candidate> rest, diagonals;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            Candidate line = lines[i];
            if (!dropped[i])
                rest.push_back(line);
            else if (line.alongAxis && makeDiagonal(line))
                diagonals.push_back(line);
        }
        rest.insert(rest.end(), diagonals.begin(), diagonals.end());
        lines = std::move(rest);
    }

    const Island &mIsland;
    const MirrorPoints &mMirror;
    const double mMost;
    const JobContext &mJob;
    int mTries;
    Level mFree;
    std::vector<Candidate> mLines; //!< that can be straight together
    std::optional<Level> mTop;     //!< the map with them
    std::vector<double> mTopCosts; //!< of them
    std::vector<double> mCosts;    //!< of the lines of the last map
};

} // namespace

std::vector<Level> islandLevels(const Island &island, const std::vector<Chain> &chains,
                                const MirrorPoints &mirror, double most, const JobContext &job)
{
    return LevelMaker(island, mirror, most, job).make(chains);
}

} // namespace autocuts::straight
