// Counted work in place of a clock, and the flag that stops it. Plain: no Qt.
#pragma once

#include <atomic>
#include <functional>

namespace autocuts::packing {

//! Adds up what the kernels report, in calibrated nanoseconds of one core. Results depend on it, so it must
//! never look at a clock.
class WorkMeter
{
public:
    WorkMeter(double limitSeconds, const std::atomic<bool> *cancel, std::function<void(double)> progress = {})
        : mLimit(limitSeconds * 1e9), mCancel(cancel), mProgress(std::move(progress))
    {}

    void add(double nanoseconds)
    {
        mSpent += nanoseconds;
        if (mProgress && mSpent >= mNextReport) {
            mProgress(fraction());
            mNextReport = mSpent + 0.01 * mLimit;
        }
    }

    //! Part of the limit that is used up.
    double fraction() const { return mLimit > 0 && mSpent < mLimit ? mSpent / mLimit : 1; }
    bool exhausted() const { return mSpent >= mLimit; }
    double spentSeconds() const { return mSpent * 1e-9; }
    bool cancelled() const { return mCancel && mCancel->load(std::memory_order_relaxed); }
    bool stop() const { return exhausted() || cancelled(); }

private:
    double mLimit;
    double mSpent = 0;
    double mNextReport = 0;
    const std::atomic<bool> *mCancel;
    std::function<void(double)> mProgress;
};

} // namespace autocuts::packing
