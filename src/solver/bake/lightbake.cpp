#include "solver/bake/lightbake.h"

#include "model/plain/parallel.h"
#include "solver/bake/dilation.h"
#include "solver/bake/lightdenoise.h"
#include "solver/bake/seamevening.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

namespace autocuts::bake {

namespace {

//! The first pass of the preview shows one texel in so many along each side.
constexpr int coarsest = 16;
//! Paths of the coarse passes.
constexpr int firstSamples = 8;
//! How far points are drawn towards the middle of their triangle, as a share of the model's size, so that
//! none is right in a corner of the model, where its rays could slip through the wall beside it; and the
//! largest share of the way.
constexpr double inset = 1e-5, largestInset = 0.01;
//! Share of the work that denoising is taken for.
constexpr double denoiseShare = 0.05;

//! Samples of the texels whose column and row are multiples of a stride, but not of a coarser one.
struct Pass
{
    int stride = 1;
    bool leavesOutCoarser = false;
    int from = 0, to = 0; //!< numbers of samples
};

//! From coarse to fine, then from noisy to smooth.
std::vector<Pass> passesFor(int samples)
{
    std::vector<Pass> passes;
    const int first = std::min(samples, firstSamples);
    for (int stride = coarsest; stride >= 1; stride /= 2)
        passes.push_back({stride, stride < coarsest, 0, first});
    for (int from = first; from < samples; from *= 2)
        passes.push_back({1, false, from, std::min(samples, 2 * from)});
    return passes;
}

int samplesAlongTexel(int samples)
{
    return samples >= 16 ? 4 : samples >= 4 ? 2 : 1;
}

class LightBaker final
{
public:
    LightBaker(const LitSurface &surface, const Lighting &lighting, const LightBakeSettings &settings,
               const JobContext &job)
        : mSurface(surface), mSettings(settings), mJob(job),
          mTracer(surface, lighting, settings.bounces, job),
          mTexels(*surface.mesh, surface.uv,
                  {settings.width, settings.height, settings.tile, samplesAlongTexel(settings.samples)}),
          mSums(settings.width, settings.height, 3)
    {
        const std::size_t texels = std::size_t(settings.width) * settings.height;
        mDifferences.assign(texels, 0);
        mCounts.assign(texels, 0);
        mGuides.position.assign(texels, Vec3f::Zero());
        mGuides.normal.assign(texels, Vec3f::Zero());
        mGuides.size.assign(texels, 0);
        mGuides.filled.assign(texels, 0);
        mGuides.variance.assign(texels, 0);
        if (settings.value == LightValue::Lit) {
            mAlbedo.assign(texels, Vec3f::Zero());
            mShining.assign(texels, Vec3f::Zero());
        }
    }

    LightBakeResult bake(const LightPreview &preview)
    {
        if (!mJob.stopped())
            findTexels();
        const double end = mSettings.denoise ? 1 - denoiseShare : 1;
        const double all = std::max(1.0, double(mCovered) * mSettings.samples);
        double before = 0;
        for (const Pass &pass : passesFor(mSettings.samples)) {
            const double after = before + double(texelsOf(pass)) * (pass.to - pass.from);
            run(pass, mJob.part(end * before / all, end * after / all));
            before = after;
            if (mJob.stopped())
                break;
            if (preview)
                preview(finished());
        }
        return result(mJob.part(end, 1));
    }

private:
    std::size_t indexOf(int x, int y) const { return std::size_t(y) * mSettings.width + x; }

    bool isIn(const Pass &pass, int x, int y) const
    {
        const auto isOn = [&](int stride) { return x % stride == 0 && y % stride == 0; };
        return isOn(pass.stride) && !(pass.leavesOutCoarser && isOn(2 * pass.stride));
    }

    long long texelsOf(const Pass &pass) const
    {
        long long count = 0;
        for (int y = 0; y < mSettings.height; y += pass.stride) {
            for (int x = 0; x < mSettings.width; x += pass.stride)
                count += mGuides.filled[indexOf(x, y)] && isIn(pass, x, y);
        }
        return count;
    }

