// The tool for pins.
#pragma once

#include "commands/editpins.h"
#include "views/canvas/abstracttool.h"

#include <QPointer>

namespace autocuts {

class ToolCanvas;

//! Pins vertices, or whole islands in the mode for islands. A click pins or unpins; with Shift it makes soft
//! pins, or changes existing pins between soft and hard. A drag over empty space pins everything in a box,
//! with Ctrl it unpins. In the UV view, a drag of a pin moves it: while a solve runs, the map follows;
//! otherwise the vertex moves with it, as far as no triangle flips. Pins of locked islands stay.
class PinTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit PinTool(const StudioContext &context, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void deactivate() override;
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
    void setMissed(bool missed);
    //! The pins that a click would make.
    std::vector<UvPin> pinsUnder(const ToolEvent &event) const;
    //! Pins, unpins or changes the kind of pins, depending on the existing ones.
    void toggle(const std::vector<UvPin> &pins, bool shift);
    void applyBox(const ToolEvent &event);
    //! Stores the pins that a drag from here moves; without any, the drag draws a box.
    void grab(const ToolEvent &event);
    void beginDrag();
    void dragTo(const Vec2 &by);
    Vec2 wayWithoutFlips(const Vec2 &by) const;
    void drawPins(QPainter &painter, const ToolCanvas &view) const;

    State mState = State::Idle;
    QPointer<ToolCanvas> mCanvas; //!< the canvas in which the gesture began
    QPointF mStart, mEnd;
    PickResult mPick;          //!< of the press
    std::vector<UvPin> mPins;  //!< the dragged pins before the drag
    std::vector<int> mCorners; //!< the corners that move with them while no solve runs
    UvMatrix mUv;              //!< UVs of mCorners before the drag
    UvMatrix mSoupUv;          //!< UVs of all soup corners before the drag
    Vec2 mBy = Vec2::Zero();
    bool mLive = false; //!< a solve runs during the drag
    quint64 mGesture = 0;
    int mHovered = -1;    //!< soup corner
    bool mMissed = false; //!< the last click was on nothing that can be pinned
};

} // namespace autocuts
