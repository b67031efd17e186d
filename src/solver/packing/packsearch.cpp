#include "solver/packing/packsearch.h"

#include "solver/base/constant.h"
#include "solver/packing/compaction.h"
#include "solver/packing/guidedsearch.h"

#include <algorithm>
#include <numbers>

namespace autocuts::packing {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Share by which each scale of the ladder is larger than the one before.
AUTOCUTS_CONSTANT(double, ladderGrowth, 0.008);
const double ladderStep = 1 + ladderGrowth;

//! Largest number of islands for guided local search, whose cost per pass grows with its square.
constexpr int mostForSeparation = 600;

//! Passes of guided search without progress after which a scale is given up, and the share by which the scale
//! grows after a success at first, and at least.
AUTOCUTS_CONSTANT(int, separationPasses, 30);
AUTOCUTS_CONSTANT(double, firstGrowth, 0.015);
AUTOCUTS_CONSTANT(double, leastGrowth, 0.003);

struct RasterChoice
{
    int resolution;
    int angles;
};

//! Finer rasters for many islands, coarser ones and fewer angles when the effort would not suffice for 8
//! layouts. The cost of a layout (14 us per island and angle at 512 pixels, growing with the 1.35th power of
//! the resolution, on one core) and the usual 512 pixels and 8 angles were found on the first sets of islands
//! (README.md). Many small islands need more pixels, not more angles.
RasterChoice chooseRaster(int islands, double effort)
{
    const auto seconds = [&](const RasterChoice &c) {
        return 14e-6 * islands * c.angles * std::pow(c.resolution / 512.0, 1.35);
    };
    constexpr double layouts = 8;
    RasterChoice choice{islands > 450 ? 1024 : 512, 8};
    while (choice.angles > 2 && layouts * seconds(choice) > effort)
        choice.angles /= 2;
    while (choice.resolution > 256 && layouts * seconds(choice) > effort)
        choice.resolution = choice.resolution * 3 / 4;
    // With fewer pixels than about 8 x 8 per island, rounding would decide.
    const int least = static_cast<int>(std::min(2048.0, 8 * std::sqrt(1.0 * islands)));
    choice.resolution = std::max(choice.resolution, least);
    return choice;
}

} // namespace

double scaleForCover(const PackProblem &problem, double cover)
{
    double area = 0, perimeter = 0, locked = 0;
    int count = 0;
    for (int i = 0; i < problem.count(); ++i) {
        const Outline &outline = problem.outlines[i];
        if (problem.movable(i)) {
            area += outline.area;
            perimeter += outline.perimeter;
            ++count;
        } else if (problem.locked[i]) {
            locked += outline.area * problem.unit * problem.unit;
        }
    }
    const double g = problem.gutter;
    const Vec2 size = problem.size() + Vec2::Constant(g);
    const double room = std::max(0.05 * size.x() * size.y(), size.x() * size.y() - locked) * cover -
                        0.25 * std::numbers::pi * g * g * count;
    // area s^2 + perimeter s g / 2 = room
    const double b = 0.5 * perimeter * g;
    if (!(room > 0) || !(area + b > 0))
        return 0;
    return 2 * room / (b + std::sqrt(b * b + 4 * area * room));
}

PackSearch::PackSearch(const PackProblem &problem, Layout start, double ceiling, std::uint64_t seed)
    : mProblem(problem), mBest(std::move(start)), mCeiling(ceiling), mRandom(seed)
{
    for (int i = 0; i < problem.count(); ++i) {
        if (problem.movable(i))
            mMovable.push_back(i);
    }
}

void PackSearch::accept(const Layout &layout)
{
    if (layout.scale > mBest.scale)
        mBest = layout;
}

