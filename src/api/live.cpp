// A live solve: a map that gets better on a thread of its own.
#include "api/failure.h"
#include "api/mapoutput.h"
#include "api/meshinput.h"
#include "model/plain/parallel.h"
#include "model/plain/uvlayout.h"
#include "solver/packing/packmap.h"
#include "solver/unwrap/livemap.h"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <optional>

namespace autocuts::api {

//! What the thread is to do next. Of several orders only the newest counts.
struct Order
{
    std::shared_ptr<const Snapshot> snapshot;
    unwrap::LiveMapOptions options;
};

static Order orderOf(const std::shared_ptr<const MeshData> &data, const autocuts_mesh &mesh,
                     const autocuts_options &options)
{
    Snapshot snapshot;
    snapshot.mesh = data;
    snapshot.settings = settingsOf(options);
    Order order;
    order.options.maxDistortion = options.max_distortion;
    order.options.packing = packing::tileOptions(packingOf(options));
    snapshot.tileHeight = order.options.packing.tileHeight();
    takeWishes(mesh, snapshot);
    if (snapshot.uv) {
        snapshot.settings.start = StartMode::ExistingUv;
        snapshot.startUv =
            std::make_shared<const UvMatrix>(soupUv(*snapshot.mesh, *snapshot.uv) / snapshot.uvScale);
    }
    order.snapshot = std::make_shared<const Snapshot>(std::move(snapshot));
    return order;
}

static void checkSameFaces(const autocuts_mesh &mesh, const MeshData &data)
{
    const bool counts = mesh.vertex_count == std::size_t(data.vertexCount()) &&
                        mesh.face_count == std::size_t(data.faceCount());
    bool same = counts && mesh.indices;
    for (std::size_t face = 0; same && face < mesh.face_count; ++face) {
        const int size = data.faceStart[face + 1] - data.faceStart[face];
        same = (mesh.face_sizes ? mesh.face_sizes[face] : 3U) == std::uint32_t(size);
    }
    for (int c = 0; same && c < data.cornerCount(); ++c)
        same = mesh.indices[c] == std::uint32_t(data.cornerVertex[std::size_t(c)]);
    if (!same)
        throw badInput("the mesh has other faces than the live solve", "Start a new one");
}

} // namespace autocuts::api

using namespace autocuts;
using namespace autocuts::api;

struct autocuts_live
{
public:
    autocuts_live(std::shared_ptr<const MeshData> mesh, Order order, int threads)
        : mMesh(std::move(mesh)), mThreads(threads),
          mMap([this](std::shared_ptr<const unwrap::LiveMapResult> map) { give(std::move(map)); })
    {
        mOrder = std::move(order);
        mThread.emplace([this](const std::stop_token &end) { work(end); });
    }
    ~autocuts_live()
    {
        {
            const std::lock_guard lock(mMutex);
            mThread->requestStop();
            mInterrupt = true;
        }
        mWake.notify_all();
    }
    autocuts_live(const autocuts_live &) = delete;
    autocuts_live &operator=(const autocuts_live &) = delete;

    const std::shared_ptr<const MeshData> &mesh() const { return mMesh; }

    void steer(Order order)
    {
        {
            const std::lock_guard lock(mMutex);
            mOrder = std::move(order);
            mNewest.reset(); // it does not obey
            mInterrupt = true;
            mRests = false;
        }
        mWake.notify_all();
    }

    std::unique_ptr<autocuts_map> wait(double seconds)
    {
        std::unique_lock lock(mMutex);
        mGiven.wait_for(lock, std::chrono::duration<double>(seconds),
                        [this] { return mNewest || mRests || mFailure; });
        if (mFailure)
            std::rethrow_exception(mFailure);
        if (!mNewest)
            return nullptr;
        const std::shared_ptr<const unwrap::LiveMapResult> newest = std::exchange(mNewest, nullptr);
        const std::shared_ptr<const Snapshot> snapshot = mSnapshot;
        const packing::PackOptions packing = mPacking;
        lock.unlock();
        std::unique_ptr<autocuts_map> map = mapOf(*snapshot, packing, newest->uv);
        map->outcome.within_bound = newest->withinBound;
        map->outcome.hard_share = newest->hardShare;
        setUnmet(newest->unmet, map->outcome);
        return map;
    }

