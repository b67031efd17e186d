#include "solver/packing/bottomleft.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace autocuts::packing {

namespace {

double pixelSize(const PackProblem &problem, int resolution)
{
    // The gutter is added, because a bin that is hardly larger than its margins would have no pixels.
    const Vec2 size = problem.size() + Vec2::Constant(problem.gutter);
    constexpr double longestSide = 4000;
    return std::max(std::sqrt(size.x() * size.y()) / resolution, std::max(size.x(), size.y()) / longestSide);
}

BinRaster makeBin(const PackProblem &problem, double pixel)
{
    const Vec2 size = (problem.size() + Vec2::Constant(problem.gutter)) / pixel;
    return BinRaster(static_cast<int>(std::ceil(size.x())), static_cast<int>(std::ceil(size.y())));
}

//! From this many islands on, the search for an island starts at the row where the last one of similar size
//! fitted, because starting from the first row for each of them costs too much. Chosen by hand.
constexpr int manyIslands = 1500;

} // namespace

BottomLeft::BottomLeft(const PackProblem &problem, int resolution, int angles)
    : mProblem(problem), mAngles(angles), mPixel(pixelSize(problem, resolution)),
      mHalfGutter(0.5 * problem.gutter / mPixel), mBin(makeBin(problem, mPixel)), mRasters(problem.count())
{}

const std::vector<ItemRaster> &BottomLeft::rasters(int island, WorkMeter &work)
{
    std::vector<ItemRaster> &items = mRasters[island];
    if (!items.empty())
        return items;
    const Outline &outline = mProblem.outlines[island];
    // Of many directions only some are tried, all of them multiples of the step.
    const int directions = mProblem.directions(island);
    const int count = directions == 0 ? mAngles : std::gcd(directions, std::max(4, mAngles));
    const double base = mProblem.smallBoxAngle(island);
    for (int k = 0; k < count; ++k) {
        const double angle = base + 2 * std::numbers::pi * k / count;
        const Vec2 box = rotatedBox(outline.hull, angle) * mScale;
        if (box.x() <= mProblem.size().x() && box.y() <= mProblem.size().y())
            items.push_back(rasterizeOutline(outline, angle, mScale / mPixel, mHalfGutter, mSafety, work));
    }
    return items;
}

std::optional<BottomLeft::Place> BottomLeft::findPlace(const std::vector<ItemRaster> &items, int firstRow,
                                                       double blend, WorkMeter &work) const
{
    const Vec2 size = mProblem.size() / mPixel;
    const auto offset = [&](const ItemRaster &item) {
        return (1 - blend) * item.size.y() + blend * item.centroidRow;
    };
    std::optional<Place> best;
    for (const ItemRaster &item : items) {
        const int lastX = static_cast<int>(size.x() - item.size.x() + 1e-9);
        const int lastY = static_cast<int>(size.y() - item.size.y() + 1e-9);
        const double own = offset(item);
        for (int y = firstRow; y <= lastY; ++y) {
            if (best && y + own >= best->score)
                break;
            const int x = mBin.firstFree(item, y, lastX, work);
            if (x >= 0) {
                best = Place{&item, x, y, y + own + 1e-3 * x / size.x()};
                break;
            }
        }
    }
    return best;
}

void BottomLeft::occupyLocked(WorkMeter &work)
{
    for (int i = 0; i < mProblem.count(); ++i) {
        const Outline &outline = mProblem.outlines[i];
        if (!mProblem.locked[i] || outline.points.empty())
            continue;
        const Eigen::AlignedBox2d bin(mProblem.lower, mProblem.upper);
        const double reach = mProblem.unit * outline.radius;
        const Vec2 centre = mProblem.given[i].position;
        if (!areNear(bin, {centre - Vec2::Constant(reach), centre + Vec2::Constant(reach)}, mProblem.gutter))
            continue;
        // A locked island is not aligned to the pixels: half a pixel diagonal (.71) is added to the safety.
        const ItemRaster item =
            rasterizeOutline(outline, 0, std::min(mProblem.unit / mPixel, 1e4 / outline.radius), mHalfGutter,
                             mSafety + 0.71, work);
        const Vec2 corner = (centre - mProblem.lower) / mPixel + item.low;
        mBin.occupyClipped(item, static_cast<int>(std::floor(corner.x() + 0.5)),
                           static_cast<int>(std::floor(corner.y() + 0.5)));
    }
}

std::optional<Layout> BottomLeft::pack(double scale, const std::vector<int> &order, double blend,
                                       double safety, WorkMeter &work)
{
    mReached = 0;
    if (scale != mScale || safety != mSafety) {
        mScale = scale;
        mSafety = safety;
        for (auto &items : mRasters)
            items.clear();
    }
    mBin.clear();
    work.add(2000 + 0.1 * static_cast<double>(mBin.byteCount()));
    occupyLocked(work);
    Layout layout{scale, mProblem.given};
    // First row of the search for islands of about this radius; stays 0 below manyIslands.
    int firstRow = 0;
    double lastRadius = 0;
    int placed = 0;
    for (const int island : order) {
        if (work.cancelled())
            return std::nullopt;
        const std::vector<ItemRaster> &items = rasters(island, work);
        const double radius = mProblem.outlines[island].radius;
        if (static_cast<int>(order.size()) < manyIslands || radius < 0.9 * lastRadius ||
            radius > 1.1 * lastRadius) {
            firstRow = 0;
            lastRadius = radius;
        }
        const std::optional<Place> place = findPlace(items, firstRow, blend, work);
        if (!place)
            return std::nullopt;
        firstRow = std::max(firstRow, place->y - 2);
        mBin.occupy(*place->item, place->x, place->y);
        work.add(100 + 15.0 * place->item->rows * (mBin.width() / 64 + 1));
        layout.poses[island] = {place->item->angle,
                                mProblem.lower + (Vec2(place->x, place->y) - place->item->low) * mPixel};
        mReached = static_cast<double>(++placed) / static_cast<double>(order.size());
    }
    return layout;
}

} // namespace autocuts::packing