std::vector<int> PackSearch::randomOrder(double noise)
{
    const double share = mRandom.uniform();
    const int kind = noise > 0 ? mRandom.below(3) : 0;
    std::vector<std::pair<double, int>> keys;
    for (const int i : mMovable) {
        const Outline &o = mProblem.outlines[i];
        const Vec2 box = rotatedBox(o.hull, o.boxAngle);
        const double longest = std::max(box.x(), box.y());
        const double key = kind == 0 ? std::sqrt(box.x() * box.y() * (1 - share) + longest * longest * share)
                           : kind == 1 ? std::sqrt(o.area)
                                       : o.perimeter;
        keys.push_back({-key * std::exp(noise * mRandom.uniform(-1, 1)), i});
    }
    std::stable_sort(keys.begin(), keys.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    std::vector<int> order;
    for (const auto &key : keys)
        order.push_back(key.second);
    return order;
}

std::optional<Layout> PackSearch::construct(BottomLeft &packer, double scale, bool first, WorkMeter &work)
{
    // The noise of the order was found on the first sets of islands (README.md). The smaller safety was tuned
    // on four island sets together with the sample spacing of guidedsearch.cpp; it was 0.3 before. The larger
    // one makes disjoint pixels a proof of the gutter.
    const std::vector<int> order = randomOrder(first ? 0 : 0.3);
    const double blend = first ? 0.5 : mRandom.uniform();
    for (const double safety : {0.6, 0.72}) {
        std::optional<Layout> layout = packer.pack(scale, order, blend, safety, work);
        if (!layout)
            return std::nullopt;
        if (isValidLayout(mProblem, *layout, work))
            return layout;
        Compaction bodies(mProblem, *layout);
        if (bodies.resolve(40, work) && isValidLayout(mProblem, bodies.layout(), work))
            return bodies.layout();
    }
    return std::nullopt;
}

void PackSearch::climbLadder(BottomLeft &packer, double guess, double budget, WorkMeter &work)
{
    const double stopAt = work.spentSeconds() + budget;
    const auto scaleAt = [&](int rung) { return std::min(mCeiling, guess * std::pow(ladderStep, rung)); };
    constexpr int never = 1 << 20, patience = 300;
    int rung = 0, step = 6, failure = never, success = -never;
    bool first = true;
    int idle = 0;
    while (!work.cancelled() && !atCeiling() && idle < patience &&
           (work.spentSeconds() < stopAt || success == -never)) {
        if (const std::optional<Layout> layout = construct(packer, scaleAt(rung), first, work)) {
            accept(*layout);
            success = rung;
            idle = 0;
        } else {
            failure = std::min(failure, rung);
            ++idle;
        }
        if (success == -never) {
            // All smaller scales are below that of the layout at hand.
            if (scaleAt(rung) <= std::max(mBest.scale, 1e-6 * guess))
                return;
            rung -= step;
            step *= 2;
        } else if (failure == never) {
            rung += step;
        } else if (failure > success + 1) {
            rung = (success + failure) / 2;
        } else {
            // The bracket is closed: from now on the next larger scale is tried with random orders.
            rung = success + 1;
            failure = rung + 1;
            first = false;
        }
    }
}

std::optional<Layout> PackSearch::pushApart(const Layout &layout, WorkMeter &work) const
{
    constexpr int sweeps = 30;
    Compaction bodies(mProblem, layout);
    for (const double part : {1.0, 0.5, 0.1}) {
        bodies.setScale(mBest.scale + part * (layout.scale - mBest.scale));
        if (bodies.resolve(sweeps, work) && isValidLayout(mProblem, bodies.layout(), work))
            return bodies.layout();
    }
    return std::nullopt;
}

std::optional<Layout> PackSearch::separate(Separation &separation, const Layout &layout, WorkMeter &work)
{
    if (!separation.start(layout, work))
        return std::nullopt;
    double least = std::numeric_limits<double>::infinity(), tried = least;
    for (int idle = 0; idle < separationPasses && !work.stop(); ++idle) {
        separation.pass(mRandom, work);
        if (separation.overlap() < 0.98 * least) {
            least = separation.overlap();
            idle = -1;
        }
        if (separation.deepest() > 0.8 * mProblem.gutter || separation.overlap() > 0.8 * tried)
            continue;
        // The remaining overlaps are shallower than the gutter, so that contacts point the right way out.
        tried = separation.overlap();
        if (std::optional<Layout> found = pushApart(separation.layout(), work))
            return found;
        if (tried == 0)
            return std::nullopt;
    }
    return std::nullopt;
}

void PackSearch::separateAndGrow(WorkMeter &work)
{
    constexpr int patience = 100;
    Separation separation(mProblem, mBest.scale, work);
    double growth = firstGrowth;
    for (int failures = 0; failures < patience && !work.stop() && !atCeiling(); ++failures) {
        Layout larger = mBest;
        larger.scale = std::min(mCeiling, (1 + growth) * larger.scale);
        if (const std::optional<Layout> found = separate(separation, larger, work)) {
            accept(compactLayout(mProblem, *found, mCeiling, work));
            failures = -1;
        } else {
            growth = std::max(0.6 * growth, leastGrowth);
        }
    }
}

void PackSearch::run(WorkMeter &work, double effort)
{
    const int islands = static_cast<int>(mMovable.size());
    const bool canSeparate = mProblem.count() <= mostForSeparation;
    const RasterChoice raster = chooseRaster(islands, effort);
    BottomLeft packer(mProblem, raster.resolution, raster.angles);
    const double guess = std::max(scaleForCover(mProblem, 0.66), mBest.scale * ladderStep);
    climbLadder(packer, guess, (canSeparate ? 0.3 : 0.7) * effort, work);
    if (work.cancelled() || mBest.scale == 0)
        return;
    mBest = compactLayout(mProblem, mBest, mCeiling, work);
    if (canSeparate && !work.stop() && !atCeiling())
        separateAndGrow(work);
}

} // namespace autocuts::packing
