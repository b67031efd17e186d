#include "views/control/session/jobrunner.h"

namespace autocuts {

JobRunner::JobRunner(OnCancel onCancel, QObject *parent) : QObject(parent), mOnCancel(onCancel)
{
    constexpr int progressInterval = 50; // milliseconds
    mTicker.setInterval(progressInterval);
    connect(&mTicker, &QTimer::timeout, this, &JobRunner::progressChanged);
}

JobRunner::~JobRunner()
{
    mTask.drop();
    mTask.waitForDropped();
}

double JobRunner::progress() const
{
    return mControl ? mControl->mFraction.load() : -1;
}

std::shared_ptr<JobControl> JobRunner::beginJob(const QString &title)
{
    mControl = std::make_shared<JobControl>();
    mControl->mSetStage = mStages.open<QString>(
        [this](const QString &stage) {
            mStage = stage;
            Q_EMIT busyChanged();
        },
        [](std::optional<QString> &newest, const QString &stage) { newest = stage; });
    mTitle = title;
    mStage.clear();
    mTicker.start();
    Q_EMIT busyChanged();
    return mControl;
}

//! \returns false when the job has been left before
bool JobRunner::endJob(const std::shared_ptr<JobControl> &control)
{
    const bool isRunning = control == mControl;
    if (isRunning)
        leaveJob();
    return isRunning;
}

//! Other jobs may start.
void JobRunner::leaveJob()
{
    mControl.reset();
    mStages.close();
    mStage.clear();
    mTicker.stop();
    Q_EMIT busyChanged();
}

void JobRunner::cancel()
{
    if (mOnCancel == OnCancel::LetGo)
        return abandon();
    if (!mControl)
        return;
    mTask.stop();
    QTimer::singleShot(cancelPatience, this, [this, cancelled = std::weak_ptr(mControl)] {
        // Its address alone would not do: a job that started meanwhile may have it.
        if (mControl && mControl == cancelled.lock())
            leaveJob();
    });
}

void JobRunner::abandon()
{
    mTask.drop();
    if (mControl)
        leaveJob();
}

void JobRunner::waitForDone()
{
    while (isBusy())
        mTask.wait();
}

} // namespace autocuts
