// Search directions of the minimiser: approximate solutions p of H p = -g.
#pragma once

#include "model/plain/parallel.h"
#include "solver/base/soup.h"
#include "solver/energy/energyterm.h"

#include <memory>
#include <span>
#include <vector>

namespace autocuts::newton {

//! The unknown that each soup corner belongs to. In the soup every corner has its own; in a cut mesh the
//! corners of a UV vertex share one. A corner with -1 does not move.
struct UnknownMap
{
    std::vector<int> unknown;
    int count = 0;

    //! Every soup corner has its own unknown.
    static UnknownMap identity(int soupCorners);
    bool operator==(const UnknownMap &) const = default;
};

//! Computes Newton directions. Implementations keep what they can between calls (orders, factors).
class NewtonDirection
{
public:
    virtual ~NewtonDirection() = default;

    //! The form of the triangles' blocks that compute() needs.
    virtual energy::HessianBlocks::Precision precision() const
    {
        return energy::HessianBlocks::Precision::Double;
    }
    //! Solves H p = -gradient for the Hessian in `blocks`, exactly or approximately.
    //! \param blocks in the form of precision(); may be overwritten
    //! \param gradient,direction per coordinate of the soup; corners that share an unknown get one direction,
    //! held corners get zero
    //! \throws std::runtime_error when no descent direction can be found
    virtual void compute(energy::HessianBlocks &blocks, std::span<const double> gradient,
                         std::span<double> direction) = 0;
    //! To be called when the parameters of the energy have changed (delta, weights): discards what was kept.
    virtual void invalidate() {}
};

//! Exact Newton: assembles the sparse Hessian and solves it by Cholesky. The symbolic analysis is done once.
std::unique_ptr<NewtonDirection> makeExactDirection(std::shared_ptr<const Soup> soup, UnknownMap map);

//! Solver of the hub matrix: the multifrontal solver of this project, or CHOLMOD alone (for comparison).
enum class HubFactor { Frontal, General };

//! Truncated Newton: conjugate gradients on the same Hessian with the hub preconditioner. A step is 20 to 51
//! times cheaper than an exact one (measured from 3,000 to 124,000 triangles). Only for the soup (one unknown
//! per corner).
//! \param held per soup corner, true where it must not move; empty: none
//! \param team threads to use, not owned; null: the calling thread only
std::unique_ptr<NewtonDirection> makeHubDirection(std::shared_ptr<const Soup> soup, std::vector<bool> held,
                                                  ThreadTeam *team = nullptr,
                                                  HubFactor factor = HubFactor::Frontal);

} // namespace autocuts::newton
