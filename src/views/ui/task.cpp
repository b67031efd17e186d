#include "views/ui/task.h"

#include "model/plain/parallel.h"

#include <QCoreApplication>
#include <QMetaObject>

#include <exception>
#include <map>
#include <new>
#include <system_error>

namespace autocuts {

//! One work of a task. Used in the GUI thread, but for what `work` does.
struct Task::Run
{
    Run(int number, Task *task, std::function<void(const std::atomic<bool> &)> work,
        std::function<void()> passOnResult, Failed tellFailure)
        : origin(task), owner(task), take(std::move(passOnResult)), failed(std::move(tellFailure)),
          thread([this, number, isHeld = !task->mIsJob && held,
                  todo = std::move(work)](const std::stop_token &) {
              if (isHeld)
                  held.wait(true);
              try {
                  todo(stop);
              } catch (const std::bad_alloc &) {
                  error = noMemoryText();
              } catch (const std::exception &e) {
                  error = QString::fromUtf8(e.what());
              }
              laterInGuiThread([number] { Task::passOn(number); });
          })
    {}
    ~Run() { stop = true; }

    std::atomic<bool> stop = false;
    const Task *const origin; //!< may be gone
    Task *owner;              //!< null: the result is dropped
    std::function<void()> take;
    Failed failed;
    std::optional<QString> error; //!< the thread's until it has ended
    BackgroundThread thread;      //!< the last member: it uses the others

    static inline std::atomic<bool> held = false; //!< see Hold
    //! By their numbers, all that have not been passed on. The end of the program waits for them.
    static std::map<int, std::unique_ptr<Run>> &all()
    {
        static std::map<int, std::unique_ptr<Run>> runs;
        // Before the application is gone, to which results are passed.
        [[maybe_unused]] static const bool awaited = (qAddPostRoutine([] { runs.clear(); }), true);
        return runs;
    }
};

void Task::begin(std::function<void(const std::atomic<bool> &)> work, std::function<void()> take,
                 Failed failed)
{
    static int last = none;
    drop();
    try {
        auto run = std::make_unique<Run>(++last, this, std::move(work), std::move(take), failed);
        Run::all()[last] = std::move(run);
        mNewest = last;
    } catch (const std::system_error &) { // no thread is to be had
        failed(noMemoryText());
    }
}

//! Ends a run whose work is done, or waits until it is.
void Task::passOn(int number)
{
    auto ended = Run::all().extract(number);
    if (ended.empty())
        return; // somebody waited for it
    const std::unique_ptr<Run> run = std::move(ended.mapped());
    run->thread.join();
    if (!run->owner)
        return;
    run->owner->mNewest = none;
    if (run->error)
        run->failed(*run->error);
    else
        run->take();
}

void Task::stop()
{
    if (isRunning())
        Run::all()[mNewest]->stop = true;
}

void Task::drop()
{
    if (!isRunning())
        return;
    stop();
    Run::all()[std::exchange(mNewest, none)]->owner = nullptr;
}

void Task::wait()
{
    if (isRunning())
        passOn(mNewest);
}

void Task::waitForDropped()
{
    for (auto run = Run::all().begin(); run != Run::all().end();) {
        const int number = run->first;
        const bool own = run->second->origin == this && !run->second->owner;
        ++run;
        if (own)
            passOn(number);
    }
}

int Task::threads()
{
    return static_cast<int>(Run::all().size());
}

void Task::waitForAll()
{
    while (!Run::all().empty())
        passOn(Run::all().begin()->first);
}

Task::Hold::Hold()
{
    Run::held = true;
}

Task::Hold::~Hold()
{
    Run::held = false;
    Run::held.notify_all();
}

void laterInGuiThread(std::function<void()> call)
{
    QMetaObject::invokeMethod(QCoreApplication::instance(), std::move(call), Qt::QueuedConnection);
}

QString noMemoryText()
{
    return QCoreApplication::translate(
        "autocuts::Task", "There is not enough memory. Close other programs or use a smaller model.");
}

} // namespace autocuts
