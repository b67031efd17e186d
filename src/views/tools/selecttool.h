// The tool for selecting.
#pragma once

#include "views/canvas/abstracttool.h"
#include "views/tools/pickedelements.h"

#include <QPointer>
#include <QPolygonF>

#include <optional>

namespace autocuts {

//! The shape that a drag selects with.
enum class SelectShape { Box, Lasso, Brush };

//! Selects vertices, edges, faces or islands, by the selection mode. A click replaces the selection, Shift
//! toggles, Ctrl adds the shortest path from the last click (vertices and edges) or removes. A drag selects
//! with a box, a lasso or a brush; Shift adds, Ctrl removes. A double click selects a loop or an island.
class SelectTool final : public AbstractTool
{
    Q_OBJECT

public:
    //! Pixels: radius of the brush, changed by Shift+wheel. Chosen by hand.
    static constexpr double firstRadius = 24, smallestRadius = 4, largestRadius = 300;

    SelectTool(const StudioContext &context, const QString &id, SelectShape shape, QObject *parent = nullptr);

    QString hint() const override;
    std::vector<ToolOption> options() override;
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
    //! The region inside the box or the lasso so far.
    PickRegion region() const;
    //! Adds the elements under the brush to the stroke.
    void paint(const ToolEvent &event);
    //! The triangle that a click means: where one sees through the model, clicks in one place go deeper.
    int clickedTriangle(const ToolEvent &event);
    //! The path from the last click to a pick; empty lists when there is none.
    Selection pathTo(const PickResult &pick) const;

    const SelectShape mShape;
    State mState = State::Idle;
    QPointer<ToolCanvas> mCanvas; //!< the canvas in which the gesture began
    QPointF mStart, mEnd;
    QPolygonF mLasso;
    double mRadius = firstRadius;
    std::optional<QPointF> mBrush; //!< position of the mouse over mCanvas
    //! The selection before the stroke, and the elements that the stroke has touched.
    Selection mBefore, mStroke;
    std::optional<QPointF> mLastClick;
    std::size_t mLayer = 0;                   //!< of the elements under the last click, from the front
    int mAnchorEdge = -1, mAnchorCorner = -1; //!< of the last click; used only while they are selected
};

} // namespace autocuts