    bool rests() const
    {
        const std::lock_guard lock(mMutex);
        return mRests && !mNewest;
    }

private:
    //! The newest order, once there is one; nothing at the end.
    std::optional<Order> nextOrder(const std::stop_token &end)
    {
        std::unique_lock lock(mMutex);
        mWake.wait(lock, [&] { return mOrder || end.stop_requested(); });
        if (end.stop_requested())
            return std::nullopt;
        mInterrupt = false;
        mSnapshot = mOrder->snapshot;
        mPacking = mOrder->options.packing;
        return std::exchange(mOrder, std::nullopt);
    }

    void work(const std::stop_token &end)
    {
        bool begun = false;
        try {
            while (const std::optional<Order> order = nextOrder(end)) {
                if (!begun)
                    mMap.begin(order->snapshot, order->options);
                else
                    mMap.steer(order->snapshot, order->options);
                begun = true;
                const bool done = mMap.work({&mInterrupt, mThreads});
                const std::lock_guard lock(mMutex);
                mRests = done && !mOrder;
                mGiven.notify_all();
            }
        } catch (...) {
            const std::lock_guard lock(mMutex);
            mFailure = std::current_exception();
            mGiven.notify_all();
        }
    }

    void give(std::shared_ptr<const unwrap::LiveMapResult> map)
    {
        const std::lock_guard lock(mMutex);
        if (mOrder)
            return; // the map does not obey it
        mNewest = std::move(map);
        mGiven.notify_all();
    }

    const std::shared_ptr<const MeshData> mMesh; //!< without texel weights
    const int mThreads;
    std::atomic<bool> mInterrupt = false;
    unwrap::LiveMap mMap; //!< of the thread

    mutable std::mutex mMutex; //!< for what follows
    std::condition_variable mWake, mGiven;
    std::optional<Order> mOrder;
    std::shared_ptr<const Snapshot> mSnapshot; //!< that the thread works on
    packing::PackOptions mPacking;
    std::shared_ptr<const unwrap::LiveMapResult> mNewest; //!< not given out yet
    bool mRests = false;
    std::exception_ptr mFailure;

    std::optional<BackgroundThread> mThread; //!< the last member: it ends first
};

autocuts_status autocuts_live_start(const autocuts_mesh *mesh, const autocuts_options *options,
                                    autocuts_live **live, autocuts_error *error)
{
    if (live)
        *live = nullptr;
    return guarded(error, [&] {
        if (!live || !mesh)
            throw badInput("there is no mesh, or no place for the live solve");
        const autocuts_options own = optionsOf(options);
        std::shared_ptr<const MeshData> data = meshOf(*mesh);
        if (!(data->area > 0))
            throw badInput("all faces are without area, there is nothing to map",
                           "Check the scale and the vertices of the mesh");
        Order order = orderOf(data, *mesh, own);
        *live = new autocuts_live(std::move(data), std::move(order), own.threads);
    });
}

autocuts_status autocuts_live_steer(autocuts_live *live, const autocuts_mesh *mesh,
                                    const autocuts_options *options, autocuts_error *error)
{
    return guarded(error, [&] {
        if (!live || !mesh)
            throw badInput("there is no live solve, or no mesh");
        checkSameFaces(*mesh, *live->mesh());
        live->steer(orderOf(live->mesh(), *mesh, optionsOf(options)));
    });
}

autocuts_status autocuts_live_wait(autocuts_live *live, double seconds, autocuts_map **map,
                                   autocuts_error *error)
{
    if (map)
        *map = nullptr;
    return guarded(error, [&] {
        if (!live || !map)
            throw badInput("there is no live solve, or no place for its map");
        if (!(seconds >= 0) || !std::isfinite(seconds))
            throw badInput("the time to wait is not a number that can be used");
        *map = live->wait(seconds).release();
    });
}

int autocuts_live_rests(const autocuts_live *live)
{
    return live->rests() ? 1 : 0;
}

void autocuts_live_free(autocuts_live *live)
{
    delete live;
}
