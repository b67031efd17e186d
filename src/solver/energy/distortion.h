// The distortion D of the map (paper, Eq. 2): area-weighted mean of a density over the triangles.
#pragma once

#include "model/plain/parallel.h"
#include "solver/base/soup.h"
#include "solver/energy/energyterm.h"

#include <memory>

namespace autocuts::energy {

//! factor * sum over triangles of weight_t * e(s1, s2), where s1 and s2 are the singular values of the
//! Jacobian. Infinite unless every triangle is positively oriented.
class DistortionTerm : public EnergyTerm
{
public:
    virtual void setFactor(double factor) = 0;
};

//! Makes the term for one of the densities of isotropic.h.
//! \param team threads to use, not owned; null: the calling thread only
std::unique_ptr<DistortionTerm> makeDistortionTerm(std::shared_ptr<const Soup> soup, DistortionEnergy kind,
                                                   ThreadTeam *team = nullptr);

//! Symmetric Dirichlet energy (paper, Eq. 5) of each triangle at x; infinite where flipped.
std::vector<double> symmetricDirichlet(const Soup &soup, std::span<const double> x);

//! Smallest step at which a triangle loses its area when x moves along `direction` (Smith and Schaefer 2015);
//! `limit` when no triangle does before that.
double maxFlipFreeStep(const Soup &soup, std::span<const double> x, std::span<const double> direction,
                       double limit, ThreadTeam *team = nullptr);

} // namespace autocuts::energy
