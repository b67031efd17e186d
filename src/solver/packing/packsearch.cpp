#include "solver/packing/packsearch.h"

#include "solver/packing/compaction.h"
#include "solver/packing/separation.h"

#include <algorithm>
#include <numbers>

namespace autocuts {

namespace {

//! Ratio of two neighbouring scales of the ladder.
constexpr double ladderStep = 1.008;

struct RasterChoice
{
    int resolution;
    int angles;
};

//! Finer rasters for many islands, coarser ones when the effort would not pay for a few layouts.
RasterChoice chooseRaster(int islands, double effort)
{
    const auto seconds = [&](const RasterChoice &c) {
        return 14e-6 * islands * c.angles * std::pow(c.resolution / 512.0, 1.35);
    };
    constexpr double layouts = 8;
    RasterChoice choice{islands > 450 ? 1024 : 512, 8};
    while (choice.angles > 2 && layouts * seconds(choice) > 0.5 * effort)
        choice.angles /= 2;
    while (choice.resolution > 256 && layouts * seconds(choice) > 0.5 * effort)
        choice.resolution = choice.resolution * 3 / 4;
    // A mean island of fewer pixels than this would be all rounding.
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

PackSearch::PackSearch(const PackProblem &problem, Layout start, std::uint64_t seed)
    : mProblem(problem), mBest(std::move(start)), mRandom(seed)
{
    for (int i = 0; i < problem.count(); ++i) {
        if (problem.movable(i))
            mMovable.push_back(i);
    }
}

bool PackSearch::accept(const Layout &layout)
{
    if (!(layout.scale > mBest.scale))
        return false;
    mBest = layout;
    return true;
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
        const double key = kind == 0   ? std::sqrt(box.x() * box.y() * (1 - share) + longest * longest * share)
                           : kind == 1 ? std::sqrt(o.area)
                                       : o.perimeter;
        keys.push_back({-key * std::exp(noise * mRandom.symmetric()), i});
    }
    std::stable_sort(keys.begin(), keys.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
    std::vector<int> order;
    for (const auto &key : keys)
        order.push_back(key.second);
    return order;
}

std::optional<Layout> PackSearch::construct(BottomLeft &packer, double scale, bool first, WorkMeter &work)
{
    const std::vector<int> order = randomOrder(first ? 0 : 0.3);
    const double blend = first ? 0.5 : mRandom.uniform();
    for (const double safety : {0.3, 0.72}) {
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
    const double stopAt = std::min(work.spentSeconds() + budget, 1e9);
    const auto scaleAt = [&](int rung) { return guess * std::pow(ladderStep, rung); };
    int rung = 0, step = 4, lowestFailure = 1 << 20, highestSuccess = -(1 << 20);
    bool first = true;
    while (!work.cancelled() && (work.spentSeconds() < stopAt || highestSuccess < -(1 << 19))) {
        const std::optional<Layout> layout = construct(packer, scaleAt(rung), first, work);
        fprintf(stderr,"rung %d ok %d reached %.3f spent %.3f\n",rung,(bool)layout,packer.reached(),work.spentSeconds());
        if (layout) {
            accept(*layout);
            highestSuccess = rung;
            rung = lowestFailure - rung > 2 * step ? rung + step : std::max(rung + 1, (rung + lowestFailure) / 2);
        } else {
            lowestFailure = std::min(lowestFailure, rung);
            // Far from success: go down faster.
            const int fall = step + static_cast<int>(30 * (1 - packer.reached()));
            rung = highestSuccess > -(1 << 19) ? (highestSuccess + rung) / 2 : rung - fall;
            if (scaleAt(rung) <= mBest.scale && highestSuccess < -(1 << 19))
                return;
            if (rung <= highestSuccess) {
                // The bracket is closed: from now on random orders try the next rung.
                rung = highestSuccess + 1;
                lowestFailure = rung + 1;
                first = false;
            }
        }
    }
}

void PackSearch::maximizeScale(WorkMeter &work, double effort)
{
    const RasterChoice raster = chooseRaster(static_cast<int>(mMovable.size()), effort);
    BottomLeft packer(mProblem, raster.resolution, raster.angles);
    const double guess = std::max(scaleForCover(mProblem, 0.8), mBest.scale * ladderStep);
    climbLadder(packer, guess, 0.3 * effort, work);
    fprintf(stderr,"before %g %g R %d K %d\n",mBest.scale,work.spentSeconds(),raster.resolution,raster.angles);
    if (!work.cancelled() && mBest.scale > 0)
        mBest = compactLayout(mProblem, mBest, 0.003, work);
    fprintf(stderr,"after %g %g\n",mBest.scale,work.spentSeconds());
    if (mProblem.count() <= 450 && !work.stop() && mBest.scale > 0)
        separateAndGrow(work);
}

std::optional<Layout> PackSearch::separate(Separation &separation, const Layout &layout, int passes,
                                           WorkMeter &work)
{
    separation.start(layout);
    double tried = std::numeric_limits<double>::infinity();
    for (int k = 0; k < passes && !work.stop(); ++k) {
        separation.pass(mRandom, work);
        if (separation.deepest() > 0.8 * mProblem.gutter || separation.overlap() > 0.9 * tried)
            continue;
        // What is left is shallow enough for pushes to see which way is out.
        tried = separation.overlap();
        Compaction bodies(mProblem, separation.layout());
        if (bodies.resolve(60, work) && isValidLayout(mProblem, bodies.layout(), work)) {
            fprintf(stderr, "  separated after %d passes\n", k + 1);
            return bodies.layout();
        }
    }
    fprintf(stderr, "  failed, overlap %g deepest %g\n", separation.overlap()*1024, separation.deepest()*1024);
    return std::nullopt;
}

void PackSearch::separateAndGrow(WorkMeter &work)
{
    Separation separation(mProblem, mBest.scale, work);
    fprintf(stderr,"built %g\n",work.spentSeconds());
    double growth = 0.015;
    while (!work.stop()) {
        Layout larger = mBest;
        larger.scale *= 1 + growth;
        const std::optional<Layout> found = separate(separation, larger, 60, work);
        if (found) {
            accept(compactLayout(mProblem, *found, 0.003, work));
        } else {
            growth = std::max(0.6 * growth, 0.003);
        }
        fprintf(stderr, "scale %g spent %g growth %g\n",mBest.scale,work.spentSeconds(),growth);
    }
}

void PackSearch::fitScale(double scale, WorkMeter &work, double effort)
{
    const RasterChoice raster = chooseRaster(static_cast<int>(mMovable.size()), effort);
    BottomLeft packer(mProblem, raster.resolution, raster.angles);
    for (bool first = true; mBest.scale == 0 && (first || !work.stop()); first = false) {
        if (const std::optional<Layout> layout = construct(packer, scale, first, work))
            accept(*layout);
    }
}

} // namespace autocuts
