// Finds the lambda at which a run ends with a wanted distortion.
#pragma once

#include <vector>

namespace autocuts::homotopy {

//! Adjusts lambda to a distortion bound over repeated runs. The distortion above 4 grows about as a power of
//! lambda, so the search is a damped secant method in the logarithms of both.
class DistortionBudget
{
public:
    //! \param bound wanted mean symmetric Dirichlet energy, > 4
    DistortionBudget(double bound, double firstLambda);

    double lambda() const { return mLambda; }
    //! Reports the distortion of the run at lambda(); afterwards lambda() is the next one to try.
    void report(double distortion);

private:
    double mTarget; //!< distortion above 4 that is aimed at, a little below the bound
    double mLambda;
    double mLastLambda = 0, mLastExcess = 0;
};

} // namespace autocuts::homotopy
