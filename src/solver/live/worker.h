// The live solver on a thread of its own: newest snapshot in, newest result out.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/homotopy/liveschedule.h"
#include "solver/homotopy/solver.h"
#include "solver/preference/seampreference.h"

#include <QObject>
#include <QThread>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace autocuts::live {

//! Where a solve is.
struct SolveStatus
{
    int iteration = 0;
    double stepsPerSecond = 0;
    double energy = 0, distortion = 0, separation = 0; //!< as StepResult
    double lambda = 0, delta = 0; //!< in effect; in budget mode not those of the snapshot
    double seamLength = 0;  //!< of the edges that are nearer to cut than to joined, solver units: seam_norm
    int islands = 0;        //!< that joining the other edges gives
    bool converged = false; //!< nothing left to gain, or the budget is reached: the worker waits for an edit
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
    StateToken token;              //!< of the document's state that the solve goes on from
    UvMatrix soupUv;               //!< one row per soup corner, solver units
    std::vector<float> separation; //!< s_delta per corner pair, in [0, 1)
    SolveStatus status;
    std::vector<TracePoint> trace; //!< the steps since the result before
};

//! A map with definite seams, made from the solver's.
struct PausedMap
{
    StateToken token;  //!< as SolveResult
    UvMatrix cornerUv; //!< solver units
};

//! Steps a Solver until told to stop. The functions may be called from any thread and return at once; what
//! they ask for happens between two steps, and of several snapshots only the newest counts. What the worker
//! made before an order that makes it void cannot be taken any more once the order is given. The worker never
//! sees the document.
class SolveWorker final : public QObject
{
    Q_OBJECT

public:
    static constexpr int resultsPerSecond = 30;

    //! \param threads of one step; no result depends on it
    explicit SolveWorker(int threads = QThread::idealThreadCount());
    ~SolveWorker() override;

    //! Begins a solve and forgets the one before, its results too.
    //! \param centre where the map is laid when it does not start from existing UVs, solver units
    //! \param warm the map has been solved before: in budget mode it is warmed up only
    void start(std::shared_ptr<const Snapshot> snapshot, const Vec2 &centre, bool warm = false);
    //! Other settings or steering for the same mesh; the map goes on from where it is.
    //! \param pulled the user pulls at the map: in budget mode lambda and delta stay as they are until a
    //! snapshot that is not pulled
    //! \param back a result since start() that the map is taken back to first
    void update(std::shared_ptr<const Snapshot> snapshot, bool pulled = false,
                std::shared_ptr<const SolveResult> back = nullptr);
    void setMode(homotopy::SolveMode mode, double maxDistortion);
    //! The settled map went into the document, which has this token since.
    void setToken(const StateToken &token);
    //! Steps until told to stop.
    void run() { runSteps(-1); }
    //! Steps at most this many times, then waits.
    void runSteps(int count);
    //! The step at hand is finished and given out as a result.
    void pause();
    //! Pauses, then makes a settled map of the state; run() and start() cancel it.
    void pauseWithMap();

    //! The newest result and the steps of those that were never taken; null when none is waiting.
    std::shared_ptr<const SolveResult> takeResult();
    std::optional<PausedMap> takePausedMap();
    //! True, once, when the solve stopped by itself and has not been told to go on since.
    bool takeRest();

Q_SIGNALS:
    //! A result is waiting. Sent once until it is taken, at most resultsPerSecond times a second.
    void resultReady();
    //! A settled map is waiting.
    void pausedMapReady();
    //! The solve stopped by itself: it converged or the steps asked for are done. takeRest() says whether
    //! that still holds.
    void waiting();
    //! \param message untranslated, one line
    void failed(const QString &message);

private:
    //! What was asked for and not yet begun.
    struct Orders
    {
        bool start = false; //!< begin with the snapshot
        std::shared_ptr<const Snapshot> snapshot;
        std::optional<StateToken> token; //!< in place of the snapshot's
        bool pulled = false, warm = false;
        std::shared_ptr<const SolveResult> back; //!< the map to go on from
        Vec2 centre = Vec2::Zero();
        std::optional<int> steps; //!< 0: pause
        std::optional<homotopy::SolveMode> mode;
        double maxDistortion = 4.1;
        bool makeMap = false;
    };

    template <class Change>
    void order(Change &&change);
    void work();
    void obey(Orders orders);
    void begin(const Orders &orders);
    void updateSolver(bool steeringChanged);
    void step();
    void comeToRest();
    void giveResult();
    void makePausedMap();

    // Shared between threads.
    std::mutex mMutex;
    Orders mOrders;
    std::shared_ptr<SolveResult> mWaitingResult;
    std::optional<PausedMap> mPausedMap;
    bool mAtRest = false;
    std::atomic<bool> mInterrupt = false; //!< there are orders: whatever takes long should end

    const int mThreads;

    // Of the worker's thread.
    std::unique_ptr<homotopy::Solver> mSolver;
    preference::SeamPreference mPreference;
    std::shared_ptr<const Snapshot> mSnapshot;       //!< with the preferences in its weights
    std::optional<homotopy::LiveSchedule> mSchedule; //!< in budget mode
    homotopy::SolveMode mMode = homotopy::SolveMode::Manual;
    double mMaxDistortion = 4.1;
    SolveStatus mStatus;
    homotopy::StepResult mLast;
    std::chrono::steady_clock::time_point mLastGiven, mRateSince;
    int mRateSteps = 0, mStalledSteps = 0;
    std::vector<TracePoint> mTrace;
    StateToken mToken;
    int mStepsLeft = 0; //!< negative: until told to stop
    bool mPulled = false;
    bool mMustMakeMap = false;
    bool mIdle = false; //!< converged while running: the next snapshot makes it run again
};

} // namespace autocuts::live
