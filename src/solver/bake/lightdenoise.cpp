#include "solver/bake/lightdenoise.h"

#include "model/plain/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace autocuts::bake {

namespace {

//! Steps of 1, 2, 4, 8 texels: 61 texels take part in each.
constexpr int rounds = 4;
//! Values that differ by as many standard errors count a third. Of 1 to 8, the one with the least error at 4
//! to 256 samples in the room of tst_lightbake.
constexpr float tolerance = 2.5F;
//! Texels around one whose variance is averaged.
constexpr int varianceReach = 2;
//! Farther away than so many times the distance in the map is elsewhere on the surface.
constexpr float stretch = 3;
constexpr std::array<float, 3> spline{0.375F, 0.25F, 0.0625F}; //!< by distance from the middle

float luminanceOf(std::span<const float> color)
{
    return 0.2126F * color[0] + 0.7152F * color[1] + 0.0722F * color[2];
}

//! One picture of a round to the next.
class Filter final
{
public:
    Filter(const Picture &light, const TexelGuides &guides, int step)
        : mLight(light), mGuides(guides), mStep(step)
    {}

    void apply(int x, int y, std::span<float> color, float &variance) const
    {
        const std::size_t own = indexOf(x, y);
        const float deviation = std::sqrt(meanVariance(x, y));
        Vec3f sum = Vec3f::Zero();
        float weights = 0, variances = 0;
        for (int dy = -2; dy <= 2; ++dy) {
            for (int dx = -2; dx <= 2; ++dx) {
                const int x2 = x + dx * mStep, y2 = y + dy * mStep;
                if (!isFilled(x2, y2))
                    continue;
                const std::size_t other = indexOf(x2, y2);
                const float texels = static_cast<float>(mStep) * std::hypot(float(dx), float(dy));
                const float weight = spline[std::abs(dx)] * spline[std::abs(dy)] *
                                     likeness(own, other, texels) * closeness(x, y, x2, y2, deviation);
                const auto value = mLight.at(x2, y2);
                sum += weight * Vec3f(value[0], value[1], value[2]);
                weights += weight;
                variances += weight * weight * mGuides.variance[other];
            }
        }
        for (int k = 0; k < 3; ++k)
            color[k] = sum[k] / weights;
        variance = variances / (weights * weights);
    }

private:
    std::size_t indexOf(int x, int y) const { return std::size_t(y) * mLight.width + x; }
    bool isFilled(int x, int y) const
    {
        return x >= 0 && y >= 0 && x < mLight.width && y < mLight.height && mGuides.filled[indexOf(x, y)];
    }

    //! Of the surface at two texels. \param texels between them
    float likeness(std::size_t own, std::size_t other, float texels) const
    {
        if (own == other)
            return 1;
        const Vec3f way = mGuides.position[other] - mGuides.position[own];
        const float expected = texels * std::max(mGuides.size[own], mGuides.size[other]);
        if (way.norm() > stretch * expected)
            return 0;
        const float facing = std::max(0.0F, mGuides.normal[own].dot(mGuides.normal[other]));
        const float height = mGuides.normal[own].dot(way) / std::max(expected, 1e-20F);
        return std::pow(facing, 32.0F) * std::exp(-4 * height * height);
    }

    //! Of the values of two texels.
    float closeness(int x, int y, int x2, int y2, float deviation) const
    {
        const float difference = std::abs(luminanceOf(mLight.at(x, y)) - luminanceOf(mLight.at(x2, y2)));
        const float share = difference / (tolerance * deviation + 1e-12F);
        return std::exp(-share * share);
    }

    //! The variance of single texels is noisy itself.
    float meanVariance(int x, int y) const
    {
        float sum = 0, count = 0;
        for (int dy = -varianceReach; dy <= varianceReach; ++dy) {
            for (int dx = -varianceReach; dx <= varianceReach; ++dx) {
                if (isFilled(x + dx, y + dy)) {
                    sum += mGuides.variance[indexOf(x + dx, y + dy)];
                    ++count;
                }
            }
        }
        return sum / count;
    }

    const Picture &mLight;
    const TexelGuides &mGuides;
    int mStep;
};

} // namespace

void denoiseLight(Picture &light, TexelGuides guides, const JobContext &job)
{
    Picture next = light;
    std::vector<float> variance = guides.variance;
    for (int round = 0; round < rounds; ++round) {
        const Filter filter(light, guides, 1 << round);
        parallelFor(light.height, job.threads(), [&](int y) {
            for (int x = 0; x < light.width && !(x % 64 == 0 && job.stopped()); ++x) {
                const std::size_t texel = std::size_t(y) * light.width + x;
                if (guides.filled[texel])
                    filter.apply(x, y, next.at(x, y), variance[texel]);
            }
        });
        if (job.stopped())
            return;
        std::swap(light, next);
        std::swap(guides.variance, variance);
        job.report(double(round + 1) / rounds);
    }
}

} // namespace autocuts::bake
