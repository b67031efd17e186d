// What a long computation is given to work with: when to end early, whom to tell how far it is, how many
// threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>

namespace autocuts {

//! Part of a job that is being done, as far as a user wants to know it.
enum class JobStage { Working, SolvingToTheEnd, Packing };

//! How far a job is.
struct JobProgress
{
    double fraction = 0; //!< of the whole job, in [0, 1]
    JobStage stage = JobStage::Working;
    double distortion = 0; //!< of the best map so far, 0 while there is none
    double seamLength = 0; //!< of the best map so far, solver units
};

//! Passed by reference through everything that takes long. The default never stops, tells nobody and has one
//! thread. Results do not depend on the number of threads.
class JobContext
{
public:
    //! Called from one thread at a time, not always the same one.
    using Sink = std::function<void(const JobProgress &)>;

    JobContext() = default;
    //! \param stop when it becomes true the job ends soon, with what it has; outlives the job; null: never
    JobContext(const std::atomic<bool> *stop, int threads = 1, Sink sink = {})
        : mStop(stop), mThreads(std::max(1, threads)), mSink(std::move(sink))
    {}

    bool stopped() const { return mStop && mStop->load(std::memory_order_relaxed); }
    int threads() const { return mThreads; }

    //! \param fraction of this part of the job, in [0, 1]
    void report(double fraction) const { report(JobProgress{fraction, mStage}); }
    void report(JobProgress progress) const
    {
        if (!mSink)
            return;
        progress.fraction = mBegin + (mEnd - mBegin) * progress.fraction;
        mSink(progress);
    }
    bool reports() const { return static_cast<bool>(mSink); }

    //! A part of this job, from one fraction of it to another.
    JobContext part(double begin, double end, JobStage stage = JobStage::Working) const
    {
        JobContext result = *this;
        result.mBegin = mBegin + (mEnd - mBegin) * begin;
        result.mEnd = mBegin + (mEnd - mBegin) * end;
        result.mStage = stage;
        return result;
    }
    //! The same with another one to be told.
    JobContext watchedBy(Sink sink) const { return {mStop, mThreads, std::move(sink)}; }
    //! The same without reports: for work whose share of the whole is not known.
    JobContext quiet() const { return {mStop, mThreads}; }
    //! The same with one thread and no reports: for jobs that run beside each other.
    JobContext alone() const { return {mStop, 1}; }
    //! The same but not to be stopped: for what must be done even in a hurry.
    JobContext unstoppable() const
    {
        JobContext result = *this;
        result.mStop = nullptr;
        return result;
    }

private:
    const std::atomic<bool> *mStop = nullptr;
    int mThreads = 1;
    Sink mSink;
    double mBegin = 0, mEnd = 1;
    JobStage mStage = JobStage::Working;
};

} // namespace autocuts
