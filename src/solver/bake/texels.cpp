#include "solver/bake/texels.h"

#include <algorithm>
#include <cmath>

namespace autocuts::bake {

namespace {

//! Texels from an island within which a texel shows the nearest point of it.
constexpr double surroundings = 1.5;
//! Triangles whose common depth in a sample is larger overlap; smaller depths are rounding at shared sides.
//! Texels.
constexpr double overlapDepth = 0.01;

//! The distances of a point from the lines through the sides, positive inside; side k is opposite corner k.
struct Sides
{
    explicit Sides(const std::array<Vec2, 3> &at)
    {
        const double twice = cross2(at[0], at[1], at[2]);
        for (int k = 0; k < 3; ++k) {
            const Vec2 &a = at[(k + 1) % 3], &b = at[(k + 2) % 3];
            // The weight of corner k: 1 there, 0 on its side.
            slopeX[k] = (a.y() - b.y()) / twice;
            slopeY[k] = (b.x() - a.x()) / twice;
            base[k] = (a.x() * b.y() - a.y() * b.x()) / twice;
            height[k] = std::abs(twice) / std::max((b - a).norm(), 1e-300);
        }
        isFlat = std::abs(twice) < 1e-12 || !std::isfinite(1 / twice);
    }

    double weight(int k, double x, double y) const { return base[k] + slopeX[k] * x + slopeY[k] * y; }

    std::array<double, 3> slopeX{}, slopeY{}, base{}, height{};
    bool isFlat = false;
};

SurfacePoint pointOf(int triangle, double second, double third)
{
    const double b = std::clamp(second, 0.0, 1.0);
    return {triangle, static_cast<float>(b), static_cast<float>(std::clamp(third, 0.0, 1 - b))};
}

//! The nearest point of the sides of a triangle.
SurfacePoint nearestOnSides(int triangle, const std::array<Vec2, 3> &at, const Vec2 &point, double &squared)
{
    SurfacePoint best;
    squared = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const Vec2 &a = at[k];
        const Vec2 along = at[(k + 1) % 3] - a;
        const double length = along.squaredNorm();
        const double t = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0;
        const double distance = (a + t * along - point).squaredNorm();
        if (distance < squared) {
            squared = distance;
            std::array<double, 3> weights{};
            weights[k] = 1 - t;
            weights[(k + 1) % 3] = t;
            best = pointOf(triangle, weights[1], weights[2]);
        }
    }
    return best;
}

} // namespace

TexelSurface::TexelSurface(const MeshData &mesh, const UvMatrix &uv, const TexelGrid &grid) : mGrid(grid)
{
    mOfBand.resize(bandCount());
    const Vec2 low = grid.tile.min(), size = grid.tile.sizes();
    const auto bandOf = [&](double y) {
        return static_cast<int>(std::clamp(y, 0.0, grid.height - 1.0)) / rowsPerBand;
    };
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        Flat flat{t, {}, 0, 0};
        Eigen::AlignedBox2d box;
        for (int k = 0; k < 3; ++k) {
            const Vec2 at = (Vec2(uv.row(mesh.triangles[t][k])) - low).cwiseQuotient(size);
            flat.at[k] = {at.x() * grid.width, (1 - at.y()) * grid.height};
            box.extend(flat.at[k]);
        }
        if (!flat.at[0].allFinite() || !flat.at[1].allFinite() || !flat.at[2].allFinite())
            continue;
        if (box.max().x() < -surroundings || box.max().y() < -surroundings ||
            box.min().x() > grid.width + surroundings || box.min().y() > grid.height + surroundings)
            continue;
        flat.low = box.min().y();
        flat.high = box.max().y();
        const int last = bandOf(flat.high + surroundings);
        for (int band = bandOf(flat.low - surroundings); band <= last; ++band)
            mOfBand[band].push_back(static_cast<int>(mTriangles.size()));
        mTriangles.push_back(flat);
    }
}

