// Keeps the boundary of each chart from crossing itself (Smith and Schaefer 2015).
#pragma once

#include "solver/base/cutmesh.h"
#include "solver/base/soup.h"
#include "solver/energy/energyterm.h"

#include <memory>
#include <vector>

namespace autocuts::energy {

//! factor * sum of (reach / d - 1)^2 over the boundary vertices and the boundary edges of the same chart that
//! are nearer to each other than `reach` (d is their distance), infinite where two boundary edges of one
//! chart cross. A chart that is a disk, has no flipped triangle and no such crossing does not overlap itself.
//! The Hessian is a diagonal bound of the Gauss-Newton one.
class BoundaryBarrierTerm final : public EnergyTerm
{
public:
    //! \param x where the map is at first: boundary vertices at exactly the same place do not repel each
    //! other \param reach in solver units; small against the edges
    BoundaryBarrierTerm(const Soup &soup, const CutMesh &cut, std::span<const double> x, double factor,
                        double reach);

    double value(std::span<const double> x) const override;
    double addDerivatives(std::span<const double> x, std::span<double> gradient,
                          HessianBlocks &blocks) const override;

private:
    //! A boundary side, from its start to its end, as soup corners that stand for their UV vertices.
    struct Segment
    {
        int from, to;
        int fromPlace, toPlace; //!< equal numbers: at the same place at first
        int chart;
    };
    struct Contact
    {
        int point, segment;
    };

    //! Pairs of a segment's start and another segment that may be within reach; false when two segments
    //! cross.
    bool collect(std::span<const double> x, std::vector<Contact> &contacts) const;

    std::vector<Segment> mSegments;
    double mFactor, mReach;
};

} // namespace autocuts::energy
