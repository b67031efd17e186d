// The tools that move, rotate and scale islands.
#pragma once

#include "commands/islandtransform.h"
#include "views/canvas/abstracttool.h"
#include "views/selecting/movableislands.h"
#include "views/tools/islandgizmo.h"
#include "views/tools/islandsnap.h"

#include <QPointer>

namespace autocuts {

class ToolCanvas;

//! Transforms the selected islands in the UV view. A drag starts on an island or a handle. When the tool's
//! key is pressed over the view, the islands follow the mouse at once until a click or Enter. Numbers can be
//! typed, X and Y restrict the axis, Ctrl snaps, Escape and the right button cancel. A click selects islands.
//! Locked islands stay. A live solve is paused first and continues after the gesture.
class IslandTool final : public AbstractTool
{
    Q_OBJECT

public:
    //! \param edit Move, Rotate or Scale
    IslandTool(const StudioContext &context, const QString &id, UvEdit edit, QObject *parent = nullptr);

    QString hint() const override;
    std::vector<ToolOption> options() override;
    bool movesMap() const override { return true; }
    void deactivate() override;
    void chosen(ToolCanvas &canvas, const QPointF &position) override;
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    bool keyPress(const QKeyEvent &event, ToolCanvas &canvas) override;
    bool isBusy() const override { return mState != State::Idle; }
    void cancel() override;
    bool wantsPicks() const override { return mState == State::Idle; }
    void drawOverlay(QPainter &painter, const ToolCanvas &canvas) override;

private:
    //! Waiting: until the solver has put its map into the document.
    enum class State { Idle, Pressed, Waiting, Active };

    void begin(ToolCanvas &view, const QPointF &position, DragAxis axis);
    void start();
    void apply();
    //! Ends the gesture and keeps its result.
    void finish();
    void select(const ToolEvent &event, bool pressed);
    bool isSelected(int face) const;
    MovableIslands movable() const;
    std::vector<int> selectedIslands() const;
    //! Where the handles are; nothing when no selected island can be moved.
    std::optional<Vec2> gizmoPlace() const;
    std::optional<DragAxis> partAt(const ToolEvent &event) const;
    //! Snaps the move to other islands while Shift is held.
    void snapToIslands();
    void drawSnapped(QPainter &painter, const ToolCanvas &view) const;
    void drawGuide(QPainter &painter, const ToolCanvas &view, const QPointF &centre) const;

    const UvEdit mEdit;
    State mState = State::Idle;
    QPointer<ToolCanvas> mView; //!< the view in which the gesture began
    QPointF mStart;             //!< of the press
    IslandDrag mDrag;
    MovableIslands mMoved;             //!< set while Active
    std::unique_ptr<IslandSnap> mSnap; //!< made when it is first needed
    IslandSnapResult mSnapped;
    std::unique_ptr<IslandTransform> mTransform; //!< set while Active
    int mGesture = 0;                            //!< number of gestures so far
    bool mByKey = false;                         //!< no mouse button is held
    bool mConfirmed = false;                     //!< set while Waiting
    bool mGoOn = false;                          //!< the solver ran before the gesture
    bool mSelectOnRelease = false;
    std::optional<DragAxis> mHovered;
    bool mAllLocked = false; //!< why the last gesture did nothing
};

} // namespace autocuts
