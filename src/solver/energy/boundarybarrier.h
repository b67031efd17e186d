// Barrier term that keeps the boundary of each chart from crossing itself (Smith and Schaefer 2015).
#pragma once

#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"
#include "solver/energy/energyterm.h"

#include <memory>
#include <vector>

namespace autocuts::energy {

//! factor * sum of (reach / d - 1)^2 over all pairs of a boundary vertex and a boundary edge of the same
//! chart whose distance d is less than `reach`; infinite where two boundary edges of one chart cross. A chart
//! that is a disk and has neither a flipped triangle nor such a crossing does not overlap itself. The Hessian
//! is a diagonal upper bound of the Gauss-Newton Hessian.
class BoundaryBarrierTerm final : public EnergyTerm
{
public:
    //! \param x the initial map: boundary vertices that coincide there do not repel each other
    //! \param reach in solver units; should be small compared with the edges
    BoundaryBarrierTerm(const Soup &soup, const CutMesh &cut, std::span<const double> x, double factor,
                        double reach);

    double value(std::span<const double> x) const override;
    double addDerivatives(std::span<const double> x, std::span<double> gradient,
                          HessianBlocks &blocks) const override;

private:
    //! A boundary side from its start to its end; both are soup corners that represent their UV vertices.
    struct Segment
    {
        int from, to;
        int fromPlace, toPlace; //!< positions in the initial map; equal numbers coincide
        int chart;
    };
    struct Contact
    {
        int point, segment;
    };

    //! Collects all pairs of a segment's start and another segment that may be within reach.
    //! \return false when two segments cross
    bool collect(std::span<const double> x, std::vector<Contact> &contacts) const;

    std::vector<Segment> mSegments;
    double mFactor, mReach;
};

} // namespace autocuts::energy
