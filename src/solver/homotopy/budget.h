// Finds the lambda at which a run ends with a wanted distortion.
#pragma once

#include <vector>

namespace autocuts::homotopy {

//! Steers lambda towards a distortion bound over repeated runs: the distortion above 4 grows about as a power
//! of lambda, so the search is a damped secant in the logarithms of both.
class DistortionBudget
{
public:
    //! \param bound wanted mean symmetric Dirichlet energy, > 4
    DistortionBudget(double bound, double firstLambda);

    double lambda() const { return mLambda; }
    //! Tells what the run at lambda() gave; afterwards lambda() is the next one to try.
    void report(double distortion);

private:
    double mTarget; //!< a little below the bound, in units above 4
    double mLambda;
    double mLastLambda = 0, mLastExcess = 0;
};

} // namespace autocuts::homotopy
