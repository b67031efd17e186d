#include "views/control/jobrunner.h"

#include "views/ui/pooltask.h"

#include <QCoreApplication>
#include <QTimer>

#include <algorithm>
#include <exception>
#include <new>
#include <thread>

namespace autocuts {

namespace {

constexpr int progressInterval = 50; //!< milliseconds

} // namespace

//! The thread of one job. A thread of the standard library: the thread sanitizer does not see how Qt's
//! threads wait for each other.
class JobRunner::Thread final
{
public:
    //! \param ended called on the thread at its end
    Thread(std::shared_ptr<JobControl> control, std::function<void(JobControl &)> work,
           std::function<void(Thread *)> ended)
        : mControl(std::move(control)), mThread([this, work = std::move(work), ended = std::move(ended)] {
              run(work);
              ended(this);
          })
    {}
    ~Thread() { mControl->mStop = true; }
    Thread(const Thread &) = delete;
    Thread &operator=(const Thread &) = delete;

    void wait()
    {
        if (mThread.joinable())
            mThread.join();
    }
    //! Empty when the job ended without an exception. \pre wait() was called
    const QString &error() const { return mError; }

    QTimer ticker;

private:
    void run(const std::function<void(JobControl &)> &work)
    {
        try {
            work(*mControl);
        } catch (const std::bad_alloc &) {
            mError = noMemoryText();
        } catch (const std::exception &e) {
            mError = QString::fromUtf8(e.what());
        }
    }

    std::shared_ptr<JobControl> mControl;
    QString mError;
    std::jthread mThread; //!< the last member, so that it has ended before the others are destroyed
};

void JobControl::setStage(const QString &text)
{
    {
        const std::lock_guard lock(mMutex);
        mStage = text;
    }
    if (mStageSet)
        mStageSet();
}

JobRunner::JobRunner(OnCancel onCancel, QObject *parent) : QObject(parent), mOnCancel(onCancel)
{
    connect(this, &JobRunner::stageSet, this, &JobRunner::showStage, Qt::QueuedConnection);
    connect(this, &JobRunner::threadEnded, this, &JobRunner::takeEnded, Qt::QueuedConnection);
}

JobRunner::~JobRunner()
{
    // The threads use the other members until they end.
    mThread.reset();
    mLetGo.clear();
}

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
    mControl->mStageSet = [this] { Q_EMIT stageSet({}); };
    mTitle = title;
    mStage.clear();
    mDone = std::move(done);
    mThread = std::make_unique<Thread>(mControl, std::move(work), [this](Thread *thread) {
        {
            const std::lock_guard lock(mMutex);
            mEnded.push_back(thread);
        }
        Q_EMIT threadEnded({});
    });
    connect(&mThread->ticker, &QTimer::timeout, this, &JobRunner::progressChanged);
    mThread->ticker.start(progressInterval);
    Q_EMIT busyChanged();
    return true;
}

void JobRunner::showStage()
{
    if (!mControl)
        return;
    {
        const std::lock_guard lock(mControl->mMutex);
        mStage = mControl->mStage;
    }
    Q_EMIT busyChanged();
}

void JobRunner::takeEnded()
{
    std::vector<Thread *> ended;
    {
        const std::lock_guard lock(mMutex);
        ended.swap(mEnded);
    }
    for (Thread *thread : ended)
        jobEnded(thread);
}

void JobRunner::jobEnded(Thread *thread)
{
    thread->wait();
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
    QTimer::singleShot(cancelPatience, this, [this, cancelled = std::weak_ptr(mControl)] {
        // Its address alone would not do: a job that started meanwhile may have it.
        if (mControl && mControl == cancelled.lock())
            letGo(std::exchange(mDone, nullptr));
    });
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
