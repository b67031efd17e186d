// Long work off the GUI thread, one job at a time, with progress and cancel.
#pragma once

#include <QObject>
#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace autocuts {

//! What a job is given to work with; may be used from its thread only.
class JobControl final
{
public:
    //! Becomes true when the job should end soon with what it has.
    const std::atomic<bool> &stop() const { return mStop; }
    //! \param fraction in [0, 1]; negative when not known
    void setProgress(double fraction) { mFraction = fraction; }
    //! What the job does at the moment. \param text translated
    void setStage(const QString &text);

private:
    friend class JobRunner;

    std::atomic<bool> mStop = false;
    std::atomic<double> mFraction = -1;
    std::function<void(const QString &)> mShowStage;
};

//! Runs jobs on a thread of its own. Work gets copies of what it needs and never sees the document; what it
//! returns is handed over in the GUI thread. An exception ends a job with failed().
class JobRunner final : public QObject
{
    Q_OBJECT

public:
    //! Milliseconds after which a cancelled job that has not ended yet does not keep anybody from going on.
    static constexpr int cancelPatience = 100;

    //! What cancel() does with a job: asks it to end with what it has, which when it comes late is used all
    //! the same unless another job has begun; or lets it go at once, for work that cannot be told to stop.
    enum class OnCancel { EndSoon, LetGo };

    explicit JobRunner(OnCancel onCancel = OnCancel::EndSoon, QObject *parent = nullptr);
    //! Cancels what runs and waits for it.
    ~JobRunner() override;

    bool isBusy() const { return mControl != nullptr; }
    const QString &title() const { return mTitle; }
    const QString &stage() const { return mStage; }
    //! In [0, 1]; negative when not known or idle.
    double progress() const;

    //! \param title what is being done, translated: "Packing"
    //! \param work called on the job's thread
    //! \param done called on the GUI thread with what work returned, also after cancel()
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
    //! The job ends whenever it can, out of sight; its result is thrown away.
    void abandon();
    //! Waits until nothing runs and results were handed over; for tests and for closing.
    void waitForDone();

Q_SIGNALS:
    //! A job began, ended, or is in another stage.
    void busyChanged();
    //! About 20 times a second while a job tells its progress.
    void progressChanged();
    //! A job ended with an exception. \param message translated, one line
    void failed(const QString &message);
    //! A job that nobody waited for any more has ended, and its result was used or thrown away.
    void letGoEnded();

private:
    class Thread;

    bool startJob(const QString &title, std::function<void(JobControl &)> work, std::function<void()> done);
    void jobEnded(Thread *thread);
    void releaseCancelled(const JobControl *control);
    void letGo(std::function<void()> done);

    OnCancel mOnCancel;
    QString mTitle, mStage;
    std::shared_ptr<JobControl> mControl; //!< of the job that runs
    std::unique_ptr<Thread> mThread;
    std::function<void()> mDone;

    //! A job that nobody waits for.
    struct LetGo
    {
        std::unique_ptr<Thread> thread;
        std::function<void()> done; //!< null: the result is thrown away
    };
    std::vector<LetGo> mLetGo;
};

} // namespace autocuts
