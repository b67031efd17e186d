// The tool for bounding rectangles of islands.
#pragma once

#include "views/canvas/abstracttool.h"
#include "views/tools/rectangles.h"

#include <QPointer>

namespace autocuts {

class RectangleBar;
class ToolCanvas;

//! Works in the UV view. A drag over empty space, or with Shift anywhere, draws a rectangle. A drag of an
//! outline, a name or the empty space inside moves one; handles resize the active one. A drag of an island,
//! or of the selected ones, into a rectangle assigns its faces; a drag out of all rectangles removes the
//! assignment. Locked islands are ignored. A click activates a rectangle, a double click renames it, Delete
//! removes it. All changes also steer a running solve.
class RectangleTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit RectangleTool(const StudioContext &context, QObject *parent = nullptr);
    ~RectangleTool() override;

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void activate() override;
    void deactivate() override;
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    void doubleClick(const ToolEvent &event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    bool keyPress(const QKeyEvent &event, ToolCanvas &canvas) override;
    bool isBusy() const override { return mState != State::Idle; }
    void cancel() override;
    bool wantsPicks() const override { return mState == State::Idle; }
    void drawOverlay(QPainter &painter, const ToolCanvas &canvas) override;

    //! The active rectangle, which the bar shows; 0 for none.
    int active() const { return mActive; }

private:
    //! Packs the islands of a rectangle into it.
    void pack(int id);
    enum class State { Idle, Pressed, Edit, Assign };
    //! The kind of gesture that a press began.
    enum class Intent { Draw, Change, Assign };

    const std::vector<LayoutRectangle> &rectangles() const;
    void setActive(int id);
    void reset();
    void beginDrag();
    //! Adds the rectangle that was drawn.
    void addRectangle();
    void dragTo(const ToolEvent &event);
    void assignAt(const QPointF &position);
    //! The faces that a drag from a face assigns.
    QList<int> facesDragged(int face) const;
    void drawActive(QPainter &painter) const;
    void drawAssignment(QPainter &painter) const;

    State mState = State::Idle;
    Intent mIntent = Intent::Draw;
    QPointer<ToolCanvas> mView; //!< the view in which the gesture began
    QPointF mStart, mEnd;
    RectangleGrip mGrip;
    LayoutRectangle mBefore; //!< at the beginning of the drag
    QList<int> mFaces;       //!< the faces to assign
    quint64 mGesture = 0;
    int mActive = 0;
    QPointer<RectangleBar> mBar; //!< owned by the view
};

} // namespace autocuts
