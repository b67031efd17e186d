// Connects the document to the solver's worker: sends snapshots and receives results.
#pragma once

#include "model/document/selection.h"
#include "views/control/live/livedisplay.h"

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

//! Runs a live solve beside the document, in two states: the definite map, which is valid at every moment
//! (MapKeeper), and the soup of the paper, section 3 (SolveWorker), which is stepped only while it is seen.
//!
//! While a solve runs, ShownMap shows one of them and the document keeps its old map. On pause, the definite
//! map is put into the document as one undo entry; when there is none yet that obeys the steering, the pause
//! waits for it. Both states are kept, and a run can continue from them. Edits of the steering during a run
//! are sent as a new snapshot, and the run continues. Edits of UVs and undo must wait for whenPaused();
//! otherwise the solver's maps are discarded.
class SolverController final : public QObject
{
    Q_OBJECT

public:
    SolverController(Workspace &workspace, ShownMap &shownMap, QObject *parent = nullptr);
    ~SolverController() override;

    bool isRunning() const { return mRunning; }
    //! True from pause() until the map is in the document.
    bool isPausing() const { return mPausing; }
    //! True when the solve may change only a part of the mesh.
    bool isLimited() const { return mScope != nullptr; }
    //! True when run() continues a paused solve.
    bool canContinue() const;

    homotopy::SolveMode mode() const { return mMode; }
    //! Manual uses lambda and delta of the document. With Budget, the worker finds them for the distortion
    //! bound. Changing to Manual copies what the worker has found to the document as the start for manual
    //! steering.
    void setMode(homotopy::SolveMode mode);

    //! Status of what is shown; iteration 0 before the first result. Of the definite map: iteration counts
    //! the maps that were found, the separation is the seam length, and there is no delta.
    live::SolveStatus status() const { return mDisplay.status(mMapRests); }
    //! The figures of what is shown: of all steps of the soup (of a long run, evenly spaced steps), or of all
    //! definite maps.
    const std::vector<live::TracePoint> &trace() const { return mDisplay.trace(); }

    LiveView liveView() const { return mDisplay.view(); }
    void setLiveView(LiveView view);
    //! True when the state that is not shown is to be seen as a ghost.
    bool ghost() const { return mDisplay.ghost(); }
    void setGhost(bool ghost);

    //! The newest definite map of the solve; null when there is none.
    std::shared_ptr<const unwrap::LiveMapResult> map() const { return mDisplay.map(); }
    //! The newest state of the soup, when that has been seen during this solve; null otherwise.
    std::shared_ptr<const live::SolveResult> soup() const
    {
        return mDisplay.soupRan() ? mDisplay.soup() : nullptr;
    }

    //! True when the islands of a running solve are shown side by side (LivePacker). Changes neither the map
    //! nor the results.
    bool livePacking() const { return mDisplay.packs(); }
    void setLivePacking(bool pack);

    //! Pauses, and calls the function when the map is in the document; at once when no solve runs. The call
    //! is dropped when the solve fails or the document is replaced.
    void whenPaused(std::function<void()> then);

    //! Pauses with the newest map, also when that does not obey the last edits of the steering yet. For what
    //! cannot wait and runs the solver again.
    void pauseAtOnce();

    //! Pulls soup corners of the running solve to positions by springs. Pulls belong to a gesture, not to the
    //! document. The run does not stop by itself until an empty list removes them. When the run ends, they
    //! are removed as well.
    //! \param pulls soft pins, targets in texture space
    //! \param dragged soup corners that the user drags: their islands stay where they are put
    void setPulls(std::vector<Pin> pulls, std::vector<int> dragged = {});
    //! Removes the pulls and restores the map from before them.
    void cancelPulls();

public Q_SLOTS:
    void run();
    void pause();
    void toggle();
    //! Begins a solve that may change the selected faces only, until it is paused. The map stays continuous
    //! at the border of the selection. Does nothing without selected faces.
    void runOnSelection();
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
    //! A solve has ended by itself and left the map as it was. \param message translated, one line
    void said(const QString &message);
    //! The map that a pause put into the document does not obey the user in all.
    //! \param message translated, one line \param items what it is about; empty: nothing in particular
    void foundProblems(const QString &message, const autocuts::Selection &items);

private:
    void documentReplaced();
    void documentChanged();
    void takeResult();
    void takeMap();
    void showResult();
    void runSoup();
    unwrap::LiveMapOptions mapOptions() const;
    void endPause(bool withAnyMap = false);
    void tellProblems();
    void workerWaits();
    void keeperRests();
    void fail(const std::optional<QString> &message);
    void begin(StartMode start, bool warm = false);
    void setScope(std::shared_ptr<const JobScope> scope);
    void goOn();
    void beginWhereTheMapIs();
    void setRunning(bool running, bool pausing);
    void sendSnapshot(bool back = false);

    Workspace &mWorkspace;
    ShownMap &mShownMap;
    QThread mThread, mKeeperThread;
    live::SolveWorker *mWorker; //!< lives in mThread
    live::MapKeeper *mKeeper;   //!< lives in mKeeperThread
    LiveDisplay mDisplay;
    bool mMapRests = false; //!< nothing is left to gain on the definite map
    bool mEndsByItself = false;
    homotopy::SolveMode mMode = homotopy::SolveMode::Budget;
    //! Token of the document's state from which the worker continues; empty when the worker has nothing that
    //! fits the document.
    std::optional<StateToken> mToken;
    std::vector<std::function<void()>> mWhenPaused;
    std::vector<Pin> mPulls;
    std::vector<int> mDragged; //!< soup corners, see setPulls()
    std::shared_ptr<const live::SolveResult> mBeforePulls;
    std::shared_ptr<const unwrap::LiveMapResult> mMapBeforePulls;
    std::shared_ptr<const JobScope> mScope; //!< what the solve may change; null: all faces
    QTimer mSendSoon; //!< sends one snapshot for all edits in one turn of the event loop
    bool mRunning = false, mPausing = false, mStepping = false;
};

} // namespace autocuts