void TexelSurface::fill(const Flat &flat, TexelRows &rows, std::vector<bool> &deep) const
{
    const Sides sides(flat.at);
    if (sides.isFlat)
        return;
    const int perSide = mGrid.perSide, samples = samplesPerTexel();
    const auto lineBelow = [&](double y) { return static_cast<int>(std::ceil(y * perSide - 0.5)); };
    const int begin = std::max(rows.first * perSide, lineBelow(std::max(flat.low, -1.0)));
    const int end =
        std::min((rows.first + rows.count) * perSide, lineBelow(std::min(flat.high, mGrid.height + 1.0)) + 1);
    for (int line = begin; line < end; ++line) {
        const double y = (line + 0.5) / perSide;
        double left = 0, right = mGrid.width;
        for (int k = 0; k < 3; ++k) {
            const double offset = sides.base[k] + sides.slopeY[k] * y, slope = sides.slopeX[k];
            if (slope > 0)
                left = std::max(left, -offset / slope);
            else if (slope < 0)
                right = std::min(right, -offset / slope);
            else if (offset < 0)
                right = left - 1;
        }
        if (!(left <= right))
            continue;
        const int row = line / perSide - rows.first, lineInTexel = line % perSide;
        const int last =
            std::min(static_cast<int>(std::floor(right * perSide - 0.5)), mGrid.width * perSide - 1);
        for (int column = std::max(0, static_cast<int>(std::ceil(left * perSide - 0.5))); column <= last;
             ++column) {
            const double x = (column + 0.5) / perSide;
            const std::size_t texel = std::size_t(row) * mGrid.width + column / perSide;
            const std::size_t sample = texel * samples + lineInTexel * perSide + column % perSide;
            const double b = sides.weight(1, x, y), c = sides.weight(2, x, y);
            const bool isDeep = (1 - b - c) * sides.height[0] > overlapDepth &&
                                b * sides.height[1] > overlapDepth && c * sides.height[2] > overlapDepth;
            rows.inside[texel] = true;
            if (rows.points[sample].triangle >= 0) {
                if (isDeep && deep[sample])
                    rows.overlapped[texel] = true;
                continue;
            }
            rows.points[sample] = pointOf(flat.triangle, b, c);
            deep[sample] = isDeep;
        }
    }
}

void TexelSurface::surround(const Flat &flat, TexelRows &rows, std::vector<double> &nearest) const
{
    const auto &at = flat.at;
    const auto [low, high] = std::minmax({at[0].x(), at[1].x(), at[2].x()});
    const int samples = samplesPerTexel();
    const auto texelAt = [](double place, int size) {
        return static_cast<int>(std::clamp(place, 0.0, double(size)));
    };
    const auto firstTexel = [&](double from, int size) { return texelAt(from - surroundings, size); };
    const auto endTexel = [&](double to, int size) { return texelAt(to + surroundings + 1, size); };
    const int begin = std::max(rows.first, firstTexel(flat.low, mGrid.height));
    const int end = std::min(rows.first + rows.count, endTexel(flat.high, mGrid.height));
    for (int y = begin; y < end; ++y) {
        for (int x = firstTexel(low, mGrid.width); x < endTexel(high, mGrid.width); ++x) {
            const std::size_t texel = std::size_t(y - rows.first) * mGrid.width + x;
            if (rows.inside[texel])
                continue;
            double squared = 0;
            const SurfacePoint point = nearestOnSides(flat.triangle, at, Vec2(x + 0.5, y + 0.5), squared);
            if (squared >= nearest[texel])
                continue;
            nearest[texel] = squared;
            std::fill_n(rows.points.begin() + std::ptrdiff_t(texel) * samples, samples, point);
        }
    }
}

void TexelSurface::makeBand(int band, TexelRows &rows) const
{
    rows.first = band * rowsPerBand;
    rows.count = std::min(rowsPerBand, mGrid.height - rows.first);
    const std::size_t texels = std::size_t(rows.count) * mGrid.width;
    rows.points.assign(texels * samplesPerTexel(), {});
    rows.inside.assign(texels, false);
    rows.overlapped.assign(texels, false);
    std::vector<bool> deep(rows.points.size(), false);
    for (const int index : mOfBand[band])
        fill(mTriangles[index], rows, deep);
    std::vector<double> nearest(texels, surroundings * surroundings);
    for (const int index : mOfBand[band])
        surround(mTriangles[index], rows, nearest);
}

} // namespace autocuts::bake
