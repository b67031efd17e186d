// Counted work in place of a clock, with stopping and progress. Plain: no Qt.
#pragma once

#include "solver/base/jobcontext.h"

namespace autocuts::packing {

//! Adds up the work that the parts of the packer report, in nominal nanoseconds of one core. Results depend
//! on it, so it never reads a clock. The factors at the calls of add() estimate times; how they were
//! calibrated is not on record.
class WorkMeter
{
public:
    //! \param limitSeconds nominal seconds; 0: no effort is left from the start
    //! \param job receives the share of the limit that is used up, and is asked whether to stop
    explicit WorkMeter(double limitSeconds, const JobContext &job = {})
        : mLimit(limitSeconds * 1e9), mJob(job)
    {}

    //! Adds work and reports progress at every percent.
    void add(double nanoseconds)
    {
        mSpent += nanoseconds;
        if (mJob.reports() && mSpent >= mNextReport) {
            mJob.report(fraction());
            mNextReport = mSpent + 0.01 * mLimit;
        }
    }

    //! Share of the limit that is used up, in [0, 1].
    double fraction() const { return mLimit > 0 && mSpent < mLimit ? mSpent / mLimit : 1; }
    bool exhausted() const { return mSpent >= mLimit; }
    double spentSeconds() const { return mSpent * 1e-9; }
    bool cancelled() const { return mJob.stopped(); }
    bool stop() const { return exhausted() || cancelled(); }

private:
    double mLimit;
    double mSpent = 0;
    double mNextReport = 0;
    JobContext mJob;
};

} // namespace autocuts::packing