    //! Calls work(points of the texel, x, y) for the texels with a point of the surface, on all threads.
    template <class Work>
    void forTexels(const JobContext &job, Work work) const
    {
        std::mutex mutex;
        int done = 0;
        parallelFor(mTexels.bandCount(), job.threads(), [&](int band) {
            if (job.stopped())
                return;
            TexelRows rows;
            mTexels.makeBand(band, rows);
            const int samples = mTexels.samplesPerTexel();
            for (int i = 0; i < rows.count * mSettings.width && !job.stopped(); ++i) {
                const auto points = std::span(rows.points).subspan(std::size_t(i) * samples, samples);
                if (std::ranges::any_of(points, [](const SurfacePoint &p) { return p.triangle >= 0; }))
                    work(points, i % mSettings.width, rows.first + i / mSettings.width);
            }
            const std::lock_guard lock(mutex);
            job.report(double(++done) / mTexels.bandCount());
        });
    }

    void findTexels()
    {
        forTexels(mJob.quiet(), [this](std::span<const SurfacePoint> points, int x, int y) {
            const auto first =
                std::ranges::find_if(points, [](const SurfacePoint &p) { return p.triangle >= 0; });
            const std::size_t texel = indexOf(x, y);
            mGuides.position[texel] = mTracer.positionAt(*first);
            mGuides.normal[texel] = mTracer.normalAt(*first);
            mGuides.size[texel] = texelSize(first->triangle);
            mGuides.filled[texel] = 1;
            if (mSettings.value == LightValue::Lit)
                findColors(points, texel);
        });
        mCovered = std::ranges::count(mGuides.filled, std::uint8_t(1));
    }

    void findColors(std::span<const SurfacePoint> points, std::size_t texel)
    {
        float count = 0;
        for (const SurfacePoint &point : points) {
            if (point.triangle < 0)
                continue;
            mAlbedo[texel] += mSurface.albedo(point);
            if (!mSurface.emission.empty())
                mShining[texel] += mSurface.emission[mSurface.mesh->triangleFace[point.triangle]];
            ++count;
        }
        mAlbedo[texel] /= count;
        mShining[texel] /= count;
    }

    //! The longest side of a texel on a triangle, in the frame.
    float texelSize(int triangle) const
    {
        const auto &corners = mSurface.mesh->triangles[triangle];
        const Vec2 texels = Vec2(mSettings.width, mSettings.height).cwiseQuotient(mSettings.tile.sizes());
        const auto uv = [&](int k) -> Vec2 {
            return Vec2(mSurface.uv.row(corners[k]).transpose()).cwiseProduct(texels);
        };
        const double area = std::abs(cross2(uv(0), uv(1), uv(2))) / 2;
        const double size = mTracer.frame().size;
        return static_cast<float>(std::sqrt(mSurface.mesh->triangleArea[triangle] / std::max(area, 1e-12)) /
                                  size);
    }

    void run(const Pass &pass, const JobContext &job)
    {
        forTexels(job, [&](std::span<const SurfacePoint> points, int x, int y) {
            if (isIn(pass, x, y))
                sample(points, x, y, pass);
        });
    }

    SurfacePoint drawnIn(const SurfacePoint &point) const
    {
        const double size = std::sqrt(mSurface.mesh->triangleArea[point.triangle]) / mTracer.frame().size;
        const auto share = static_cast<float>(std::min(largestInset, inset / std::max(size, 1e-30)));
        return {point.triangle, point.second + share * (1.0F / 3 - point.second),
                point.third + share * (1.0F / 3 - point.third)};
    }

    //! Traces the paths of one texel, evenly from its points.
    void sample(std::span<const SurfacePoint> points, int x, int y, const Pass &pass)
    {
        std::array<SurfacePoint, 16> covered;
        int count = 0;
        for (const SurfacePoint &point : points) {
            if (point.triangle >= 0)
                covered[count++] = drawnIn(point);
        }
        const ScrambledPoints random(scrambled(mSettings.seed) ^ (static_cast<std::uint32_t>(y) * 0x10001U +
                                                                  static_cast<std::uint32_t>(x)));
        const std::size_t texel = indexOf(x, y);
        Eigen::Map<Vec3f> sum(mSums.at(x, y).data());
        for (int i = pass.from; i < pass.to && !mJob.stopped(); ++i) {
            const ArrivingLight light =
                mTracer.trace(covered[i % count], random, static_cast<std::uint32_t>(i));
            Vec3f value = Vec3f::Zero();
            if (mSettings.direct)
                value += light.direct;
            if (mSettings.indirect)
                value += light.indirect;
            sum += value;
            const float luminance = value.dot(Vec3f(0.2126F, 0.7152F, 0.0722F));
            mDifferences[texel] += i % 2 == 0 ? luminance : -luminance;
            ++mCounts[texel];
        }
    }

