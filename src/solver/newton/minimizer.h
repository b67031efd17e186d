// Newton steps on a sum of energy terms, with a line search that never flips a triangle.
#pragma once

#include "solver/base/soup.h"
#include "solver/energy/energyterm.h"
#include "solver/newton/newtondirection.h"

#include <memory>
#include <vector>

namespace autocuts::newton {

//! Minimises the sum of its terms over the coordinates of a soup (paper, section 3.2).
class Minimizer
{
public:
    struct Step
    {
        double before = 0, after = 0; //!< energy
        double length = 0;            //!< step length taken; 0 when no descent was found
        std::vector<double> values;   //!< of each term, after the step
    };

    //! \param team threads to use, not owned; null: the calling thread only
    Minimizer(std::shared_ptr<const Soup> soup, std::unique_ptr<NewtonDirection> direction,
              ThreadTeam *team = nullptr);

    //! Sets the terms, which are not owned and must outlive the next step.
    void setTerms(std::vector<const energy::EnergyTerm *> terms);
    //! To be called when a term has changed its parameters.
    void invalidate();

    double energy(std::span<const double> x) const;
    //! Moves x one step downhill. \pre every triangle is positively oriented at x
    Step step(std::vector<double> &x);

private:
    //! Energy at x + length * mMove. That point is written to mTrial, the values of the terms to mValues.
    double tryStep(const std::vector<double> &x, double length);

    std::shared_ptr<const Soup> mSoup;
    ThreadTeam *mTeam;
    std::unique_ptr<NewtonDirection> mDirection;
    std::vector<const energy::EnergyTerm *> mTerms;
    energy::HessianBlocks mBlocks;
    std::vector<double> mGradient, mMove, mTrial, mValues;
};

} // namespace autocuts::newton
