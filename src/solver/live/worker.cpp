#include "solver/live/worker.h"

#include "model/plain/unionfind.h"
#include "solver/definite/definitemap.h"
#include "solver/definite/seamopening.h"
#include "solver/definite/stitching.h"
#include "solver/homotopy/anneal.h"

#include <exception>

namespace autocuts::live {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto resultInterval = std::chrono::milliseconds(1000 / SolveWorker::resultsPerSecond);
//! Least time, in seconds, over which steps per second are averaged, so that the figure can be read. Chosen
//! by hand.
constexpr double rateWindow = 0.4;
//! In manual mode the worker waits for an edit after this many stalled steps in a row. Chosen by hand; no
//! measurement of its effect is recorded.
constexpr int stalledStepsToWait = 10;

double secondsBetween(Clock::time_point from, Clock::time_point to)
{
    return std::chrono::duration<double>(to - from).count();
}

} // namespace

SolveWorker::SolveWorker(int threads) : mThreads(threads) {}

SolveWorker::~SolveWorker() = default;

template <class Change>
void SolveWorker::order(Change &&change)
{
    {
        const std::lock_guard lock(mMutex);
        change(mOrders);
        mInterrupt = true;
    }
    QMetaObject::invokeMethod(this, &SolveWorker::work, Qt::QueuedConnection);
}

void SolveWorker::start(std::shared_ptr<const Snapshot> snapshot, const Vec2 &centre, bool warm)
{
    order([&](Orders &orders) {
        orders.start = true;
        orders.snapshot = std::move(snapshot);
        orders.token.reset();
        orders.pulled = false;
        orders.warm = warm;
        orders.back.reset();
        orders.centre = centre;
        orders.makeMap = false;
        mWaitingResult.reset();
        mPausedMap.reset();
        mAtRest = false;
    });
}

void SolveWorker::update(std::shared_ptr<const Snapshot> snapshot, bool pulled,
                         std::shared_ptr<const SolveResult> back)
{
    order([&](Orders &orders) {
        orders.snapshot = std::move(snapshot);
        orders.token.reset();
        orders.pulled = pulled;
        if (back)
            orders.back = std::move(back);
    });
}

void SolveWorker::setMode(homotopy::SolveMode mode, double maxDistortion)
{
    order([&](Orders &orders) {
        orders.mode = mode;
        orders.maxDistortion = maxDistortion;
    });
}

void SolveWorker::setToken(const StateToken &token)
{
    order([&](Orders &orders) { orders.token = token; });
}

void SolveWorker::runSteps(int count)
{
    order([&](Orders &orders) {
        orders.steps = count;
        orders.makeMap = false;
        mPausedMap.reset();
        mAtRest = false;
    });
}

void SolveWorker::pause()
{
    order([](Orders &orders) {
        orders.steps = 0;
        orders.makeMap = false;
    });
}

void SolveWorker::pauseWithMap()
{
    order([this](Orders &orders) {
        orders.steps = 0;
        orders.makeMap = true;
        mPausedMap.reset();
    });
}

std::shared_ptr<const SolveResult> SolveWorker::takeResult()
{
    const std::lock_guard lock(mMutex);
    return std::exchange(mWaitingResult, nullptr);
}

std::optional<PausedMap> SolveWorker::takePausedMap()
{
    const std::lock_guard lock(mMutex);
    return std::exchange(mPausedMap, std::nullopt);
}

bool SolveWorker::takeRest()
{
    const std::lock_guard lock(mMutex);
    return std::exchange(mAtRest, false);
}

//! Works until there is nothing to do; then the thread's event loop waits for the next order.
void SolveWorker::work()
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
            if (mSolver && mStepsLeft != 0)
                step();
            else if (mSolver && mMustMakeMap)
                makePausedMap();
        } while (mInterrupt || (mSolver && mStepsLeft != 0));
    } catch (const std::exception &e) {
        mSolver.reset();
        mStepsLeft = 0;
        Q_EMIT failed(QString::fromUtf8(e.what()));
    }
}

