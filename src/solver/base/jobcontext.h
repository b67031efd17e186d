// Context of a long computation: stop flag, progress callback and number of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>

namespace autocuts {

//! Stage of a job, as it is shown to the user. Preparing: models are read and made ready. Nothing is found
//! yet, and a stop may not end that soon.
enum class JobStage { Working, Preparing, SolvingToTheEnd, Refining, Packing };

//! Progress of a job.
struct JobProgress
{
    double fraction = 0; //!< of the whole job, in [0, 1]
    JobStage stage = JobStage::Working;
    double distortion = 0; //!< of the best map so far, 0 while there is none
    double seamLength = 0; //!< of the best map so far, solver units
};

//! Passed by reference to every long computation. A default context never stops, reports no progress and
//! allows one thread. Results do not depend on the number of threads.
class JobContext
{
public:
    //! Receives progress; called from one thread at a time, but not always from the same one.
    using Sink = std::function<void(const JobProgress &)>;

    JobContext() = default;
    //! \param stop when it becomes true, the job ends soon and returns what it has; must outlive the job;
    //! null: the job is never stopped
    JobContext(const std::atomic<bool> *stop, int threads = 1, Sink sink = {})
        : mStop(stop), mThreads(std::max(1, threads)), mSink(std::move(sink))
    {}

    bool stopped() const { return mStop && mStop->load(std::memory_order_relaxed); }
    //! For functions that know nothing of jobs.
    const std::atomic<bool> &stopFlag() const
    {
        static const std::atomic<bool> never = false;
        return mStop ? *mStop : never;
    }
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
    //! A stage begins.
    void enter(JobStage stage) const { part(0, 1, stage).report(0); }
    bool reports() const { return static_cast<bool>(mSink); }

    //! Context for a part of this job: its progress from 0 to 1 is reported as `begin` to `end` of this job.
    JobContext part(double begin, double end, JobStage stage = JobStage::Working) const
    {
        JobContext result = *this;
        result.mBegin = mBegin + (mEnd - mBegin) * begin;
        result.mEnd = mBegin + (mEnd - mBegin) * end;
        result.mStage = stage;
        return result;
    }
    //! The same with another progress callback, which receives fractions from 0 to 1.
    JobContext watchedBy(Sink sink) const { return with(mThreads, std::move(sink)); }
    //! The same without progress reports: for work whose share of the whole is not known.
    JobContext quiet() const { return with(mThreads); }
    //! The same with one thread and without progress reports: for jobs that run in parallel with each other.
    JobContext alone() const { return with(1); }
    //! The same without the stop flag: for work that must be completed even after a stop.
    JobContext unstoppable() const
    {
        JobContext result = *this;
        result.mStop = nullptr;
        return result;
    }

    //! The same, and counts the work, see addWork(). \param work must outlive the job
    JobContext countedBy(std::atomic<long long> &work) const
    {
        JobContext result = *this;
        result.mWork = &work;
        return result;
    }
    //! Adds to the counted work: for every Newton step, the triangles that it may move. Unlike time, that is
    //! the same on every machine.
    void addWork(long long triangles) const
    {
        if (mWork)
            mWork->fetch_add(triangles, std::memory_order_relaxed);
    }

private:
    JobContext with(int threads, Sink sink = {}) const
    {
        JobContext result(mStop, threads, std::move(sink));
        result.mWork = mWork;
        return result;
    }

    const std::atomic<bool> *mStop = nullptr;
    std::atomic<long long> *mWork = nullptr;
    int mThreads = 1;
    Sink mSink;
    double mBegin = 0, mEnd = 1;
    JobStage mStage = JobStage::Working;
};

} // namespace autocuts
