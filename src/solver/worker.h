// The live solver on a thread of its own: newest snapshot in, newest result out.
#pragma once

#include "model/snapshot.h"
#include "solver/liveschedule.h"
#include "solver/solver.h"

#include <QObject>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace autocuts {

//! Where a solve is.
struct SolveStatus
{
    int iteration = 0;
    double stepsPerSecond = 0;
    double energy = 0, distortion = 0, separation = 0; //!< as StepResult
    double lambda = 0, delta = 0;                      //!< in effect; in budget mode not those of the snapshot
    double seamLength = 0; //!< of the edges that are nearer to cut than to joined, solver units: seam_norm
    int islands = 0;       //!< that joining the other edges gives
    bool converged = false; //!< nothing left to gain, or the budget is reached: the worker waits
};

//! One step in the history of a solve.
struct TracePoint
{
    int iteration = 0;
    float distortion = 0, separation = 0, delta = 0;
};

//! What the worker gives back.
struct SolveResult
{
    quint64 run = 0;                    //!< number that start() was given
    std::shared_ptr<const Snapshot> snapshot; //!< that was solved, with the lambda and delta in effect
    UvMatrix soupUv;                    //!< one row per soup corner, solver units
    std::vector<float> separation;      //!< s_delta per corner pair, in [0, 1)
    SolveStatus status;
    std::vector<TracePoint> trace;      //!< the steps since the result before
};

//! A map with definite seams, made from the solver's.
struct SettledMap
{
    quint64 run = 0;
    UvMatrix cornerUv; //!< solver units
};

//! Steps a Solver until told to stop. The functions may be called from any thread and return at once; what
//! they ask for happens between two steps, and of several snapshots only the newest counts. The worker never
//! sees the document.
class SolveWorker final : public QObject
{
    Q_OBJECT

public:
    static constexpr int resultsPerSecond = 30;

    SolveWorker();
    ~SolveWorker() override;

    //! Begins a solve and forgets the one before.
    //! \param run any number but 0, given back with the results
    //! \param centre where the map is laid when it does not start from existing UVs, solver units
    void start(quint64 run, std::shared_ptr<const Snapshot> snapshot, const Vec2 &centre);
    //! Other settings or steering for the same mesh; the map goes on from where it is.
    void update(std::shared_ptr<const Snapshot> snapshot);
    void setMode(SolveMode mode, double maxDistortion);
    void run();
    //! Steps at most this many times, then waits.
    void runSteps(int count);
    //! The step at hand is finished and given out as a result.
    void pause();
    //! Pauses, then makes a settled map of the state; run() and start() cancel it.
    void settle();

    //! The newest result and the steps of those that were never taken; null when none is waiting.
    std::shared_ptr<const SolveResult> takeResult();
    std::optional<SettledMap> takeSettled();

Q_SIGNALS:
    //! A result is waiting. Sent once until it is taken, at most resultsPerSecond times a second.
    void resultReady();
    //! A settled map is waiting.
    void settled();
    //! The solve stopped by itself: it converged or the steps asked for are done.
    void waiting();
    //! \param message untranslated, one line
    void failed(const QString &message);

private:
    struct Orders;

    void work();
    void wake();
    bool obeyOrders();
    void step();
    void giveResult();
    void makeSettledMap();

    // Shared between threads.
    std::mutex mMutex;
    std::unique_ptr<Orders> mOrders;
    std::shared_ptr<SolveResult> mWaitingResult;
    std::optional<SettledMap> mSettledMap;
    std::atomic<bool> mInterrupt = false; //!< there are orders: whatever takes long should end

    // Of the worker's thread.
    std::unique_ptr<Solver> mSolver;
    std::shared_ptr<const Snapshot> mSnapshot;
    std::unique_ptr<LiveSchedule> mSchedule;
    SolveStatus mStatus;
    std::vector<TracePoint> mTrace;
    quint64 mRun = 0;
    int mStepsLeft = 0; //!< negative: until told to stop
};

} // namespace autocuts
