// Work off the GUI thread: one Task is one thing that its owner waits for.
#pragma once

#include <QString>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace autocuts {

//! What is said when memory does not suffice. Translated, one line.
QString noMemoryText();

//! Runs work on a thread of its own and passes its result on in the GUI thread. Only the newest work counts:
//! the result of what was started before is dropped, and so is that of a Task that is gone. An exception ends
//! the work only, with a message. To be used in the GUI thread.
class Task final
{
public:
    //! \param message translated, one line
    using Failed = std::function<void(const QString &message)>;

    //! \param isJob the user waits for it: Hold does not stop it
    explicit Task(bool isJob = false) : mIsJob(isJob) {}
    //! Drops the work without waiting for it. The end of the program waits for it.
    ~Task() { drop(); }
    Task(const Task &) = delete;
    Task &operator=(const Task &) = delete;

    //! \param work called on the thread with a flag that asks it to end soon; owns all that it uses
    //! \param take called with the result of `work`; may start other work here, or destroy this
    //! \param failed called when `work` threw an exception
    template <class Work, class Take>
    void start(Work work, Take take, Failed failed)
    {
        using Value = decltype(work(std::declval<const std::atomic<bool> &>()));
        auto value = std::make_shared<std::optional<Value>>();
        begin([value,
               work = std::move(work)](const std::atomic<bool> &stop) mutable { value->emplace(work(stop)); },
              [value, take = std::move(take)]() mutable { take(std::move(**value)); }, std::move(failed));
    }

    //! A result is still to come.
    bool isRunning() const { return mNewest != none; }
    //! Asks the work to end soon; its result still comes.
    void stop();
    //! Asks the work to end soon; its result does not come.
    void drop();
    //! Waits until the work has ended, and passes its result on.
    void wait();
    //! Waits until the work has ended that was dropped.
    void waitForDropped();

    // For tests.

    //! Works of all tasks that have not ended.
    static int threads();
    //! Waits until all work has ended, and passes its results on.
    static void waitForAll();
    //! As long as it lives, work that is no job waits before it begins.
    class Hold final
    {
    public:
        Hold();
        ~Hold();
        Hold(const Hold &) = delete;
        Hold &operator=(const Hold &) = delete;
    };

private:
    static constexpr int none = 0;
    struct Run;

    void begin(std::function<void(const std::atomic<bool> &)> work, std::function<void()> take,
               Failed failed);
    static void passOn(int run);

    const bool mIsJob;
    int mNewest = none;
};

//! The newest value that another thread has for an object of the GUI thread. However many come, they are
//! taken once per turn of the event loop.
template <class Value>
class Inbox final
{
public:
    Inbox() = default;
    ~Inbox() { close(); }
    Inbox(const Inbox &) = delete;
    Inbox &operator=(const Inbox &) = delete;

    bool isOpen() const { return mBox != nullptr; }
    //! Later values are dropped.
    void close();
    //! Begins anew.
    //! \param take called in the GUI thread
    //! \param add puts a new item in, beside what was not taken yet. Called on any thread, one at a time
    //! \returns puts an item in: callable on any thread, also after close(), which it outlives
    template <class Item>
    std::function<void(const Item &)> open(std::function<void(Value)> take,
                                           std::function<void(std::optional<Value> &, const Item &)> add);

private:
    struct Box
    {
        std::mutex mutex;
        std::optional<Value> value;
        std::function<void(Value)> take; //!< null: closed
    };

    std::shared_ptr<Box> mBox;
};

//! Calls a function in the GUI thread, in a later turn of its event loop.
void laterInGuiThread(std::function<void()> call);

template <class Value>
void Inbox<Value>::close()
{
    if (!mBox)
        return;
    {
        const std::scoped_lock lock(mBox->mutex);
        mBox->take = nullptr;
        mBox->value.reset();
    }
    mBox.reset();
}

template <class Value>
template <class Item>
std::function<void(const Item &)>
Inbox<Value>::open(std::function<void(Value)> take,
                   std::function<void(std::optional<Value> &, const Item &)> add)
{
    close();
    mBox = std::make_shared<Box>();
    mBox->take = std::move(take);
    return [box = mBox, add = std::move(add)](const Item &item) {
        const std::scoped_lock lock(box->mutex);
        if (!box->take)
            return;
        const bool waited = box->value.has_value();
        add(box->value, item);
        if (waited || !box->value)
            return;
        laterInGuiThread([box] {
            std::unique_lock taking(box->mutex);
            std::optional<Value> value = std::exchange(box->value, {});
            const auto receiver = box->take;
            taking.unlock();
            if (value && receiver)
                receiver(std::move(*value));
        });
    };
}

} // namespace autocuts
