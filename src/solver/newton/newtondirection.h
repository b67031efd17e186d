// Search directions of the minimiser: approximate solutions p of H p = -g.
#pragma once

#include "solver/base/parallel.h"
#include "solver/base/soup.h"
#include "solver/energy/energyterm.h"

#include <memory>
#include <span>
#include <vector>

namespace autocuts::newton {

//! Which unknown each soup corner belongs to. The soup itself has one unknown per corner; a cut mesh shares
//! one between the corners that have been merged. A corner with -1 is held where it is.
struct UnknownMap
{
    std::vector<int> unknown;
    int count = 0;

    //! One unknown per soup corner.
    static UnknownMap identity(int soupCorners);
    bool operator==(const UnknownMap &) const = default;
};

//! How a Newton direction is found. Implementations keep what they can between calls (orders, factors).
class NewtonDirection
{
public:
    virtual ~NewtonDirection() = default;

    //! Which form of the triangles' blocks compute() wants.
    virtual energy::HessianBlocks::Precision precision() const
    {
        return energy::HessianBlocks::Precision::Double;
    }
    //! Solves H p = -gradient for the Hessian given by `blocks`, exactly or nearly.
    //! \param blocks of the wanted precision; may be used up
    //! \param gradient,direction per coordinate of the soup; corners that share an unknown get one direction,
    //!        held corners get zero
    //! \throws std::runtime_error when no descent direction can be found
    virtual void compute(energy::HessianBlocks &blocks, std::span<const double> gradient,
                         std::span<double> direction) = 0;
    //! Says that the energy has changed its shape (another delta, other weights): what was kept is out of
    //! date.
    virtual void invalidate() {}
};

//! Exact Newton: assembles the sparse Hessian and solves it by Cholesky. The symbolic analysis is done once.
std::unique_ptr<NewtonDirection> makeExactDirection(std::shared_ptr<const Soup> soup, UnknownMap map);

//! What factorises the hub matrix: the own multifrontal solver, or CHOLMOD alone (to compare with).
enum class HubFactor { Frontal, General };

//! Truncated Newton: conjugate gradients on the same Hessian with the hub preconditioner, about 20 times
//! cheaper. Only for the soup (one unknown per corner).
//! \param held per soup corner, true where it must not move; empty: none
//! \param team threads to use, not owned; none: the calling one
std::unique_ptr<NewtonDirection> makeHubDirection(std::shared_ptr<const Soup> soup, std::vector<bool> held,
                                                  ThreadTeam *team = nullptr,
                                                  HubFactor factor = HubFactor::Frontal);

} // namespace autocuts::newton
