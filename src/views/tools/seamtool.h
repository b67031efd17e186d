// The tools for cutting and joining edges.
#pragma once

#include "commands/setseamstate.h"
#include "views/canvas/abstracttool.h"
#include "views/control/live/energygain.h"
#include "views/tools/seampath.h"

#include <QPointer>

#include <vector>

namespace autocuts {

//! Cuts or joins edges. A click affects one edge, a drag the shortest path from its start, Ctrl+click the
//! shortest path from the last click, a double click the loop; Shift frees the edges. The affected edges are
//! shown under the mouse. Diagonals of polygons are never affected.
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

    //! The edges that a click would affect now, in ascending order.
    const std::vector<int> &preview() const { return mPreview; }

private:
    enum class State { Idle, Pressed, Path };

    //! Shows the path between two ends; it is computed only when one of them has changed.
    void showPath(const PathEnd &from, const PathEnd &to);
    void showEdges(std::vector<int> edges);
    void showUnder(const ToolEvent &event);
    //! Cuts, joins or frees the shown edges. \param gesture number for merging
    void commit(quint64 gesture);

    const Kind mKind;
    State mState = State::Idle;
    QPointer<ToolCanvas> mCanvas; //!< the canvas in which the gesture began
    QPointF mStart;
    PathEnd mFirst;             //!< where the drag began
    PathEnd mAnchor;            //!< the last click
    PathEnd mPathFrom, mPathTo; //!< ends of the shown path
    std::vector<int> mPreview;
    SetSeamState::Edit mEdit; //!< by the modifiers
    quint64 mClick = 0;       //!< gesture of the last click, which a double click continues
    EnergyGain mGain;
};

} // namespace autocuts
