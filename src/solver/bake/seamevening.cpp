#include "solver/bake/seamevening.h"

#include <Eigen/Core>

#include <algorithm>

namespace autocuts::bake {

namespace {

//! What a change of a texel costs beside a difference across a seam. Chosen by hand: smaller ones bring the
//! sides no closer that could be seen.
constexpr float keepWeight = 0.01F;
//! Between places that are farther apart than a texel, the sides would still differ.
constexpr double placesPerTexel = 2;
constexpr int mostEveningSteps = 100;
//! The gradient that is left, as a share of the first one.
constexpr float smallestShare = 1e-3F;

//! The difference between both sides of a place as a linear function of texels.
struct Difference
{
    std::array<std::array<int, 4>, 2> texel{}; //!< rows of Values
    std::array<std::array<float, 4>, 2> weight{};
    std::array<Eigen::Matrix3f, 2>
        frame; //!< applied to the value of each side, for directions in tangent space
};

//! For pictures of one or three channels.
template <int channels>
class Evening final
{
public:
    //! One row per texel.
    using Values = Eigen::Matrix<float, Eigen::Dynamic, channels, channels == 1 ? 0 : int(Eigen::RowMajor)>;
    using Value = Eigen::Matrix<float, 1, channels>;

    Evening(const ShadedSurface &low, const Eigen::AlignedBox2d &tile, bool inTangentSpace,
            const std::vector<std::uint8_t> &filled, const Picture &picture)
        : mInTangentSpace(inTangentSpace)
    {
        std::vector<std::array<TexelBlend, 2>> blends;
        const Eigen::Array2i size(picture.width, picture.height);
        for (const SeamPlace &place : seamPlaces(low, tile, size, placesPerTexel)) {
            std::array<TexelBlend, 2> blend;
            Difference difference;
            bool complete = true;
            for (int which = 0; which < 2; ++which) {
                blend[which] = blendAt(picture.width, picture.height, place.uv[which]);
                for (const std::size_t texel : blend[which].texel)
                    complete = complete && filled[texel];
                difference.weight[which] = blend[which].weights();
                if (inTangentSpace)
                    difference.frame[which] = low.tangentFrame(place.side[which]);
                complete = complete && (!inTangentSpace || difference.frame[which].allFinite());
            }
            if (!complete)
                continue;
            for (const TexelBlend &side : blend)
                mTexels.insert(mTexels.end(), side.texel.begin(), side.texel.end());
            blends.push_back(blend);
            mDifferences.push_back(difference);
        }
        std::ranges::sort(mTexels);
        mTexels.erase(std::ranges::unique(mTexels).begin(), mTexels.end());
        for (std::size_t i = 0; i < blends.size(); ++i) {
            for (int which = 0; which < 2; ++which) {
                for (int k = 0; k < 4; ++k)
                    mDifferences[i].texel[which][k] = static_cast<int>(
                        std::ranges::lower_bound(mTexels, blends[i][which].texel[k]) - mTexels.begin());
            }
        }
    }

    //! Conjugate gradients for the change of the texels.
    void run(Picture &picture, const JobContext &job) const
    {
        const auto texelOf = [&](std::size_t i) {
            return Eigen::Map<Value>(picture.values.data() + mTexels[i] * channels);
        };
        Values before(mTexels.size(), channels);
        for (std::size_t i = 0; i < mTexels.size(); ++i)
            before.row(Eigen::Index(i)) = texelOf(i);
        Values change = Values::Zero(before.rows(), channels);
        Values rest = -normalProduct(before, 0);
        Values direction = rest;
        float size = rest.squaredNorm();
        const float enough = size * smallestShare * smallestShare;
        for (int step = 0; step < mostEveningSteps && size > enough && !job.stopped(); ++step) {
            const Values image = normalProduct(direction, keepWeight);
            const float length = size / direction.cwiseProduct(image).sum();
            change += length * direction;
            rest -= length * image;
            const float next = rest.squaredNorm();
            direction = rest + next / size * direction;
            size = next;
        }
        if (!change.allFinite())
            return;
        for (std::size_t i = 0; i < mTexels.size(); ++i) {
            Value value = before.row(Eigen::Index(i)) + change.row(Eigen::Index(i));
            if (mInTangentSpace)
                value.stableNormalize();
            texelOf(i) = value;
        }
    }

private:
    //! The matrix of the normal equations, times values: differences, and the change of texels times a
    //! weight.
    Values normalProduct(const Values &values, float keep) const
    {
        Values product = keep * values;
        for (const Difference &difference : mDifferences) {
            const Value apart = side(difference, 0, values) - side(difference, 1, values);
            addSide(difference, 0, apart, product);
            addSide(difference, 1, -apart, product);
        }
        return product;
    }

    //! What a side shows.
    Value side(const Difference &difference, int which, const Values &values) const
    {
        Value sum = Value::Zero();
        for (int k = 0; k < 4; ++k)
            sum += difference.weight[which][k] * values.row(difference.texel[which][k]);
        if constexpr (channels == 3) {
            if (mInTangentSpace)
                return (difference.frame[which] * sum.transpose()).transpose();
        }
        return sum;
    }

    //! The transpose of side().
    void addSide(const Difference &difference, int which, Value value, Values &product) const
    {
        if constexpr (channels == 3) {
            if (mInTangentSpace)
                value = (difference.frame[which].transpose() * value.transpose()).transpose().eval();
        }
        for (int k = 0; k < 4; ++k)
            product.row(difference.texel[which][k]) += difference.weight[which][k] * value;
    }

    bool mInTangentSpace;
    std::vector<std::size_t> mTexels; //!< of the picture, by row of Values; ascending
    std::vector<Difference> mDifferences;
};

} // namespace

void evenSeams(const ShadedSurface &low, const Eigen::AlignedBox2d &tile, bool inTangentSpace,
               const std::vector<std::uint8_t> &filled, Picture &picture, const JobContext &job)
{
    if (picture.channels == 1)
        Evening<1>(low, tile, inTangentSpace, filled, picture).run(picture, job);
    else
        Evening<3>(low, tile, inTangentSpace, filled, picture).run(picture, job);
}

} // namespace autocuts::bake