void SolveWorker::obey(Orders orders)
{
    if (orders.mode) {
        mMode = *orders.mode;
        mMaxDistortion = orders.maxDistortion;
        mSchedule.reset();
    }
    if (orders.start) {
        begin(orders);
    } else if (orders.snapshot && mSolver) {
        mSnapshot = std::make_shared<const Snapshot>(mPreference.applied(*orders.snapshot, mThreads));
        mToken = mSnapshot->token;
        mPulled = orders.pulled;
        if (mSchedule && !mPulled)
            mSchedule->reheat();
        updateSolver(true);
        if (mIdle && !orders.steps) {
            orders.steps = -1; // the edit gave it something to do again
            const std::lock_guard lock(mMutex);
            mAtRest = false;
        }
    } else if (orders.mode && mSolver) {
        updateSolver(false);
    }
    if (orders.token)
        mToken = *orders.token;
    if (orders.back && mSolver && orders.back->token.sameMap(mToken)) {
        const double *first = orders.back->soupUv.data();
        mSolver->setCoordinates({first, first + orders.back->soupUv.size()});
        mLast.energy = 0;
    }
    if (orders.makeMap)
        mMustMakeMap = true;
    if (orders.steps) {
        const bool wasRunning = mStepsLeft != 0;
        mIdle = false;
        mStepsLeft = *orders.steps;
        mMustMakeMap = orders.makeMap;
        if (mStepsLeft != 0) {
            mStatus.converged = false;
            mRateSince = Clock::now();
            mRateSteps = 0;
        } else if (wasRunning && mSolver) {
            giveResult();
        }
    }
}

void SolveWorker::begin(const Orders &orders)
{
    mSnapshot = std::make_shared<const Snapshot>(mPreference.applied(*orders.snapshot, mThreads));
    mToken = mSnapshot->token;
    mSchedule.reset();
    mStatus = {};
    mLast = {};
    mTrace.clear();
    mMustMakeMap = mPulled = false;
    mSolver = std::make_unique<homotopy::Solver>();
    mSolver->setThreads(mThreads);
    mSolver->load(*mSnapshot);
    if (mSnapshot->settings.start != StartMode::ExistingUv) {
        std::vector<double> x = mSolver->coordinates();
        for (std::size_t i = 0; i < x.size(); i += 2) {
            x[i] += orders.centre.x();
            x[i + 1] += orders.centre.y();
        }
        mSolver->setCoordinates(std::move(x));
    }
    updateSolver(false);
    if (orders.warm && mSchedule) {
        mSchedule->reheat();
        updateSolver(false);
    }
    giveResult();
}

//! Passes the snapshot to the solver; in budget mode with the schedule's lambda and delta.
void SolveWorker::updateSolver(bool steeringChanged)
{
    SolveSettings settings = mSnapshot->settings;
    if (mMode == homotopy::SolveMode::Budget) {
        if (!mSchedule)
            mSchedule.emplace(mSolver->soup(), mMaxDistortion);
        mSchedule->apply(settings);
    }
    if (steeringChanged || settings != mSolver->snapshot().settings) {
        Snapshot snapshot = *mSnapshot;
        snapshot.settings = settings;
        mSolver->update(snapshot);
    }
    mStatus.lambda = settings.lambda;
    mStatus.delta = settings.delta;
    mStalledSteps = 0;
}

