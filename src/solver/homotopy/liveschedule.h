// Schedule of lambda and delta of a live solve.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/homotopy/budget.h"
#include "solver/homotopy/solver.h"

#include <functional>
#include <vector>

namespace autocuts::homotopy {

//! Manual: the user chooses lambda and delta. Budget: the solver chooses them for a distortion bound.
enum class SolveMode { Manual, Budget };

//! The automatic schedule (paper, Algorithm 1), one step at a time. The first *round* lowers delta level by
//! level. Each further round reheats (raises delta a little and lowers it again) with a lambda that brings
//! the distortion nearer to the bound, until it is close below. If that search does not end, there is one
//! more round with the lambda of the best round that kept the bound. If that round does not keep it, or if
//! none did, lambda is lowered from round to round until one does.
class LiveSchedule
{
public:
    //! \param maxDistortion bound on the mean distortion, > 4
    LiveSchedule(const Soup &soup, double maxDistortion);

    double maxDistortion() const { return mBound; }

    //! Writes lambda and delta of the next step into the settings.
    void apply(SolveSettings &settings) const;
    //! Continues a run that had reached these values.
    void resume(double lambda, double delta);
    //! To be called when the steering has changed: reheats and searches the lambda again.
    void reheat();
    //! Reports the result of a step.
    //! \returns false when the run is complete
    bool report(const StepResult &step);

private:
    bool chooseLambda(double distortion);
    const std::vector<double> &levels() const { return mRound == 0 ? mLevels : mReheatLevels; }

    DistortionBudget mBudget;
    double mBound;
    std::vector<double> mLevels, mReheatLevels;
    std::size_t mLevel = 0;
    int mStep = 0, mRound = 0;
    double mEnergy = 0;
    double mKeptLambda = 0, mKeptDistortion = 0; //!< of the best round that kept the bound; 0: no round did
};

//! Takes the remaining steps of a run that was paused at the lambda and delta of the solver.
//! \param onStep called before each step
//! \returns false when stopped
bool runToTheEnd(Solver &solver, double maxDistortion, const JobContext &job = {},
                 const std::function<void()> &onStep = {});

} // namespace autocuts::homotopy
