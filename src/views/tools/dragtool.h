// The tool that drags parts of the map.
#pragma once

#include "views/canvas/abstracttool.h"
#include "views/tools/dragreach.h"

#include <QPointer>

namespace autocuts {

class ToolCanvas;
struct UvEditExtras;

//! Drags vertices, edges, faces or islands of the map, by the selection mode (paper, section 4, "Assisted
//! cutting"). Corners inside the circle follow, others stay. While a solve runs, dragged corners are pulled
//! by springs: the map deforms or, where that has the lower energy, tears; tears are stored as cuts. Without
//! a solve, corners are moved directly, but only as far as no triangle flips. Corners near their partners
//! across a seam snap to them and are joined. A definite map that is pulled past what it can stretch tears:
//! what is in the circle comes off by the shortest seam and moves with the mouse from then on (paper,
//! "tear-up gesture"). A click selects. Locked islands and pinned corners stay.
class DragTool final : public AbstractTool
{
    Q_OBJECT

public:
    explicit DragTool(const StudioContext &context, QObject *parent = nullptr);

    //! Radius of the circle in logical pixels.
    double radius() const { return mRadius; }

    QString hint() const override;
    std::vector<ToolOption> options() override;
    bool movesMap() const override { return true; }
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
        int pair = 0, corner = 0, partner = 0; //!< the dragged soup corner and its partner across the seam
        double width = 0;                      //!< at the beginning of the drag, in pixels
    };

    void setRadius(double radius);
    bool reachesAround() const;
    void begin();
    void updateReach();
    void findGaps();
    void apply();
    //! Changes the displacement so that it closes a gap that is nearly closed. \returns the gaps that it
    //! closes
    std::vector<Gap> snap(Vec2 &way) const;
    Vec2 wayThatCloses(const Gap &gap) const;
    void pull(const Vec2 &way);
    void moveCorners(const Vec2 &way);
    void pushUvs(const UvMatrix &uv, const UvEditExtras &extras);
    bool tearsAt(double strain, double resistance = 0);
    void tearLive();
    void setStrained(bool strained);
    //! Takes the part of the circle off. \returns false when it holds
    bool tear();
    void closeGaps(UvMatrix &ways) const;
    //! Stores the seams that the solver opened or closed during the drag as cuts or joins.
    void keepSeams();
    //! Removes the pulls when the joined gaps are closed; earlier, the springs of the joined pairs would be
    //! too far apart to close them.
    void letGoWhenShut();
    void letGo();
    void select(const ToolEvent &event);
    void reset();
    void drawDrag(QPainter &painter, const ToolCanvas &view) const;

    State mState = State::Idle;
    double mRadius = 120;
    QPointer<ToolCanvas> mView; //!< under the mouse, or where the gesture began
    QPointF mStart, mMouse;
    PickResult mPick; //!< of the press

    // State of the drag.
    bool mLive = false;             //!< a solve runs
    UvMatrix mUv;                   //!< UVs of the soup corners at its beginning
    UvMatrix mCornerUv;             //!< UVs of the document's corners at its beginning
    std::vector<float> mSeparation; //!< of the corner pairs at its beginning
    std::vector<int> mHandles;      //!< soup corners
    DragReach mReach;
    std::vector<Gap> mGaps, mClosed; //!< gaps that could be closed, and those that are closed now
    Vec2 mWay = Vec2::Zero();        //!< displacement of the handles
    bool mStrained = false;          //!< it would tear soon
    std::vector<int> mTorn;          //!< edge pairs along which a part came off
    quint64 mGesture = 0;

    std::vector<int> mShutting; //!< corner pairs that the previous drag joined and that are still open
    int mPatience = 0;          //!< number of solver results to wait for them
};

} // namespace autocuts
