// Taking overlapping parts of the map away by hand.
#pragma once

#include "model/types.h"
#include "views/tools/abstracttool.h"

#include <QPointer>

#include <vector>

namespace autocuts {

class UvView;

//! The overlap tool (paper, figure 9): a click selects the largest region around it that does not cover
//! itself, dragging what is selected in the map moves it away as an island of its own. A live solve is paused
//! first. What is locked stays.
class RegionTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit RegionTool(const CanvasContext &context, QObject *parent = nullptr);

    QString hint() const override;
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    bool isBusy() const override { return mState != State::Idle; }
    void cancel() override;
    bool wantsPicks() const override { return mState == State::Idle; }

private:
    enum class State { Idle, Pressed, Waiting, Moving };

    void select(int triangle, bool add);
    //! The solver rests: what is selected begins to move.
    void begin();
    void moveTo(const QPointF &position);

    State mState = State::Idle;
    QPointer<Canvas> mCanvas; //!< where the gesture began
    QPointF mStart;
    int mTriangle = -1; //!< pressed
    quint64 mGesture = 0;
    std::vector<int> mCorners; //!< that move
    UvMatrix mFrom;            //!< where they began, one row each
};

} // namespace autocuts
