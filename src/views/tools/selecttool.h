// Selecting with the mouse.
#pragma once

#include "views/tools/abstracttool.h"
#include "views/tools/pickedelements.h"

#include <QPointer>

namespace autocuts {

//! Selects vertices, edges, faces or islands by the mode of the document's selection. A click replaces, Shift
//! toggles, Ctrl takes the shortest way from the element clicked before (vertices and edges) or takes away; a
//! drag selects with a box, Shift adds, Ctrl takes away; a double click selects a loop or an island.
class SelectTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit SelectTool(const CanvasContext &context, QObject *parent = nullptr);

    QString hint() const override;
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    void doubleClick(const ToolEvent &event) override;
    bool isBusy() const override { return mState != State::Idle; }
    void cancel() override;
    bool wantsPicks() const override { return mState != State::Box; }
    void drawOverlay(QPainter &painter, const Canvas &canvas) override;

private:
    enum class State { Idle, Pressed, Box };

    void click(const ToolEvent &event);
    //! The way from the anchor to what was picked; empty lists when there is none.
    Selection pathTo(const PickResult &pick) const;

    State mState = State::Idle;
    QPointer<Canvas> mCanvas; //!< where the gesture began
    QPointF mStart, mEnd;
    int mAnchorEdge = -1, mAnchorCorner = -1; //!< clicked before; count only while they are selected
};

} // namespace autocuts
