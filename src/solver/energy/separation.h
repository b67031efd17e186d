// Separation S of the corner pairs (paper, Eq. 3, 4 and 6, and appendix A).
#pragma once

#include "model/plain/parallel.h"
#include "solver/base/soup.h"
#include "solver/energy/energyterm.h"

#include <memory>

namespace autocuts::energy {

//! factor / 2 * sum over corner pairs of weight * s_delta, with s_delta = t / (t + delta) and t the squared
//! distance of the pair. An edge has two corner pairs, so a fully cut edge counts its weight once. The
//! Hessian is a majoriser, a spring of constant factor * weight * delta / (t + delta)^2, which is always
//! positive (appendix A).
class SeparationTerm final : public EnergyTerm
{
public:
    //! \param team threads to use, not owned; null: the calling thread only
    explicit SeparationTerm(std::shared_ptr<const Soup> soup, ThreadTeam *team = nullptr)
        : mSoup(std::move(soup)), mTeam(team)
    {}

    void setFactor(double factor) { mFactor = factor; }
    void setDelta(double delta) { mDelta = delta; }
    //! \pre one weight >= 0 per corner pair
    void setWeights(std::vector<double> weights) { mWeights = std::move(weights); }
    const std::vector<double> &weights() const { return mWeights; }
    double delta() const { return mDelta; }

    double value(std::span<const double> x) const override;
    double addDerivatives(std::span<const double> x, std::span<double> gradient,
                          HessianBlocks &blocks) const override;

    //! s_delta of one corner pair, in [0, 1).
    double separation(std::span<const double> x, int pair) const;

private:
    std::shared_ptr<const Soup> mSoup;
    ThreadTeam *mTeam;
    std::vector<double> mWeights;
    double mFactor = 0;
    double mDelta = 1;
};

//! Weights of the corner pairs for the settings and the steering of a snapshot. A pair weighs the length of
//! its edge, or the mean edge length when seams are weighted by count (so that lambda keeps its meaning);
//! times the painted weight; times 100 when joined or on a diagonal; 0 when cut.
std::vector<double> pairWeights(const Soup &soup, const Snapshot &snapshot);

} // namespace autocuts::energy
