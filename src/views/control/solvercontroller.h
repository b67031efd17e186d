// Connects the document to the solver's worker: sends snapshots and receives results.
#pragma once

#include "solver/live/worker.h"
#include "views/control/livepacker.h"

#include <QObject>
#include <QThread>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace autocuts {

class ShownMap;
class Workspace;

//! Runs the live solver (paper, section 3) beside the document.
//!
//! While a solve runs, ShownMap shows the solver's map and the document keeps its old one. When the solve
//! pauses, the worker stitches corner pairs that are nearly closed (paper, section 4, "Finalizing the UV
//! map"), and this paused map is put into the document as one undo entry. The solver keeps its own state and
//! can continue from it. Edits of the steering during a run are sent as a new snapshot, and the run
//! continues. Edits of UVs and undo must wait for whenPaused(); otherwise the solver's map is discarded.
class SolverController final : public QObject
{
    Q_OBJECT

public:
    SolverController(Workspace &workspace, ShownMap &shownMap, QObject *parent = nullptr);
    ~SolverController() override;

    bool isRunning() const { return mRunning; }
    //! True from pause() until the paused map is in the document.
    bool isPausing() const { return mPausing; }
    //! True when run() continues a paused solve.
    bool canContinue() const;

    homotopy::SolveMode mode() const { return mMode; }
    //! Manual uses lambda and delta of the document. With Budget, the worker finds them for the distortion
    //! bound. Changing to Manual copies what the worker has found to the document as the start for manual
    //! steering.
    void setMode(homotopy::SolveMode mode);
    double maxDistortion() const { return mMaxDistortion; }
    //! \pre bound > 4
    void setMaxDistortion(double bound);

    //! Status of the newest result; iteration 0 before the first.
    const live::SolveStatus &status() const { return mStatus; }
    //! The figures of all steps of the run; of a long run, evenly spaced steps.
    const std::vector<live::TracePoint> &trace() const { return mTrace; }

    //! The solver's map when it is newer than the document's map or the latter was made from it; null
    //! otherwise.
    std::shared_ptr<const live::SolveResult> result() const { return mResult; }

    //! True when the islands of a running solve are shown side by side (LivePacker). Changes neither the map
    //! nor the results.
    bool livePacking() const { return mLivePacking; }
    void setLivePacking(bool pack);

    //! Pauses, and calls the function when the map is in the document; at once when no solve runs. The call
    //! is dropped when the solve fails or the document is replaced.
    void whenPaused(std::function<void()> then);

    //! Pulls soup corners of the running solve to positions by springs. Pulls belong to a gesture, not to the
    //! document. The run does not stop by itself until an empty list removes them. When the run ends, they
    //! are removed as well.
    //! \param pulls soft pins, targets in texture space
    void setPulls(std::vector<Pin> pulls);
    //! Removes the pulls and restores the map from before them.
    void cancelPulls();

public Q_SLOTS:
    void run();
    void pause();
    void toggle();
    //! Runs one Newton step.
    void step();
    //! Starts again from the start mode; keeps running if it was running.
    void restart();
    //! Discards the solver's map; the document's map is shown, and the next run starts from it.
    void discard();

Q_SIGNALS:
    //! Running, pausing, mode or bound changed.
    void stateChanged();
    //! status() and trace() changed; at most 30 times a second.
    void statusChanged();
    //! Called on the worker's thread when it waits; this object is notified through its event loop.
    void workerRests();
    //! \param message translated, one line
    void failed(const QString &message);

private:
    void documentReplaced();
    void documentChanged();
    void takeResult();
    void showResult();
    void takePausedMap();
    void workerWaits();
    void workerFailed();
    void begin(StartMode start, bool warm = false);
    void beginWhereTheMapIs();
    void setRunning(bool running, bool pausing);
    void sendSnapshot(const std::shared_ptr<const live::SolveResult> &back = nullptr);
    void addToTrace(const std::vector<live::TracePoint> &points);

    Workspace &mWorkspace;
    ShownMap &mShownMap;
    QThread mThread;
    live::SolveWorker *mWorker; //!< lives in mThread
    std::shared_ptr<const live::SolveResult> mResult;
    LivePacker mPacker;
    bool mLivePacking = false;
    live::SolveStatus mStatus;
    std::vector<live::TracePoint> mTrace;
    int mTraceStride = 1;
    homotopy::SolveMode mMode = homotopy::SolveMode::Budget;
    double mMaxDistortion = 4.1;
    //! Token of the document's state from which the worker continues; empty when the worker has nothing that
    //! fits the document.
    std::optional<StateToken> mToken;
    std::vector<std::function<void()>> mWhenPaused;
    std::vector<Pin> mPulls;
    std::shared_ptr<const live::SolveResult> mBeforePulls;
    QTimer mSendSoon; //!< sends one snapshot for all edits in one turn of the event loop
    bool mRunning = false, mPausing = false, mStepping = false;
};

} // namespace autocuts
