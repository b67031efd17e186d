// Runs long computations off the GUI thread, one at a time, with progress and cancelling.
#pragma once

#include "views/ui/task.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <atomic>
#include <functional>
#include <memory>
#include <utility>

namespace autocuts {

//! The interface of JobRunner for a job; to be used on the job's thread only.
class JobControl final
{
public:
    //! True when the job should end soon with what it has so far.
    const std::atomic<bool> &stop() const { return *mStop; }
    //! \param fraction in [0, 1]; negative when unknown
    void setProgress(double fraction) { mFraction = fraction; }
    //! Sets the text about the current stage. \param text translated
    void setStage(const QString &text)
    {
        if (mSetStage)
            mSetStage(text);
    }

private:
    friend class JobRunner;

    static inline const std::atomic<bool> never = false;
    const std::atomic<bool> *mStop = &never; //!< so without a runner
    std::atomic<double> mFraction = -1;
    std::function<void(const QString &)> mSetStage;
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
    //! Cancels the running job, and waits for it and for abandoned ones.
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
        if (isBusy())
            return false;
        auto control = beginJob(title);
        using Value = decltype(work(*control));
        mTask.start(
            [control, work = std::move(work)](const std::atomic<bool> &stop) mutable {
                control->mStop = &stop;
                return work(*control);
            },
            [this, control, done = std::move(done)](Value value) mutable {
                endJob(control);
                done(std::move(value));
            },
            [this, control](const QString &message) {
                if (endJob(control))
                    Q_EMIT failed(message);
            });
        return true;
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

private:
    std::shared_ptr<JobControl> beginJob(const QString &title);
    bool endJob(const std::shared_ptr<JobControl> &control);
    void leaveJob();

    OnCancel mOnCancel;
    Task mTask{true};
    QTimer mTicker;
    QString mTitle, mStage;
    std::shared_ptr<JobControl> mControl; //!< of the running job
    Inbox<QString> mStages;               //!< of the running job
};

} // namespace autocuts
