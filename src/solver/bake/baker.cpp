#include "solver/bake/baker.h"

#include "model/plain/parallel.h"

#include <algorithm>
#include <mutex>

namespace autocuts::bake {

namespace {

//! Bakes a band of rows at a time.
class TileBaker final
{
public:
    TileBaker(const ShadedSurface &low, const Projection &projection, const Frame &frame,
              const BakeSettings &settings, const JobContext &job)
        : mSettings(settings), mProjection(projection), mJob(job), mProbe(low, frame, settings.rays),
          mTexels(*low.mesh, low.uv, settings.grid)
    {}

    BakeResult bake(const ShadedSurface &source)
    {
        const int width = mSettings.grid.width, height = mSettings.grid.height;
        for (const MapRequest &request : mSettings.maps) {
            const int channels = channelsOf(source, request);
            mFirstChannel.push_back(mChannels);
            mChannels += channels;
            mResult.maps.emplace_back(width, height, channels);
        }
        mResult.filled.assign(std::size_t(width) * height, 0);
        if (mTexels.isEmpty())
            return std::move(mResult);
        parallelFor(mTexels.bandCount(), mJob.threads(), [this](int band) { bakeBand(band); });
        mResult.stopped = mJob.stopped();
        return std::move(mResult);
    }

private:
    //! The sums of a texel's samples.
    struct Texel
    {
        std::vector<float> sums, values;
        int found = 0;
    };

    void bakeBand(int band)
    {
        if (mJob.stopped())
            return;
        TexelRows rows;
        mTexels.makeBand(band, rows);
        long long inside = 0, missed = 0, overlapped = 0;
        Texel texel;
        const int width = mSettings.grid.width;
        for (int i = 0; i < rows.count * width; ++i) {
            if (mJob.stopped())
                return;
            const int x = i % width, y = rows.first + i / width;
            const bool any = bakeTexel(rows, i, x, y, texel);
            if (texel.found > 0)
                write(texel, x, y);
            inside += rows.inside[i];
            overlapped += rows.overlapped[i];
            missed += any && rows.inside[i] && texel.found == 0;
        }
        const std::lock_guard lock(mMutex);
        mResult.texels += inside;
        mResult.missed += missed;
        mResult.overlapped += overlapped;
        mJob.report(static_cast<double>(++mBandsDone) / mTexels.bandCount());
    }

    //! Returns false where there is no island.
    bool bakeTexel(const TexelRows &rows, int index, int x, int y, Texel &texel) const
    {
        const int samples = mTexels.samplesPerTexel();
        const auto points = std::span(rows.points).subspan(std::size_t(index) * samples, samples);
        const auto covered = static_cast<int>(
            std::ranges::count_if(points, [](const SurfacePoint &point) { return point.triangle >= 0; }));
        texel.sums.assign(mChannels, 0);
        texel.values.assign(mChannels, 0);
        texel.found = 0;
        if (covered == 0)
            return false;
        const int rays = (mSettings.rays.rays + covered - 1) / covered;
        EvenPoints even(static_cast<std::uint32_t>(y) * 0x10001U + static_cast<std::uint32_t>(x));
        for (const SurfacePoint &point : points) {
            if (point.triangle < 0)
                continue;
            const Source source = mProjection.find(point);
            if (!source.surface)
                continue;
            for (std::size_t m = 0; m < mSettings.maps.size(); ++m) {
                const auto out =
                    std::span(texel.values).subspan(mFirstChannel[m], std::size_t(mResult.maps[m].channels));
                mProbe.probe(mSettings.maps[m], point, source, rays, even, out);
                // Numbers of materials have no mean.
                if (mSettings.maps[m].kind == MapKind::MaterialId && texel.found > 0)
                    std::ranges::fill(out, 0.0F);
            }
            for (int k = 0; k < mChannels; ++k)
                texel.sums[k] += texel.values[k];
            ++texel.found;
        }
        return true;
    }

    void write(const Texel &texel, int x, int y)
    {
        for (std::size_t m = 0; m < mSettings.maps.size(); ++m) {
            const MapKind kind = mSettings.maps[m].kind;
            const std::span<float> out = mResult.maps[m].at(x, y);
            float share = 1 / static_cast<float>(texel.found);
            if (kind == MapKind::MaterialId)
                share = 1;
            for (std::size_t k = 0; k < out.size(); ++k)
                out[k] = share * texel.sums[mFirstChannel[m] + k];
            if (isDirection(kind)) {
                Eigen::Map<Vec3f> direction(out.data());
                const Vec3f unit = direction.stableNormalized();
                direction = unit.squaredNorm() > 0.5F ? unit : Vec3f(Vec3f::UnitZ());
            }
        }
        mResult.filled[std::size_t(y) * mSettings.grid.width + x] = 1;
    }

    const BakeSettings &mSettings;
    const Projection &mProjection;
    const JobContext &mJob;
    MapProbe mProbe;
    TexelSurface mTexels;
    std::vector<int> mFirstChannel; //!< per map, in Texel
    int mChannels = 0;
    BakeResult mResult;
    std::mutex mMutex; //!< counts and progress
    int mBandsDone = 0;
};

} // namespace

BakeResult bakeTile(const ShadedSurface &low, const Projection &projection, const Frame &frame,
                    const BakeSettings &settings, const JobContext &job)
{
    return TileBaker(low, projection, frame, settings, job).bake(projection.source());
}

} // namespace autocuts::bake
