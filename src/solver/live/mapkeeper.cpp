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
    mMailbox.order([&](auto &box) {
        box.atRest = false;
        change(box);
    });
    QMetaObject::invokeMethod(this, &MapKeeper::work, Qt::QueuedConnection);
}

void MapKeeper::start(std::shared_ptr<const Snapshot> snapshot, const unwrap::LiveMapOptions &options)
{
    order([&](auto &box) {
        box = {};
        box.orders.start = true;
        box.orders.snapshot = std::move(snapshot);
        box.orders.options = options;
        box.orders.run = false;
    });
}

void MapKeeper::update(std::shared_ptr<const Snapshot> snapshot, const unwrap::LiveMapOptions &options,
                       bool pulled, std::shared_ptr<const unwrap::LiveMapResult> back)
{
    order([&](auto &box) {
        mMailbox.putEdited(std::move(snapshot), box.orders);
        box.orders.options = options;
        box.orders.pulled = pulled;
        box.orders.token.reset();
        if (back) {
            box.result = nullptr;
            box.orders.back = std::move(back);
        }
    });
}

void MapKeeper::setToken(const StateToken &token)
{
    order([&](auto &box) {
        box.orders.token = token;
        if (box.result)
            box.result = withMapToken(*box.result, token);
    });
}

void MapKeeper::run()
{
    order([](auto &box) { box.orders.run = true; });
}

void MapKeeper::pause()
{
    order([](auto &box) { box.orders.run = false; });
}

//! Works until there is nothing to do; then the thread's event loop waits for the next order.
void MapKeeper::work()
{
    const std::atomic<bool> &interrupt = mMailbox.interrupt();
    try {
        do {
            obey(mMailbox.takeOrders());
            if (mRunning && mMap.work({&interrupt, mThreads}) &&
                mMailbox.rest([&](const Orders &) { return interrupt.load(); }))
                Q_EMIT rests();
        } while (interrupt);
    } catch (const std::exception &e) {
        mRunning = false;
        if (mMailbox.fail(e))
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
    const bool isFirst = mMailbox.give(std::move(map), [](const auto &box, auto &result) {
        if (box.orders.back)
            result = box.orders.back; // that of a drag which has been taken back
        if (box.orders.token)
            result = withMapToken(*result, *box.orders.token);
    });
    if (isFirst)
        Q_EMIT mapReady();
}

} // namespace autocuts::live
