// Counted work in place of a clock, and the flag that stops it. Plain: no Qt.
#pragma once

#include "solver/base/jobcontext.h"

#include <atomic>
#include <functional>

namespace autocuts::packing {

//! Adds up what the kernels report, in calibrated nanoseconds of one core. Results depend on it, so it must
//! never look at a clock.
class WorkMeter
{
public:
    //! \param job told the part of the limit that is used up
    explicit WorkMeter(double limitSeconds, const JobContext &job = {})
        : mLimit(limitSeconds * 1e9), mJob(job)
    {}

    void add(double nanoseconds)
    {
        mSpent += nanoseconds;
        if (mJob.reports() && mSpent >= mNextReport) {
            mJob.report(fraction());
            mNextReport = mSpent + 0.01 * mLimit;
        }
    }

    //! Part of the limit that is used up.
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
