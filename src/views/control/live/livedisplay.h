// What is known of a live solve, and what of it is shown.
#pragma once

#include "solver/live/mapkeeper.h"
#include "solver/live/worker.h"
#include "views/control/live/livepacker.h"

#include <memory>
#include <vector>

namespace autocuts {

class ShownMap;
class Workspace;

//! What is shown of a solve.
enum class LiveView {
    Map, //!< the definite map
    Soup //!< the separate triangles of the paper's solver
};

//! Keeps the newest definite map and the newest soup of a live solve with the figures of all before, and
//! shows one of them, the other one as a ghost.
class LiveDisplay final : public QObject
{
    Q_OBJECT

public:
    LiveDisplay(Workspace &workspace, ShownMap &shownMap, QObject *parent = nullptr);

    //! Forgets the solve.
    void clear();
    void take(std::shared_ptr<const live::SolveResult> soup);
    void take(std::shared_ptr<const unwrap::LiveMapResult> map);
    //! Null when there is none.
    const std::shared_ptr<const unwrap::LiveMapResult> &map() const { return mMap; }
    const std::shared_ptr<const live::SolveResult> &soup() const { return mSoup; }

    LiveView view() const { return mView; }
    void setView(LiveView view) { mView = view; }
    //! True when the state that is not shown is to be seen as a ghost.
    bool ghost() const { return mGhost; }
    void setGhost(bool ghost) { mGhost = ghost; }
    bool seesSoup() const { return mView == LiveView::Soup || mGhost; }
    //! True when the soup was stepped since the solve began. Until then it is not shown.
    bool soupRan() const { return mSoupRan; }
    void setSoupRan() { mSoupRan = true; }
    //! True when the islands of the soup are shown side by side.
    bool packs() const { return mPacks; }
    void setPacks(bool packs);

    //! Status and figures of what is shown, see SolverController.
    //! \param mapRests nothing is left to gain on the definite map
    live::SolveStatus status(bool mapRests) const;
    const std::vector<live::TracePoint> &trace() const;
    //! Of the soup, shown or not.
    const live::SolveStatus &soupStatus() const { return mSoupStatus; }

    void show();

Q_SIGNALS:
    //! The islands of the soup have new places: it should be shown again.
    void arranged();

private:
    void addToTrace(const std::vector<live::TracePoint> &points);

    Workspace &mWorkspace;
    ShownMap &mShownMap;
    std::shared_ptr<const live::SolveResult> mSoup;
    std::shared_ptr<const unwrap::LiveMapResult> mMap;
    live::SolveStatus mSoupStatus;
    std::vector<live::TracePoint> mSoupTrace, mMapTrace;
    int mTraceStride = 1;
    LiveView mView = LiveView::Map;
    bool mGhost = false, mSoupRan = false, mPacks = false;
    LivePacker mPacker;
};

} // namespace autocuts
