#include "solver/live/mapkeeper.h"

#include <exception>

namespace autocuts::live {

namespace {

//! The same map for a document whose map has another token.
std::shared_ptr<const unwrap::LiveMapResult> withMapToken(const unwrap::LiveMapResult &map,
                                                          const StateToken &token)
{
    auto copy = std::make_shared<unwrap::LiveMapResult>(map);
    copy->token.topology = token.topology;
    copy->token.uv = token.uv;
    return copy;
}

} // namespace

MapKeeper::MapKeeper(int threads)
    : mThreads(threads),
      mMap([this](std::shared_ptr<const unwrap::LiveMapResult> map) { give(std::move(map)); })
{}

MapKeeper::~MapKeeper() = default;

template <class Change>
void MapKeeper::order(Change &&change)
{
    {
        const std::lock_guard lock(mMutex);
        change(mOrders);
        mInterrupt = true;
        mAtRest = false;
    }
    QMetaObject::invokeMethod(this, &MapKeeper::work, Qt::QueuedConnection);
}

void MapKeeper::start(std::shared_ptr<const Snapshot> snapshot, const unwrap::LiveMapOptions &options)
{
    order([&](Orders &orders) {
        orders = {};
        orders.start = true;
        orders.snapshot = std::move(snapshot);
        orders.options = options;
        orders.run = false;
        mWaitingMap.reset();
        mFailure.reset();
    });
}

void MapKeeper::update(std::shared_ptr<const Snapshot> snapshot, const unwrap::LiveMapOptions &options,
                       bool pulled, std::shared_ptr<const unwrap::LiveMapResult> back)
{
    order([&](Orders &orders) {
        orders.snapshot = std::move(snapshot);
        orders.options = options;
        orders.pulled = pulled;
        orders.token.reset();
        if (back)
            orders.back = std::move(back);
    });
}

void MapKeeper::setToken(const StateToken &token)
{
    order([&](Orders &orders) {
        orders.token = token;
        if (mWaitingMap)
            mWaitingMap = withMapToken(*mWaitingMap, token);
    });
}

void MapKeeper::run()
{
    order([](Orders &orders) { orders.run = true; });
}

void MapKeeper::pause()
{
    order([](Orders &orders) { orders.run = false; });
}

std::shared_ptr<const unwrap::LiveMapResult> MapKeeper::takeMap()
{
    const std::lock_guard lock(mMutex);
    return std::exchange(mWaitingMap, nullptr);
}

std::optional<QString> MapKeeper::takeFailure()
{
    const std::lock_guard lock(mMutex);
    return std::exchange(mFailure, std::nullopt);
}

bool MapKeeper::takeRest()
{
    const std::lock_guard lock(mMutex);
    return std::exchange(mAtRest, false);
}

//! Works until there is nothing to do; then the thread's event loop waits for the next order.
void MapKeeper::work()
{
    try {
        do {
            Orders orders;
            {
                const std::lock_guard lock(mMutex);
                orders = std::exchange(mOrders, {});
                mInterrupt = false;
            }
            obey(std::move(orders));
            if (mRunning && mMap.work({&mInterrupt, mThreads}))
                comeToRest();
        } while (mInterrupt);
    } catch (const std::exception &e) {
        mRunning = false;
        {
            const std::lock_guard lock(mMutex);
            if (mOrders.start)
                return; // it is about to start again
            mFailure = QString::fromUtf8(e.what());
        }
        Q_EMIT failed();
    }
}

void MapKeeper::obey(Orders orders)
{
    if (orders.start)
        mMap.begin(std::move(orders.snapshot), orders.options);
    else if (orders.snapshot)
        mMap.steer(std::move(orders.snapshot), orders.options, orders.pulled, std::move(orders.back));
    if (orders.token)
        mMap.setToken(*orders.token);
    if (orders.run)
        mRunning = *orders.run;
}

void MapKeeper::give(std::shared_ptr<const unwrap::LiveMapResult> map)
{
    bool isFirst = false;
    {
        const std::lock_guard lock(mMutex);
        if (mOrders.start)
            return; // it belongs to a map that is over
        if (mOrders.token)
            map = withMapToken(*map, *mOrders.token);
        isFirst = !mWaitingMap;
        mWaitingMap = std::move(map);
    }
    if (isFirst)
        Q_EMIT mapReady();
}

void MapKeeper::comeToRest()
{
    {
        const std::lock_guard lock(mMutex);
        if (mInterrupt)
            return; // new orders keep it running
        mAtRest = true;
    }
    Q_EMIT rests();
}

} // namespace autocuts::live