void SolveWorker::step()
{
    const double energyBefore = mLast.energy;
    mLast = mSolver->step();
    ++mRateSteps;
    mTrace.push_back({mLast.iteration, static_cast<float>(mLast.distortion),
                      static_cast<float>(mLast.separation), static_cast<float>(mStatus.delta)});
    if (mStepsLeft > 0)
        --mStepsLeft;
    if (mMode == homotopy::SolveMode::Budget && !mPulled) {
        mStatus.converged = !mSchedule->report(mLast);
        if (!mStatus.converged)
            updateSolver(false);
    } else {
        mStalledSteps = homotopy::hasStalled(energyBefore, mLast) ? mStalledSteps + 1 : 0;
        mStatus.converged = mStalledSteps >= stalledStepsToWait;
    }
    if (mStatus.converged) {
        mIdle = mStepsLeft < 0;
        mStepsLeft = 0;
    }
    if (mStepsLeft == 0 || Clock::now() - mLastGiven >= resultInterval)
        giveResult();
    if (mStepsLeft == 0)
        comeToRest();
}

void SolveWorker::comeToRest()
{
    {
        const std::lock_guard lock(mMutex);
        if (mOrders.start || mOrders.steps)
            return; // new orders keep it running
        mAtRest = true;
    }
    Q_EMIT waiting();
}

//! Makes a result available, in place of an older one that was not taken.
void SolveWorker::giveResult()
{
    const Soup &soup = mSolver->soup();
    auto result = std::make_shared<SolveResult>();
    result->token = mToken;
    result->soupUv = rowsOf(mSolver->coordinates());
    const int pairs = soup.mesh->cornerPairCount();
    result->separation.resize(pairs);
    for (int p = 0; p < pairs; ++p)
        result->separation[p] = static_cast<float>(mSolver->separation(p));

    mStatus.iteration = mLast.iteration;
    mStatus.energy = mLast.energy;
    mStatus.distortion = mLast.distortion;
    mStatus.separation = mLast.separation;
    mStatus.seamLength = 0;
    UnionFind pieces(soup.triangleCount());
    mStatus.islands = soup.triangleCount();
    for (std::size_t e = 0; e < soup.mesh->edgePairs.size(); ++e) {
        const EdgePair &edge = soup.mesh->edgePairs[e];
        if (edge.diagonal || std::max(result->separation[2 * e], result->separation[2 * e + 1]) < 0.5f) {
            if (pieces.unite(edge.triangle[0], edge.triangle[1]))
                --mStatus.islands;
        } else {
            mStatus.seamLength += soup.pairLength[2 * e];
        }
    }
    const Clock::time_point now = Clock::now();
    if (const double elapsed = secondsBetween(mRateSince, now); elapsed >= rateWindow && mRateSteps > 0) {
        mStatus.stepsPerSecond = mRateSteps / elapsed;
        mRateSince = now;
        mRateSteps = 0;
    }
    mLastGiven = now;
    result->status = mStatus;
    result->trace = std::exchange(mTrace, {});

    bool isFirst = false;
    {
        const std::lock_guard lock(mMutex);
        if (mOrders.start)
            return; // another solve is about to start
        isFirst = !mWaitingResult;
        if (mWaitingResult) {
            std::vector<TracePoint> &older = mWaitingResult->trace;
            older.insert(older.end(), result->trace.begin(), result->trace.end());
            result->trace.swap(older);
        }
        mWaitingResult = std::move(result);
    }
    if (isFirst)
        Q_EMIT resultReady();
}

//! Makes a paused map by stitching the soup; what the user cut stays open. New orders interrupt it; unless
//! they cancel the map, it is then made again.
void SolveWorker::makePausedMap()
{
    const SeamedMap map =
        definite::stitchSoup(mSolver->sharedSoup(), mSolver->snapshot(), mSolver->coordinates(), &mInterrupt);
    if (mInterrupt)
        return;
    PausedMap pausedMap{mToken, cornerUv(mSolver->soup(), map)};
    definite::openCuts(mSolver->snapshot(), pausedMap.cornerUv);
    {
        const std::lock_guard lock(mMutex);
        if (mInterrupt)
            return;
        mPausedMap = std::move(pausedMap);
    }
    mMustMakeMap = false;
    Q_EMIT pausedMapReady();
}

} // namespace autocuts::live
