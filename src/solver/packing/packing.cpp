#include "solver/packing/packing.h"

#include "model/plain/parallel.h"
#include "solver/base/constant.h"
#include "solver/packing/packsearch.h"
#include "solver/packing/shelves.h"
#include "solver/packing/singleisland.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <stdexcept>

namespace autocuts::packing {

namespace {

// Numbers in this file without another source were chosen by hand.

void checkSettings(const PackOptions &settings)
{
    const Vec2 size = settings.upper - settings.lower;
    if (!isUsablePoint(settings.lower) || !isUsablePoint(settings.upper) || !(size.minCoeff() > 0))
        throw std::invalid_argument("the bin is empty or not finite");
    if (settings.textureSize <= 0 || !(settings.margin >= 0) || !(settings.margin < 1e100) ||
        !(std::abs(settings.border) < 1e100) || !(settings.effort >= 0))
        throw std::invalid_argument(
            "margin, border, texture size and effort must be finite and not negative");
}

Eigen::AlignedBox2d boxOf(const PackIsland &island)
{
    Eigen::AlignedBox2d box;
    for (const Vec2 &p : island.points) {
        if (isUsablePoint(p))
            box.extend(p);
    }
    return box;
}

//! The unit of the outlines, in UV units: the square root of the total area, so that their coordinates are
//! near 1 whatever the size of the map.
double chooseUnit(const std::vector<PackIsland> &islands, const std::vector<int> &chosen)
{
    double area = 0, extent = 0;
    for (const int i : chosen) {
        area += islandArea(islands[i]);
        if (const Eigen::AlignedBox2d box = boxOf(islands[i]); !box.isEmpty())
            extent = std::max(extent, box.sizes().maxCoeff());
    }
    const double unit = std::max(std::sqrt(area), 1e-3 * extent);
    return unit > 1e-150 ? unit : 1;
}

// Islands that would be this share of the bin's longer side, were so much of the bin filled, are so long that
// they decide how large all islands are.
constexpr double longestSquare = 0.95, likelyFill = 0.5;
//! Effort of each of several searches, in seconds, and their largest number. On the first sets of islands
//! (README.md) one search hardly gained between 1 s and 10 s, while results of different searches varied by
//! .01 to .036 of efficiency.
AUTOCUTS_CONSTANT(double, secondsPerStart, 2.5);
constexpr int mostStarts = 16;

//! Share of the scale with long islands turned freely from which they stand along the axes all the same.
//! Chosen by hand: a prism and a gear with long strips reach .85, a cylinder .93.
constexpr double leastSquareScale = 0.8;

//! The problem with long islands that may turn freely, if there are any: along a diagonal there is more room.
std::optional<PackProblem> withLongIslandsFree(const PackOptions &settings, const PackProblem &square)
{
    double area = 0;
    for (int i = 0; i < square.count(); ++i)
        area += square.locked[i] ? 0 : square.outlines[i].area;
    const double scale =
        settings.keepScale ? square.unit : std::sqrt(likelyFill * square.size().prod() / area);
    std::optional<PackProblem> result;
    for (int i = 0; i < square.count(); ++i) {
        const Outline &outline = square.outlines[i];
        if (!square.standsSquare(i) || rotatedBox(outline.hull, *outline.squareAngle).maxCoeff() * scale <=
                                           longestSquare * square.size().maxCoeff())
            continue;
        if (!result)
            result = square;
        result->outlines[i].squareAngle.reset();
    }
    return result;
}

//! The problem of those islands that can be in each other's way.
struct GivenProblem
{
    PackProblem problem;
    std::vector<int> islands; //!< per outline: the island
};

GivenProblem makeProblem(const std::vector<PackIsland> &islands, const PackOptions &settings)
{
    GivenProblem given;
    PackProblem &problem = given.problem;
    problem.rotation = settings.rotation;
    const double texel = 1.0 / settings.textureSize;
    const Vec2 size = settings.upper - settings.lower;
    // Room for the rounding of coordinates to single precision or in text files.
    const double rounding =
        1e-7 *
        std::max(size.maxCoeff(), settings.lower.cwiseAbs().cwiseMax(settings.upper.cwiseAbs()).maxCoeff());
    problem.gutter = settings.margin * texel + 2 * rounding;
    const double border = (settings.border >= 0 ? settings.border : 0.5 * settings.margin) * texel + rounding;
    problem.lower = settings.lower + Vec2::Constant(border);
    problem.upper = settings.upper - Vec2::Constant(border);
    // Locked islands that are a margin away from wherever others may lie are not in the way, such as those of
    // the next tile, which keep its border.
    const Eigen::AlignedBox2d range(problem.lower, problem.upper);
    for (int i = 0; i < static_cast<int>(islands.size()); ++i) {
        if (!islands[i].locked || areNear(range, boxOf(islands[i]), settings.margin * texel + rounding))
            given.islands.push_back(i);
    }
    problem.unit = chooseUnit(islands, given.islands);
    for (const int i : given.islands) {
        const PackIsland &island = islands[i];
        Outline &outline = problem.outlines.emplace_back(makeOutline(island, problem.unit));
        if (settings.keepStraight && !outline.squareAngle && standsOnAxes(outline))
            outline.squareAngle = 0;
        problem.locked.push_back(island.locked);
        problem.upright.push_back(island.upright);
        problem.aligned.push_back(island.aligned);
        if (island.aligned)
            outline.squareAngle.reset(); // it stands as the user wants it
        problem.given.push_back({0, outline.centre});
    }
    return given;
}

//! The layout in shelves at the largest scale that a bisection finds; scale 0 when there is none.
Layout largestShelves(const PackProblem &problem, WorkMeter &work)
{
    double largest = 0;
    for (int i = 0; i < problem.count(); ++i) {
        if (problem.movable(i))
            largest = std::max(largest, problem.outlines[i].radius);
    }
    Layout best{0, problem.given};
    const auto improve = [&](double scale) {
        std::optional<Layout> layout = packShelves(problem, scale, work);
        if (layout)
            best = std::move(*layout);
        return layout.has_value();
    };
    // Islands that are single points look the same at any scale: keep the original one.
    double high = largest > 0 ? problem.size().norm() / largest : problem.unit;
    double low = 0;
    for (int k = 0; k < 64 && low == 0 && !work.cancelled(); ++k) {
        const double scale = std::ldexp(high, -k);
        if (improve(scale)) {
            low = scale;
            high = k == 0 ? scale : 2 * scale;
        }
    }
    for (int k = 0; k < 10 && low > 0 && low < high && !work.cancelled(); ++k) {
        const double middle = std::sqrt(low * high);
        (improve(middle) ? low : high) = middle;
    }
    // Shelves are valid but for rounding, so that one check of the result is enough.
    while (best.scale > 0 && !isValidLayout(problem, best, work)) {
        const double smaller = 0.5 * best.scale;
        if (!(smaller > 0) || work.cancelled() || !improve(smaller))
            return {0, problem.given};
    }
    return best;
}

//! The best of several independent searches that share the effort. Their number depends on the settings alone
//! and each has its own seed, so that the number of threads does not change the result.
Layout searchFrom(const PackProblem &problem, const Layout &start, double ceiling,
                  const PackOptions &settings, const JobContext &job)
{
    const double wanted = settings.starts > 0 ? settings.starts : settings.effort / secondsPerStart;
    const int starts = static_cast<int>(std::clamp(wanted, 1.0, 1.0 * mostStarts));
    const double share = settings.effort / starts;
    std::vector<Layout> found(starts, start);
    std::mutex mutex;
    std::vector<double> done(starts, 0);
    parallelFor(starts, job.threads(), [&](int i) {
        const JobContext::Sink report = [&, i](const JobProgress &progress) {
            const std::lock_guard lock(mutex);
            done[i] = progress.fraction;
            job.report(std::accumulate(done.begin(), done.end(), 0.0) / starts);
        };
        WorkMeter meter(share, job.reports() ? job.watchedBy(report) : job);
        PackSearch search(problem, start, ceiling, settings.seed + 0x100000000ULL * i);
        search.run(meter, share);
        found[i] = search.best();
    });
    return *std::max_element(found.begin(), found.end(),
                             [](const Layout &a, const Layout &b) { return a.scale < b.scale; });
}

Layout solve(const PackProblem &problem, const PackOptions &settings, const JobContext &job)
{
    WorkMeter work(0, job.quiet());
    const auto search = [&](const Layout &start, double ceiling) {
        return searchFrom(problem, start, ceiling, settings, job);
    };
    const Layout none{0, problem.given};
    if (settings.keepScale) {
        const std::optional<Layout> shelves = packShelves(problem, problem.unit, work);
        if (shelves && isValidLayout(problem, *shelves, work))
            return *shelves;
        if (const std::optional<Layout> single = fitSingleIsland(problem, problem.unit, work))
            return single->scale >= problem.unit ? *single : none;
        const Layout found = search(none, problem.unit);
        return found.scale >= problem.unit ? found : none;
    }
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    if (const std::optional<Layout> single = fitSingleIsland(problem, unbounded, work))
        return *single;
    const Layout shelves = largestShelves(problem, work);
    bool anyExtent = false;
    for (int i = 0; i < problem.count(); ++i)
        anyExtent = anyExtent || (problem.movable(i) && problem.outlines[i].radius > 0);
    if ((!anyExtent || settings.effort == 0) && shelves.scale > 0)
        return shelves;
    return search(shelves, unbounded);
}

//! With long islands along the axes, where that does not make all islands much smaller. Both ways share the
//! effort.
Layout solveStraightOrFree(const PackProblem &problem, const PackOptions &settings, const JobContext &job)
{
    const std::optional<PackProblem> free = withLongIslandsFree(settings, problem);
    if (!free)
        return solve(problem, settings, job);
    const auto halfOf = [&job](double first) {
        return JobContext::Sink(
            [&job, first](const JobProgress &progress) { job.report(first + 0.5 * progress.fraction); });
    };
    const JobContext::Sink early = halfOf(0), late = halfOf(0.5);
    PackOptions half = settings;
    half.effort *= 0.5;
    Layout square = solve(problem, half, job.reports() ? job.watchedBy(early) : job);
    Layout turned = solve(*free, half, job.reports() ? job.watchedBy(late) : job);
    return square.scale >= leastSquareScale * turned.scale ? square : turned;
}

double efficiency(const PackProblem &problem, const PackOptions &settings, double scale)
{
    double area = 0;
    const Eigen::AlignedBox2d bin(settings.lower, settings.upper);
    for (int i = 0; i < problem.count(); ++i) {
        const double reach = problem.unit * problem.outlines[i].radius;
        const Vec2 &centre = problem.given[i].position;
        // Locked islands outside the bin do not count.
        if (!problem.locked[i] ||
            areNear(bin, {centre - Vec2::Constant(reach), centre + Vec2::Constant(reach)}, 0))
            area += problem.outlines[i].area * std::pow(problem.scaleOf(i, scale), 2);
    }
    return area / (settings.upper - settings.lower).prod();
}

} // namespace

PackResult packIslands(const std::vector<PackIsland> &islands, const PackOptions &settings,
                       const JobContext &job)
{
    checkSettings(settings);
    const GivenProblem given = makeProblem(islands, settings);
    const PackProblem &problem = given.problem;
    PackResult result;
    result.placements.resize(islands.size());
    bool anyMovable = false;
    for (int i = 0; i < problem.count(); ++i)
        anyMovable = anyMovable || problem.movable(i);
    if (!anyMovable) {
        result.complete = true;
        result.efficiency = efficiency(problem, settings, problem.unit);
        return result;
    }
    const bool anyRoom = (problem.size().array() >= 0).all();
    const Layout layout = anyRoom ? solveStraightOrFree(problem, settings, job) : Layout{0, problem.given};
    result.complete = layout.scale > 0;
    const double scale = result.complete ? layout.scale : problem.unit;
    result.scale = result.complete && !settings.keepScale ? scale / problem.unit : 1;
    result.efficiency = efficiency(problem, settings, scale);
    for (int i = 0; i < problem.count() && result.complete; ++i) {
        if (!problem.movable(i))
            continue;
        const Pose &pose = layout.poses[i];
        result.placements[given.islands[i]] = {
            pose.angle, pose.position - Turn(pose.angle, result.scale)(problem.outlines[i].centre)};
    }
    job.report(1);
    return result;
}

} // namespace autocuts::packing