    //! The light of each texel so far. Texels without samples take the value of the coarser one that they
    //! are in.
    Picture finished() const
    {
        Picture light(mSettings.width, mSettings.height, 3);
        parallelFor(light.height, mJob.threads(), [&](int y) {
            for (int x = 0; x < light.width; ++x) {
                if (!mGuides.filled[indexOf(x, y)])
                    continue;
                int step = 1;
                const auto count = [&] { return mCounts[indexOf(x & ~(step - 1), y & ~(step - 1))]; };
                while (count() == 0 && step < coarsest)
                    step *= 2;
                if (count() == 0)
                    continue;
                const auto from = mSums.at(x & ~(step - 1), y & ~(step - 1));
                std::ranges::transform(from, light.at(x, y).begin(),
                                       [&](float sum) { return sum / static_cast<float>(count()); });
            }
        });
        return light;
    }

    void estimateNoise(const Picture &light, LightBakeResult &result)
    {
        double noise = 0, sum = 0, texels = 0;
        for (std::size_t i = 0; i < mCounts.size(); ++i) {
            if (mCounts[i] < 2)
                continue;
            const float *color = light.values.data() + 3 * i;
            const float mean = 0.2126F * color[0] + 0.7152F * color[1] + 0.0722F * color[2];
            const auto count = static_cast<float>(mCounts[i]);
            const float difference = mDifferences[i] / count;
            mGuides.variance[i] = difference * difference;
            noise += double(mGuides.variance[i]);
            ++texels;
            sum += double(mean);
        }
        result.noise = sum > 0 ? std::sqrt(noise * texels) / sum : 0;
    }

    LightBakeResult result(const JobContext &job)
    {
        LightBakeResult result;
        result.stopped = job.stopped();
        result.texels = mCovered;
        if (std::ranges::all_of(mCounts, [](int count) { return count == 0; }) && result.stopped)
            return result;
        result.picture = finished();
        result.filled = mGuides.filled;
        estimateNoise(result.picture, result);
        if (mSettings.denoise && !result.stopped)
            denoiseLight(result.picture, std::move(mGuides), job);
        if (!job.stopped())
            evenLight(result, job);
        result.stopped = job.stopped();
        if (mSettings.value == LightValue::Irradiance) {
            for (float &value : result.picture.values)
                value *= std::numbers::pi_v<float>;
        } else if (mSettings.value == LightValue::Lit) {
            reflect(result.picture);
        }
        // Without its margin, what there is after a stop would have dark seams.
        dilate(result.picture, result.filled, mSettings.margin, job.unstoppable());
        return result;
    }

    void evenLight(LightBakeResult &result, const JobContext &job) const
    {
        ShadedSurface shape;
        shape.mesh = mSurface.mesh;
        shape.uv = mSurface.uv;
        shape.normals = mSurface.normals;
        evenSeams(shape, mSettings.tile, false, result.filled, result.picture, job);
    }

    //! Makes of the light that arrives what leaves.
    void reflect(Picture &light) const
    {
        for (std::size_t i = 0; i < mAlbedo.size(); ++i) {
            Eigen::Map<Vec3f> color(light.values.data() + 3 * i);
            color = color.cwiseProduct(mAlbedo[i]) + mShining[i];
        }
    }

    const LitSurface &mSurface;
    const LightBakeSettings &mSettings;
    const JobContext &mJob;
    PathTracer mTracer;
    TexelSurface mTexels;
    Picture mSums; //!< of the samples
    //! Luminance of the even samples less that of the odd ones. Both are spread evenly themselves, so that
    //! this shows how noisy the sum is; the variance of single samples would be far more.
    std::vector<float> mDifferences;
    std::vector<int> mCounts; //!< of samples
    TexelGuides mGuides;
    std::vector<Vec3f> mAlbedo, mShining; //!< per texel, means; empty where LightValue needs none
    long long mCovered = 0;
};

} // namespace

LightBakeResult bakeLight(const LitSurface &surface, const Lighting &lighting,
                          const LightBakeSettings &settings, const JobContext &job,
                          const LightPreview &preview)
{
    return LightBaker(surface, lighting, settings, job).bake(preview);
}

} // namespace autocuts::bake
