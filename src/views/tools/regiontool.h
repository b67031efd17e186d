// Taking overlapping parts of the map away by hand.
#pragma once

#include "model/plain/types.h"
#include "views/canvas/abstracttool.h"
#include "views/control/jobrunner.h"

#include <QPointer>

#include <vector>

namespace autocuts {

class ToolCanvas;

//! The overlap tool (paper, figure 9): a click selects a region around it that does not cover itself, if
//! possible so that the rest of the island does not either; dragging what is selected in the map moves it
//! away as an island of its own. The region is searched off the GUI thread; Escape ends that. A live solve is
//! paused first and goes on after the drag. What is locked stays.
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
    //! The solver rests: what is selected begins to move.
    void begin();
    void moveTo(const QPointF &position);

    State mState = State::Idle;
    JobRunner mSearch{JobRunner::OnCancel::LetGo};
    int mSearches = 0;            //!< counts them
    bool mOneIsEnough = true;     //!< the rest of the island that was clicked does not cover itself
    bool mGoOn = false;           //!< the solver ran when the tool came
    QPointer<ToolCanvas> mCanvas; //!< where the gesture began
    QPointF mStart;
    int mTriangle = -1; //!< pressed
    quint64 mGesture = 0;
    std::vector<int> mCorners; //!< that move
    UvMatrix mFrom;            //!< where they began, one row each
};

} // namespace autocuts
