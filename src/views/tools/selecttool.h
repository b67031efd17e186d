// Selecting with the mouse.
#pragma once

#include "views/canvas/abstracttool.h"
#include "views/tools/pickedelements.h"

#include <QPointer>
#include <QPolygonF>

#include <optional>

namespace autocuts {

//! What a drag with the mouse selects with.
enum class SelectShape { Box, Lasso, Brush };

//! Selects vertices, edges, faces or islands by the mode of the document's selection. A click replaces, Shift
//! toggles, Ctrl takes the shortest way from the element clicked before (vertices and edges) or takes away; a
//! drag selects with a box, a lasso or a brush, Shift adds, Ctrl takes away; a double click selects a loop or
//! an island.
class SelectTool final : public AbstractTool
{
    Q_OBJECT

public:
    //! Radius of the brush in pixels, changed by Shift+wheel.
    static constexpr double firstRadius = 24, smallestRadius = 4, largestRadius = 300;

    SelectTool(const StudioContext &context, const QString &id, SelectShape shape, QObject *parent = nullptr);

    QString hint() const override;
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    void doubleClick(const ToolEvent &event) override;
    bool isBusy() const override { return mState != State::Idle; }
    bool wheel(const QWheelEvent &event, ToolCanvas &canvas) override;
    void leave() override;
    void cancel() override;
    bool wantsPicks() const override { return mState != State::Dragging; }
    void drawOverlay(QPainter &painter, const ToolCanvas &canvas) override;

private:
    enum class State { Idle, Pressed, Dragging };

    void click(const ToolEvent &event);
    QString gestureHint() const;
    //! What the box or the lasso has around it so far.
    PickRegion region() const;
    //! Adds what is under the brush to the stroke.
    void paint(const ToolEvent &event);
    //! The way from the anchor to what was picked; empty lists when there is none.
    Selection pathTo(const PickResult &pick) const;

    const SelectShape mShape;
    State mState = State::Idle;
    QPointer<ToolCanvas> mCanvas; //!< where the gesture began
    QPointF mStart, mEnd;
    QPolygonF mLasso;
    double mRadius = firstRadius;
    std::optional<QPointF> mBrush;            //!< where the mouse is, over mCanvas
    Selection mBefore, mStroke;               //!< before the stroke, and what the stroke has touched
    int mAnchorEdge = -1, mAnchorCorner = -1; //!< clicked before; count only while they are selected
};

} // namespace autocuts
