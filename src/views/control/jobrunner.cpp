#include "views/control/jobrunner.h"

#include <QCoreApplication>
#include <QThread>
#include <QTimer>

#include <algorithm>
#include <exception>
#include <new>

namespace autocuts {

namespace {

constexpr int progressInterval = 50; //!< milliseconds

} // namespace

//! The thread of one job.
class JobRunner::Thread final : public QThread
{
public:
    Thread(std::shared_ptr<JobControl> control, std::function<void(JobControl &)> work)
        : mControl(std::move(control)), mWork(std::move(work))
    {}
    ~Thread() override
    {
        mControl->mStop = true;
        wait();
    }

    const QString &error() const { return mError; }

protected:
    void run() override
    {
        try {
            mWork(*mControl);
        } catch (const std::bad_alloc &) {
            mError =
                JobRunner::tr("There is not enough memory. Close other programs or use a smaller model.");
        } catch (const std::exception &e) {
            mError = QString::fromUtf8(e.what());
        }
    }

private:
    std::shared_ptr<JobControl> mControl;
    std::function<void(JobControl &)> mWork;
    QString mError;
};

void JobControl::setStage(const QString &text)
{
    if (mShowStage)
        mShowStage(text);
}

JobRunner::JobRunner(OnCancel onCancel, QObject *parent) : QObject(parent), mOnCancel(onCancel) {}

JobRunner::~JobRunner() = default;

double JobRunner::progress() const
{
    return mControl ? mControl->mFraction.load() : -1;
}

bool JobRunner::startJob(const QString &title, std::function<void(JobControl &)> work,
                         std::function<void()> done)
{
    if (mControl)
        return false;
    for (LetGo &job : mLetGo)
        job.done = nullptr;
    mControl = std::make_shared<JobControl>();
    mControl->mShowStage = [this, job = mControl.get()](const QString &text) {
        QMetaObject::invokeMethod(
            this,
            [this, job, text] {
                if (mControl.get() != job)
                    return;
                mStage = text;
                Q_EMIT busyChanged();
            },
            Qt::QueuedConnection);
    };
    mTitle = title;
    mStage.clear();
    mDone = std::move(done);
    mThread = std::make_unique<Thread>(mControl, std::move(work));
    auto *ticker = new QTimer(mThread.get());
    connect(ticker, &QTimer::timeout, this, &JobRunner::progressChanged);
    ticker->start(progressInterval);
    connect(mThread.get(), &QThread::finished, this, [this, thread = mThread.get()] { jobEnded(thread); });
    mThread->start();
    Q_EMIT busyChanged();
    return true;
}

void JobRunner::jobEnded(Thread *thread)
{
    if (thread != mThread.get()) {
        const auto job = std::find_if(mLetGo.begin(), mLetGo.end(),
                                      [thread](const LetGo &other) { return other.thread.get() == thread; });
        const LetGo ended = std::move(*job);
        mLetGo.erase(job);
        if (ended.done && ended.thread->error().isEmpty())
            ended.done();
        Q_EMIT letGoEnded();
        return;
    }
    const std::unique_ptr<Thread> ended = std::move(mThread);
    const std::function<void()> done = std::exchange(mDone, nullptr);
    mControl.reset();
    mStage.clear();
    Q_EMIT busyChanged();
    if (ended->error().isEmpty())
        done();
    else
        Q_EMIT failed(ended->error());
}

void JobRunner::cancel()
{
    if (mOnCancel == OnCancel::LetGo)
        abandon();
    if (!mControl || mControl->mStop)
        return;
    mControl->mStop = true;
    QTimer::singleShot(cancelPatience, this, [this, control = mControl.get()] { releaseCancelled(control); });
}

void JobRunner::releaseCancelled(const JobControl *control)
{
    if (mControl.get() == control)
        letGo(std::exchange(mDone, nullptr));
}

void JobRunner::abandon()
{
    for (LetGo &job : mLetGo)
        job.done = nullptr;
    if (!mControl)
        return;
    mControl->mStop = true;
    letGo(nullptr);
}

//! Abandons the running job. \param done called when it ends, or null
void JobRunner::letGo(std::function<void()> done)
{
    mControl.reset();
    mDone = nullptr;
    mStage.clear();
    mLetGo.push_back({std::move(mThread), std::move(done)});
    Q_EMIT busyChanged();
}

void JobRunner::waitForDone()
{
    while (mControl) {
        mThread->wait();
        QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
    }
}

} // namespace autocuts
