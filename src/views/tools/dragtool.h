// Pulling at the map with the mouse.
#pragma once

#include "views/canvas/abstracttool.h"
#include "views/tools/dragreach.h"

#include <QPointer>

namespace autocuts {

class ToolCanvas;

//! Pulls vertices, edges, faces or whole pieces of the map, by the mode of the selection (paper, "Assisted
//! cutting"). What is inside the circle follows, the rest stays. While a solve runs what is pulled is held by
//! springs: the map deforms or, where the energy prefers it, tears; a tear is kept as cuts. Else the corners
//! move by themselves, never so far that a triangle turns over. Corners that come near their partners across
//! a seam snap to them and are joined. A click selects. Locked islands and pinned corners stay.
class DragTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit DragTool(const StudioContext &context, QObject *parent = nullptr);

    //! Of the circle, logical pixels.
    double radius() const { return mRadius; }

    QString hint() const override;
    QCursor cursor() const override { return Qt::OpenHandCursor; }
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    void leave() override;
    bool wheel(const QWheelEvent &event, ToolCanvas &canvas) override;
    bool isBusy() const override { return mState != State::Idle; }
    void cancel() override;
    bool wantsPicks() const override { return mState == State::Idle; }
    void drawOverlay(QPainter &painter, const ToolCanvas &canvas) override;

private:
    enum class State { Idle, Pressed, Drag };
    //! A corner pair of a seam that the drag could close.
    struct Gap
    {
        int pair = 0, corner = 0, partner = 0; //!< the dragged soup corner and the one across
        double width = 0;                      //!< when the drag began, pixels
    };

    bool reachesAround() const;
    void begin();
    void updateReach();
    void findGaps();
    void apply();
    //! Snaps the way to a gap that it nearly closes. \returns the gaps that are closed then
    std::vector<Gap> snap(Vec2 &way) const;
    Vec2 wayThatCloses(const Gap &gap) const;
    void pull(const Vec2 &way);
    void moveCorners(const Vec2 &way);
    void closeGaps(UvMatrix &ways) const;
    //! What the solver did to the map under the pull is kept as cuts or joins.
    void keepSeams();
    //! Lets go of the solve once the joined gaps are shut; far apart their springs would not close them.
    void letGoWhenShut();
    void letGo();
    void select(const ToolEvent &event);
    void reset();
    void drawDrag(QPainter &painter, const ToolCanvas &view) const;

    State mState = State::Idle;
    double mRadius = 120;
    QPointer<ToolCanvas> mView; //!< that the mouse is over, or where the gesture began
    QPointF mStart, mMouse;
    PickResult mPick; //!< of the press

    // The drag.
    bool mLive = false;             //!< a solve runs
    UvMatrix mUv;                   //!< of the soup corners when it began
    UvMatrix mCornerUv;             //!< of the document's corners then
    std::vector<float> mSeparation; //!< of the corner pairs then
    std::vector<int> mHandles;      //!< soup corners
    DragReach mReach;
    std::vector<Gap> mGaps, mClosed; //!< that could be closed, and are at present
    Vec2 mWay = Vec2::Zero();        //!< that the handles have gone
    quint64 mGesture = 0;

    std::vector<int> mShutting; //!< corner pairs that the drag before joined and that are still apart
    int mPatience = 0;          //!< results to wait for them
};

} // namespace autocuts
