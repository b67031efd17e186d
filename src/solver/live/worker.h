// The live solver on a thread of its own: takes the newest snapshot, gives out the newest result.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/homotopy/liveschedule.h"
#include "solver/homotopy/solver.h"
#include "solver/live/mailbox.h"
#include "solver/preference/seampreference.h"
#include "solver/unwrap/freepart.h"

#include <QObject>
#include <QThread>

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

namespace autocuts::live {

//! State of a solve.
struct SolveStatus
{
    int iteration = 0;
    double stepsPerSecond = 0;
    double energy = 0, distortion = 0, separation = 0; //!< as StepResult
    double lambda = 0, delta = 0; //!< values in effect; in budget mode not those of the snapshot
    double seamLength = 0;  //!< seam_norm of the edges that are nearer to cut than to joined, solver units
    int islands = 0;        //!< UV islands that stitching the other edges gives
    bool converged = false; //!< nothing left to gain, or the budget is met: the worker waits for an edit
};

//! One step in the history of a solve.
struct TracePoint
{
    int iteration = 0;
    float distortion = 0, separation = 0, delta = 0;
};

//! Result that the worker gives out.
struct SolveResult
{
    StateToken token;              //!< state of the document that the solve continues from
    UvMatrix soupUv;               //!< one row per soup corner, solver units
    std::vector<float> separation; //!< s_delta per corner pair, in [0, 1)
    SolveStatus status;
    std::vector<TracePoint> trace; //!< the steps since the previous result
};

//! Runs a Solver until told to stop. The functions may be called from any thread and return at once; what
//! they ask for happens between two steps, and of several snapshots only the newest counts. Once an order is
//! given, results made before it that it invalidates can no longer be taken. The worker never sees the
//! document.
class SolveWorker final : public QObject
{
    Q_OBJECT

public:
    //! Most results given out per second. Chosen by hand.
    static constexpr int resultsPerSecond = 30;

    //! \param threads number of threads of one step; no result depends on it
    explicit SolveWorker(int threads = QThread::idealThreadCount());
    ~SolveWorker() override;

    //! Starts a solve and discards the previous one with its results.
    //! \param centre centre of the map when it does not start from existing UVs, solver units
    //! \param warm the map was solved before: in budget mode it is only reheated
    void start(std::shared_ptr<const Snapshot> snapshot, const Vec2 &centre, bool warm = false);
    //! Changes settings or steering for the same mesh; the map continues from where it is.
    //! \param pulled the user is dragging the map: in budget mode lambda and delta stay as they are until a
    //! snapshot with pulled = false
    //! \param back a result since start() to which the map returns first
    void update(std::shared_ptr<const Snapshot> snapshot, bool pulled = false,
                std::shared_ptr<const SolveResult> back = nullptr);
    void setMode(homotopy::SolveMode mode);
    //! A map was put into the document, which now has this token.
    void setToken(const StateToken &token);
    //! Runs until told to stop.
    void run() { runSteps(-1); }
    //! Takes at most this many steps, then waits.
    void runSteps(int count);
    //! Finishes the present step and gives it out as a result.
    void pause();

    //! The newest result, with the trace of results that were never taken; null when none is waiting.
    std::shared_ptr<const SolveResult> takeResult() { return mMailbox.takeResult(); }
    //! Why the solve failed, untranslated, one line.
    std::optional<QString> takeFailure() { return mMailbox.takeFailure(); }
    //! True, once, when the solve stopped by itself and has not been told to continue since.
    bool takeRest() { return mMailbox.takeRest(); }

Q_SIGNALS:
    //! A result is waiting. Sent once until it is taken, at most resultsPerSecond times a second.
    void resultReady();
    //! The solve stopped by itself: it converged or took the steps asked for. takeRest() tells whether it
    //! still rests.
    void waiting();
    //! The solve failed and is over. takeFailure() says why, unless another one was started since.
    void failed();

private:
    //! Orders that were given and not yet carried out.
    struct Orders
    {
        bool start = false; //!< start with the snapshot
        std::shared_ptr<const Snapshot> snapshot;
        std::optional<StateToken> token; //!< replaces the snapshot's token
        bool pulled = false, warm = false;
        std::shared_ptr<const SolveResult> back; //!< the map to continue from
        Vec2 centre = Vec2::Zero();
        std::optional<int> steps; //!< 0: pause
        std::optional<homotopy::SolveMode> mode;
    };

    template <class Change>
    void order(Change &&change);
    void work();
    void obey(Orders orders);
    void begin(const Orders &orders);
    void takeSnapshot(const Snapshot &snapshot);
    void updateSolver(bool steeringChanged);
    void step();
    void giveResult();

    Mailbox<Orders, SolveResult> mMailbox;

    // Used by the worker's thread only.
    const int mThreads;
    std::unique_ptr<homotopy::Solver> mSolver;
    preference::SeamPreference mPreference;
    std::shared_ptr<const Snapshot> mSnapshot; //!< with the seam preferences multiplied into its weights
    std::optional<unwrap::FreePart> mPart;     //!< of mSnapshot: what the solver works on
    std::optional<homotopy::LiveSchedule> mSchedule; //!< in budget mode
    homotopy::SolveMode mMode = homotopy::SolveMode::Manual;
    SolveStatus mStatus;
    homotopy::StepResult mLast;
    std::chrono::steady_clock::time_point mLastGiven, mRateSince;
    int mRateSteps = 0, mStalledSteps = 0;
    std::vector<TracePoint> mTrace;
    StateToken mToken;
    int mStepsLeft = 0; //!< negative: until told to stop
    bool mPulled = false;
    bool mIdle = false; //!< converged while running: the next snapshot makes it run again
};

} // namespace autocuts::live
