#include "solver/bake/surfacesamples.h"

#include "model/plain/parallel.h"

#include <Eigen/LU>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace autocuts::bake {

namespace {

constexpr int mostWalkSteps = 256;
constexpr int trianglesPerJob = 16;
//! Share of the way to the middle of its triangle that a point on a side is moved: rays from the side itself
//! would meet its neighbour.
constexpr float inset = 0.02F;

} // namespace

SurfaceSamples::SurfaceSamples(const ShadedSurface &low, const Projection &projection, const Frame &frame,
                               const MapRequest &request, const RaySettings &rays, const Encoding &encoding,
                               int points, const JobContext &job)
    : mKind(request.kind), mChannels(channelsOf(projection.source(), request)), mEncoding(encoding)
{
    const MeshData &mesh = *low.mesh;
    layGrids(mesh, points);
    // Directions are kept in the space of the model: tangents change with the map.
    const MapRequest traced{mKind == MapKind::Normal ? MapKind::ObjectNormal : mKind, request.texture};
    const MapProbe probe(low, frame, rays);
    const int jobs = (mesh.triangleCount() + trianglesPerJob - 1) / trianglesPerJob;
    std::atomic<long long> missed = 0;
    std::atomic<int> done = 0;
    parallelFor(jobs, job.threads(), [&](int part) {
        const int end = std::min(mesh.triangleCount(), (part + 1) * trianglesPerJob);
        for (int t = part * trianglesPerJob; t < end && !job.stopped(); ++t)
            missed += trace(t, projection, probe, traced, rays.rays);
        ++done;
    });
    mMissed = missed;
    mComplete = !job.stopped();
}

void SurfaceSamples::layGrids(const MeshData &mesh, int points)
{
    std::size_t size = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const double share = mesh.area > 0 ? mesh.triangleArea[t] / mesh.area : 0;
        Grid grid;
        grid.steps = std::clamp(static_cast<int>(std::sqrt(2 * share * points)), 1, mostWalkSteps);
        grid.first = size;
        size += std::size_t(mChannels) * (grid.steps + 1) * (grid.steps + 2) / 2;
        mGrids.push_back(grid);
    }
    mValues.assign(size, 0);
}

int SurfaceSamples::trace(int triangle, const Projection &projection, const MapProbe &probe,
                          const MapRequest &request, int rays)
{
    const Grid &grid = mGrids[triangle];
    int missed = 0;
    for (int i = 0; i <= grid.steps; ++i) {
        for (int j = 0; i + j <= grid.steps; ++j) {
            const auto weight = [&](int n) {
                return (1 - inset) * static_cast<float>(n) / static_cast<float>(grid.steps) + inset / 3;
            };
            const SurfacePoint point{triangle, weight(i), weight(j)};
            const Source source = projection.find(point);
            if (!source.surface) {
                ++missed;
                continue;
            }
            const std::size_t first = place(grid, i, j);
            EvenPoints even(scrambled(static_cast<std::uint32_t>(first)));
            probe.probe(request, point, source, rays, even,
                        std::span(mValues).subspan(first, std::size_t(mChannels)));
        }
    }
    return missed;
}

//! Between the three points around.
void SurfaceSamples::valueAt(const SurfacePoint &point, std::span<float> out) const
{
    const Grid &grid = mGrids[point.triangle];
    const float x = point.second * static_cast<float>(grid.steps);
    const float y = point.third * static_cast<float>(grid.steps);
    int i = std::clamp(static_cast<int>(x), 0, grid.steps - 1);
    int j = std::clamp(static_cast<int>(y), 0, grid.steps - 1 - i);
    float right = x - static_cast<float>(i), up = y - static_cast<float>(j);
    std::size_t a = place(grid, i, j), b = place(grid, i + 1, j), c = place(grid, i, j + 1);
    if (right + up > 1 && i + j + 2 <= grid.steps) {
        // The triangle on the other side of the diagonal.
        a = place(grid, i + 1, j + 1);
        std::swap(b, c);
        right = 1 - right;
        up = 1 - up;
    }
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = mValues[a + k] + right * (mValues[b + k] - mValues[a + k]) +
                 up * (mValues[c + k] - mValues[a + k]);
}

Picture SurfaceSamples::lay(const ShadedSurface &low, const TexelGrid &grid, const JobContext &job) const
{
    Picture picture(grid.width, grid.height, mChannels);
    std::vector<std::uint8_t> filled(std::size_t(grid.width) * grid.height, 0);
    TexelGrid single = grid;
    single.perSide = 1;
    const TexelSurface texels(*low.mesh, low.uv, single);
    parallelFor(texels.bandCount(), job.threads(), [&](int band) {
        if (job.stopped())
            return;
        TexelRows rows;
        texels.makeBand(band, rows);
        for (int i = 0; i < rows.count * grid.width; ++i) {
            const SurfacePoint &point = rows.points[i];
            if (point.triangle < 0)
                continue;
            const int x = i % grid.width, y = rows.first + i / grid.width;
            const std::span<float> out = picture.at(x, y);
            valueAt(point, out);
            if (mKind == MapKind::Normal) {
                Eigen::Map<Vec3f> direction(out.data());
                direction = low.tangentFrame(point).inverse() * Vec3f(direction);
            }
            if (isDirection(mKind)) {
                Eigen::Map<Vec3f> direction(out.data());
                direction = direction.allFinite() ? direction.stableNormalized() : Vec3f(Vec3f::UnitZ());
            }
            filled[std::size_t(y) * grid.width + x] = 1;
        }
    });
    encode(picture, {mKind, 0}, TextureKind::Srgb, filled, mEncoding);
    return picture;
}

} // namespace autocuts::bake
