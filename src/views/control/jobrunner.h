// Runs long computations off the GUI thread, one at a time, with progress and cancelling.
#pragma once

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace autocuts {

//! The interface of JobRunner for a job; to be used on the job's thread only.
class JobControl final
{
public:
    //! True when the job should end soon with what it has so far.
    const std::atomic<bool> &stop() const { return mStop; }
    //! \param fraction in [0, 1]; negative when unknown
    void setProgress(double fraction) { mFraction = fraction; }
    //! Sets the text about the current stage. \param text translated
    void setStage(const QString &text);

private:
    friend class JobRunner;

    std::atomic<bool> mStop = false;
    std::atomic<double> mFraction = -1;
    std::mutex mMutex;
    QString mStage; //!< guarded by the mutex
    std::function<void()> mStageSet;
};

//! Runs jobs on a separate thread. A job gets copies of its input and never uses the document; its result is
//! passed to the GUI thread. An exception ends a job with failed().
class JobRunner final : public QObject
{
    Q_OBJECT

public:
    //! Milliseconds. A cancelled job that takes longer to end does not block later jobs. Chosen so that
    //! cancelling takes effect within 0.2 s.
    static constexpr int cancelPatience = 100;

    //! What cancel() does with a job. EndSoon: asks it to end with what it has; the result is used even when
    //! it comes late, unless another job has started. LetGo: abandons it at once; for work that cannot be
    //! stopped.
    enum class OnCancel { EndSoon, LetGo };

    explicit JobRunner(OnCancel onCancel = OnCancel::EndSoon, QObject *parent = nullptr);
    //! Cancels the running job and waits for it.
    ~JobRunner() override;

    bool isBusy() const { return mControl != nullptr; }
    const QString &title() const { return mTitle; }
    const QString &stage() const { return mStage; }
    //! In [0, 1]; negative when unknown or when no job runs.
    double progress() const;

    //! \param title translated name of the job: "Packing"
    //! \param work called on the job's thread
    //! \param done called on the GUI thread with the result of `work`, also after cancel()
    //! \returns false, and does nothing, when a job is running
    template <class Work, class Finished>
    bool start(const QString &title, Work work, Finished done)
    {
        using Value = decltype(work(std::declval<JobControl &>()));
        auto value = std::make_shared<std::unique_ptr<Value>>();
        return startJob(
            title,
            [value, work = std::move(work)](JobControl &control) mutable {
                *value = std::make_unique<Value>(work(control));
            },
            [value, done = std::move(done)]() mutable { done(std::move(**value)); });
    }

    void cancel();
    //! Abandons the job: it ends in the background, and its result is discarded.
    void abandon();
    //! Waits until no job runs and all results have been passed on; for tests and for closing.
    void waitForDone();

Q_SIGNALS:
    //! A job started, ended, or entered another stage.
    void busyChanged();
    //! Emitted about 20 times a second while a job reports progress.
    void progressChanged();
    //! A job ended with an exception. \param message translated, one line
    void failed(const QString &message);
    //! An abandoned job has ended, and its result was used or discarded.
    void letGoEnded();
    // Emitted on the job's thread. What they are about is passed through members that a mutex guards.
    void stageSet(QPrivateSignal);
    void threadEnded(QPrivateSignal);

private:
    class Thread;

    bool startJob(const QString &title, std::function<void(JobControl &)> work, std::function<void()> done);
    void showStage();
    void takeEnded();
    void jobEnded(Thread *thread);
    void letGo(std::function<void()> done);

    OnCancel mOnCancel;
    std::mutex mMutex;
    std::vector<Thread *> mEnded; //!< not taken yet; guarded by the mutex
    QString mTitle, mStage;
    std::shared_ptr<JobControl> mControl; //!< of the running job
    std::unique_ptr<Thread> mThread;
    std::function<void()> mDone;

    //! An abandoned job.
    struct LetGo
    {
        std::unique_ptr<Thread> thread;
        std::function<void()> done; //!< null: the result is discarded
    };
    std::vector<LetGo> mLetGo;
};

} // namespace autocuts
