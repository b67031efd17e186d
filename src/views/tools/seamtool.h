// Cutting and joining with the mouse.
#pragma once

#include "commands/setseamstate.h"
#include "views/canvas/abstracttool.h"
#include "views/control/energygain.h"
#include "views/tools/seampath.h"

#include <QPointer>

#include <vector>

namespace autocuts {

//! Forces edges to be cut, or to stay together. A click takes an edge, a drag the shortest way from where it
//! began, Ctrl+click the shortest way from what was clicked before, a double click the loop; Shift leaves
//! them to the solver again. What would be taken is shown under the mouse. Diagonals of polygons are never
//! taken.
class SeamTool final : public AbstractTool
{
    Q_OBJECT

public:
    enum class Kind { Cut, Join };

    SeamTool(const StudioContext &context, Kind kind, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void deactivate() override;
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    void doubleClick(const ToolEvent &event) override;
    void leave() override;
    bool isBusy() const override { return mState != State::Idle; }
    void cancel() override;
    bool marksHover() const override { return false; }
    void drawOverlay(QPainter &painter, const ToolCanvas &canvas) override;

    //! The edges that a click would take now, in rising order.
    const std::vector<int> &preview() const { return mPreview; }

private:
    enum class State { Idle, Pressed, Path };

    //! Shows the way between two ends; found only when one of them changed.
    void showPath(const PathEnd &from, const PathEnd &to);
    void showEdges(std::vector<int> edges);
    void showUnder(const ToolEvent &event);
    //! Takes what is shown. \param gesture edits of one merge
    void commit(quint64 gesture);

    const Kind mKind;
    State mState = State::Idle;
    QPointer<ToolCanvas> mCanvas; //!< where the gesture began
    QPointF mStart;
    PathEnd mFirst;             //!< where the drag began
    PathEnd mAnchor;            //!< clicked before
    PathEnd mPathFrom, mPathTo; //!< of the way that is shown
    std::vector<int> mPreview;
    SetSeamState::Edit mEdit; //!< by the modifiers
    quint64 mClick = 0;       //!< gesture of the last click, which a double click continues
    EnergyGain mGain;
};

} // namespace autocuts
