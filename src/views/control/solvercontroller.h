// The only meeting of the document and the solver's worker: snapshots out, results in.
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
//! While a solve runs, ShownMap shows the solver's map and the document keeps the one before. When it pauses,
//! the worker joins what is nearly joined (paper, "Finalizing") and the map goes into the document as one
//! undo entry; the solver keeps its own state and can go on from there. Edits of the steering during a run
//! are sent as a new snapshot and the run goes on. What changes the UVs, or undoes, must come after
//! whenPaused(); when it does not, the solver's map is dropped.
class SolverController final : public QObject
{
    Q_OBJECT

public:
    SolverController(Workspace &workspace, ShownMap &shownMap, QObject *parent = nullptr);
    ~SolverController() override;

    bool isRunning() const { return mRunning; }
    //! True from pause() until the joined map is in the document.
    bool isPausing() const { return mPausing; }
    //! True when run() goes on where it was paused.
    bool canContinue() const;

    homotopy::SolveMode mode() const { return mMode; }
    //! Manual: lambda and delta of the document. Budget: the worker finds them for the distortion bound.
    //! Turning to Manual puts what the worker has found into the document, to be steered on from there.
    void setMode(homotopy::SolveMode mode);
    double maxDistortion() const { return mMaxDistortion; }
    //! \pre bound > 4
    void setMaxDistortion(double bound);

    //! Of the newest result; iteration 0 before the first.
    const live::SolveStatus &status() const { return mStatus; }
    //! Every step of the run so far, thinned out evenly when it gets long.
    const std::vector<live::TracePoint> &trace() const { return mTrace; }

    //! The solver's map, when it is newer than the document's or the one that it was made from; else null.
    std::shared_ptr<const live::SolveResult> result() const { return mResult; }

    //! While a solve runs its islands are shown beside each other (LivePacker). Changes neither the map nor
    //! what becomes of it.
    bool livePacking() const { return mLivePacking; }
    void setLivePacking(bool pack);

    //! Pauses, and calls the function once the map is in the document: at once when nothing runs. Dropped
    //! when the solve fails or the document is replaced.
    void whenPaused(std::function<void()> then);

    //! Pulls soup corners of the running solve to places with springs. They belong to a gesture, not to the
    //! document; the run goes on, without an end of its own, until they are let go by an empty list. What
    //! ends the run ends them. \param pulls soft, targets in texture space
    void setPulls(std::vector<Pin> pulls);
    //! Lets go and takes the map back to where it was when the pulls began.
    void cancelPulls();

public Q_SLOTS:
    void run();
    void pause();
    void toggle();
    //! One Newton step.
    void step();
    //! Begins anew from the start mode, running when it was.
    void restart();
    //! Forgets the solver's map: the document's is shown and continued from.
    void discard();

Q_SIGNALS:
    //! Running, settling, mode or bound.
    void stateChanged();
    //! status() and trace(), at most 30 times a second.
    void statusChanged();
    //! From the worker's thread: it waits, and this object will be told so by its event loop.
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
    void workerFailed(const QString &message);
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
    //! Of the document's state that the worker goes on from; none when it has nothing that fits the document.
    std::optional<StateToken> mToken;
    std::vector<std::function<void()>> mWhenPaused;
    std::vector<Pin> mPulls;
    std::shared_ptr<const live::SolveResult> mBeforePulls;
    QTimer mSendSoon; //!< one snapshot for all edits of one turn of the event loop
    bool mRunning = false, mPausing = false, mStepping = false;
};

} // namespace autocuts
