// Pinning with the mouse.
#pragma once

#include "commands/editpins.h"
#include "views/canvas/abstracttool.h"

#include <QPointer>

namespace autocuts {

class ToolCanvas;

//! Pins vertices, or in the mode of islands whole islands. A click pins or unpins; Shift makes the pins soft,
//! or pinned ones the other kind; a drag over empty space pins what is in a box, with Ctrl it unpins. In the
//! UV view a drag of a pin moves it: while a solve runs the map follows, else the pinned vertex moves along,
//! as far as no triangle turns over. Pins of locked islands stay.
class PinTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit PinTool(const StudioContext &context, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    bool isBusy() const override { return mState != State::Idle; }
    void cancel() override;
    bool wantsPicks() const override { return mState == State::Idle; }
    bool marksHover() const override { return islandMode() && mState == State::Idle; }
    void drawOverlay(QPainter &painter, const ToolCanvas &canvas) override;

private:
    enum class State { Idle, Pressed, Box, Drag };

    bool islandMode() const;
    void reset();
    //! What a click at a place pins.
    std::vector<UvPin> pinsUnder(const ToolEvent &event) const;
    //! Pins, unpins or changes the kind, by what is pinned already.
    void toggle(const std::vector<UvPin> &pins, bool shift);
    void applyBox(const ToolEvent &event);
    //! The pins that a drag from here moves; none: it draws a box.
    void grab(const ToolEvent &event);
    void beginDrag();
    void dragTo(const Vec2 &by);
    Vec2 wayWithoutFlips(const Vec2 &by) const;
    void drawPins(QPainter &painter, const ToolCanvas &view) const;

    State mState = State::Idle;
    QPointer<ToolCanvas> mCanvas; //!< where the gesture began
    QPointF mStart, mEnd;
    PickResult mPick;          //!< of the press
    std::vector<UvPin> mPins;  //!< that are dragged, as they were
    std::vector<int> mCorners; //!< that move along while no solve runs
    UvMatrix mUv;              //!< of mCorners, as it was
    UvMatrix mSoupUv;          //!< of all soup corners, as it was
    Vec2 mBy = Vec2::Zero();
    bool mLive = false; //!< a solve runs during the drag
    quint64 mGesture = 0;
    int mHovered = -1; //!< soup corner
};

} // namespace autocuts
