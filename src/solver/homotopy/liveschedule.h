// Who chooses lambda and delta of a live solve.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/homotopy/budget.h"
#include "solver/homotopy/solver.h"

#include <atomic>
#include <functional>
#include <vector>

namespace autocuts::homotopy {

//! Manual: the user does. Budget: the solver does, for a distortion bound.
enum class SolveMode { Manual, Budget };

//! The automatic schedule (paper, Algorithm 1) one step at a time: delta goes down level by level; then,
//! warmed up again, with the lambda that brings the distortion nearer to the bound, until it is there. If the
//! search for that lambda does not end, the lambda of the best round that kept the bound has another round.
//! If that one does not keep it, or none did, lambda is lowered round by round until one does.
class LiveSchedule
{
public:
    //! \param maxDistortion bound on the mean distortion, > 4
    LiveSchedule(const Soup &soup, double maxDistortion);

    //! Puts lambda and delta of the next step into the settings.
    void apply(SolveSettings &settings) const;
    //! Goes on with a run that had come to these values.
    void resume(double lambda, double delta);
    //! The steering changed: warms up a little and looks for the balance again.
    void reheat();
    //! Tells what the step gave. \returns false when the bound is reached and nothing is left to do
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
    double mKeptLambda = 0, mKeptDistortion = 0; //!< of the best round that kept the bound; 0: none did
};

//! Takes the steps that are left of a run that was paused at the lambda and delta of the solver.
//! \param onStep called before each step \returns false when stopped
bool runToTheEnd(Solver &solver, double maxDistortion, const JobContext &job = {},
                 const std::function<void()> &onStep = {});

} // namespace autocuts::homotopy
