// What passes between the thread of a worker and the other threads: orders go in, the newest result comes
// out.
#pragma once

#include "model/plain/snapshot.h"

#include <QString>

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <utility>

namespace autocuts::live {

//! Orders that were given to a worker and not yet carried out, and what it has to say. Every function may be
//! called from any thread.
//! \tparam Orders has the members `bool start`: everything begins anew, so what was made before is void, and
//! `std::shared_ptr<const Snapshot> snapshot`
template <class Orders, class Result>
class Mailbox
{
public:
    //! What the box holds: orders for the worker, and its newest result.
    struct Content
    {
        Orders orders;
        std::shared_ptr<const Result> result; //!< the newest that was not taken yet
        std::optional<QString> failure;
        bool atRest = false; //!< the worker stopped by itself
    };

    Mailbox() = default;
    //! Waits until the thread that gave the last order has left the box.
    ~Mailbox() { const std::lock_guard lock(mMutex); }
    Mailbox(const Mailbox &) = delete;
    Mailbox &operator=(const Mailbox &) = delete;

    //! Lets change(Content &) add orders, and interrupts the worker.
    template <class Change>
    void order(Change &&change)
    {
        const std::lock_guard lock(mMutex);
        change(mContent);
        mInterrupt = true;
    }

    //! Puts in the snapshot of an edit. A start that was not carried out yet still begins as it was told to.
    static void putEdited(std::shared_ptr<const Snapshot> snapshot, Orders &orders)
    {
        if (orders.start && orders.snapshot->settings.start != snapshot->settings.start) {
            auto begun = std::make_shared<Snapshot>(*snapshot);
            begun->settings.start = orders.snapshot->settings.start;
            snapshot = std::move(begun);
        }
        orders.snapshot = std::move(snapshot);
    }

    std::shared_ptr<const Result> takeResult() { return take(&Content::result); }
    std::optional<QString> takeFailure() { return take(&Content::failure); }
    bool takeRest() { return take(&Content::atRest); }

    // For the worker.

    //! New orders have arrived: long computations should end.
    const std::atomic<bool> &interrupt() const { return mInterrupt; }
    Orders takeOrders()
    {
        const std::lock_guard lock(mMutex);
        mInterrupt = false;
        return std::exchange(mContent.orders, {});
    }
    //! Puts the result in, once merge(const Content &, std::shared_ptr<const Result> &) has fitted it to what
    //! lies there.
    //! \return no other result was waiting; false too when the worker is about to start anew
    template <class Merge>
    bool give(std::shared_ptr<const Result> result, Merge &&merge)
    {
        const std::lock_guard lock(mMutex);
        if (mContent.orders.start)
            return false;
        merge(std::as_const(mContent), result);
        return !std::exchange(mContent.result, std::move(result));
    }
    //! \return false when the worker is about to start anew: then the failure is of no interest
    bool fail(const std::exception &why)
    {
        const std::lock_guard lock(mMutex);
        if (mContent.orders.start)
            return false;
        const bool memory = dynamic_cast<const std::bad_alloc *>(&why) != nullptr;
        mContent.failure =
            memory ? QStringLiteral("there is not enough memory") : QString::fromUtf8(why.what());
        return true;
    }
    //! \return false when awaited(Orders) says that orders keep the worker running
    template <class Awaited>
    bool rest(Awaited &&awaited)
    {
        const std::lock_guard lock(mMutex);
        mContent.atRest = !awaited(mContent.orders);
        return mContent.atRest;
    }
    void endRest()
    {
        const std::lock_guard lock(mMutex);
        mContent.atRest = false;
    }

private:
    template <class Value>
    Value take(Value Content::*member)
    {
        const std::lock_guard lock(mMutex);
        return std::exchange(mContent.*member, Value());
    }

    std::mutex mMutex;
    Content mContent;
    std::atomic<bool> mInterrupt = false;
};

} // namespace autocuts::live
