#include "solver/live/worker.h"

#include "model/plain/unionfind.h"
#include "solver/base/seamedmap.h"
#include "solver/homotopy/anneal.h"

#include <algorithm>
#include <exception>
#include <stdexcept>

namespace autocuts::live {

namespace {

// Numbers in this file without another source were chosen by hand.

using Clock = std::chrono::steady_clock;

constexpr auto resultInterval = std::chrono::milliseconds(1000 / SolveWorker::resultsPerSecond);
//! Least time, in seconds, over which steps per second are averaged, so that the figure can be read.
constexpr double rateWindow = 0.4;
//! In manual mode the worker waits for an edit after this many stalled steps in a row.
constexpr int stalledStepsToWait = 10;

double secondsBetween(Clock::time_point from, Clock::time_point to)
{
    return std::chrono::duration<double>(to - from).count();
}

void setRows(homotopy::Solver &solver, const UvMatrix &rows)
{
    solver.setCoordinates({rows.data(), rows.data() + rows.size()});
}

} // namespace

SolveWorker::SolveWorker(int threads) : mThreads(threads) {}

SolveWorker::~SolveWorker() = default;

template <class Change>
void SolveWorker::order(Change &&change)
{
    mMailbox.order(change);
    QMetaObject::invokeMethod(this, &SolveWorker::work, Qt::QueuedConnection);
}

void SolveWorker::start(std::shared_ptr<const Snapshot> snapshot, const Vec2 &centre, bool warm)
{
    order([&](auto &box) {
        box.result.reset();
        box.failure.reset();
        box.atRest = false;
        box.orders.start = true;
        box.orders.snapshot = std::move(snapshot);
        box.orders.token.reset();
        box.orders.pulled = false;
        box.orders.warm = warm;
        box.orders.back.reset();
        box.orders.centre = centre;
    });
}

void SolveWorker::update(std::shared_ptr<const Snapshot> snapshot, bool pulled,
                         std::shared_ptr<const SolveResult> back)
{
    order([&](auto &box) {
        mMailbox.putEdited(std::move(snapshot), box.orders);
        box.orders.token.reset();
        box.orders.pulled = pulled;
        if (back)
            box.orders.back = std::move(back);
    });
}

void SolveWorker::setMode(homotopy::SolveMode mode)
{
    order([&](auto &box) { box.orders.mode = mode; });
}

void SolveWorker::setToken(const StateToken &token)
{
    order([&](auto &box) { box.orders.token = token; });
}

void SolveWorker::runSteps(int count)
{
    order([&](auto &box) {
        box.orders.steps = count;
        box.atRest = false;
    });
}

void SolveWorker::pause()
{
    order([](auto &box) { box.orders.steps = 0; });
}

//! Works until there is nothing to do; then the thread's event loop waits for the next order.
void SolveWorker::work()
{
    try {
        do {
            obey(mMailbox.takeOrders());
            if (mSolver && mStepsLeft != 0)
                step();
        } while (mMailbox.interrupt() || (mSolver && mStepsLeft != 0));
    } catch (const std::exception &e) {
        mSolver.reset();
        mStepsLeft = 0;
        if (mMailbox.fail(e))
            Q_EMIT failed();
    }
}

void SolveWorker::obey(Orders orders)
{
    if (orders.mode) {
        mMode = *orders.mode;
        mSchedule.reset();
    }
    if (orders.start) {
        begin(orders);
    } else if (orders.snapshot && mSolver) {
        takeSnapshot(*orders.snapshot);
        mPulled = orders.pulled;
        if (mSchedule && !mPulled)
            mSchedule->reheat();
        updateSolver(true);
        if (mIdle && !orders.steps) {
            orders.steps = -1; // the edit gave it something to do again
            mMailbox.endRest();
        }
    } else if (orders.mode && mSolver) {
        updateSolver(false);
    }
    if (orders.token)
        mToken = *orders.token;
    if (orders.back && mSolver && orders.back->token.sameMap(mToken)) {
        setRows(*mSolver, mPart->unit() * mPart->partRows(orders.back->soupUv));
        mLast.energy = 0;
    }
    if (orders.steps) {
        const bool wasRunning = mStepsLeft != 0;
        mIdle = false;
        mStepsLeft = *orders.steps;
        if (mStepsLeft != 0) {
            mStatus.converged = false;
            mRateSince = Clock::now();
            mRateSteps = 0;
        } else if (wasRunning && mSolver) {
            giveResult();
        }
    }
}

//! Takes the newest snapshot. When it leaves other faces to the solve than before, a solver for these
//! continues from the map.
void SolveWorker::takeSnapshot(const Snapshot &snapshot)
{
    mSnapshot = std::make_shared<const Snapshot>(mPreference.applied(snapshot, mThreads));
    mToken = mSnapshot->token;
    std::optional<unwrap::FreePart> part = unwrap::FreePart::of(*mSnapshot, mPart ? &*mPart : nullptr);
    if (!part)
        throw std::runtime_error("nothing may change: all islands are locked, pinned, stacked or grouped");
    if (mSolver && !part->sameFaces(*mPart)) {
        const UvMatrix rows = mPart->wholeRows(rowsOf(mSolver->coordinates()));
        mSolver->load(part->snapshot());
        setRows(*mSolver, part->unit() * part->partRows(rows));
        mSchedule.reset();
    }
    mPart = std::move(part);
}

void SolveWorker::begin(const Orders &orders)
{
    mSolver.reset();
    takeSnapshot(*orders.snapshot);
    mSchedule.reset();
    mStatus = {};
    mLast = {};
    mTrace.clear();
    mPulled = false;
    mSolver = std::make_unique<homotopy::Solver>();
    mSolver->setThreads(mThreads);
    mSolver->load(mPart->snapshot());
    if (mSnapshot->settings.start != StartMode::ExistingUv) {
        std::vector<double> x = mSolver->coordinates();
        for (std::size_t i = 0; i < x.size(); i += 2) {
            x[i] += mPart->unit() * orders.centre.x();
            x[i + 1] += mPart->unit() * orders.centre.y();
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
    SolveSettings settings = mPart->snapshot().settings;
    if (mMode == homotopy::SolveMode::Budget) {
        if (!mSchedule || mSchedule->maxDistortion() != settings.maxDistortion)
            mSchedule.emplace(mSolver->soup(), settings.maxDistortion);
        mSchedule->apply(settings);
    }
    if (steeringChanged || settings != mSolver->snapshot().settings) {
        Snapshot snapshot = mPart->snapshot();
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
    const auto goesOn = [](const Orders &orders) { return orders.start || orders.steps; };
    if (mStepsLeft == 0 && mMailbox.rest(goesOn))
        Q_EMIT waiting();
}

//! Makes a result available, in place of an older one that was not taken.
void SolveWorker::giveResult()
{
    const Soup &soup = mSolver->soup();
    auto result = std::make_shared<SolveResult>();
    result->token = mToken;
    result->soupUv = mPart->wholeRows(rowsOf(mSolver->coordinates()));
    const int pairs = soup.mesh->cornerPairCount();
    std::vector<float> separation(pairs);
    for (int p = 0; p < pairs; ++p)
        separation[p] = static_cast<float>(mSolver->separation(p));
    result->separation = mPart->wholePairs(separation);

    mStatus.iteration = mLast.iteration;
    mStatus.energy = mLast.energy;
    mStatus.distortion = mLast.distortion;
    mStatus.separation = mLast.separation;
    mStatus.seamLength = windingSeamLength(*soup.mesh);
    UnionFind pieces(soup.triangleCount());
    mStatus.islands = soup.triangleCount();
    for (std::size_t e = 0; e < soup.mesh->edgePairs.size(); ++e) {
        const EdgePair &edge = soup.mesh->edgePairs[e];
        if (edge.diagonal || std::max(separation[2 * e], separation[2 * e + 1]) < 0.5f) {
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

    const bool isFirst = mMailbox.give(result, [&](const auto &box, auto &) {
        if (box.result)
            result->trace.insert(result->trace.begin(), box.result->trace.begin(), box.result->trace.end());
    });
    if (isFirst)
        Q_EMIT resultReady();
}

} // namespace autocuts::live
