// The overlap tool: separates overlapping regions of the map by hand.
#pragma once

#include "model/plain/types.h"
#include "views/canvas/abstracttool.h"
#include "views/control/session/jobrunner.h"

#include <QPointer>

#include <vector>

namespace autocuts {

class ToolCanvas;

//! A click selects a region around it that does not overlap itself (paper, figure 9), if possible so that the
//! rest of the island does not overlap itself either. A drag moves the selected faces away as a separate
//! island. The region is searched off the GUI thread; Escape cancels the search. A live solve is paused first
//! and continues after the drag. Locked islands stay.
class RegionTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit RegionTool(const StudioContext &context, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override;
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    bool isBusy() const override { return mState != State::Idle; }
    void cancel() override;
    bool wantsPicks() const override { return mState == State::Idle || mState == State::Searching; }

private:
    enum class State { Idle, Pressed, Searching, Waiting, Moving };

    void search(int triangle, bool add);
    void select(const QList<int> &faces, bool add);
    void setState(State state);
    //! Called when the solver is paused: the selected faces begin to move.
    void begin();
    void moveTo(const QPointF &position);

    State mState = State::Idle;
    JobRunner mSearch{JobRunner::OnCancel::LetGo};
    int mSearches = 0;            //!< number of searches so far
    bool mOneIsEnough = true;     //!< the rest of the clicked island does not overlap itself
    bool mGoOn = false;           //!< the solver ran when the tool was activated
    QPointer<ToolCanvas> mCanvas; //!< the canvas in which the gesture began
    QPointF mStart;
    int mTriangle = -1; //!< under the press
    quint64 mGesture = 0;
    std::vector<int> mCorners; //!< the moving corners
    UvMatrix mFrom;            //!< their start positions, one row each
};

} // namespace autocuts
