// The tools that shape the map with a brush.
#pragma once

#include "views/canvas/abstracttool.h"
#include "views/tools/brush.h"
#include "views/tools/mapspot.h"

#include <QPointer>

#include <QTimer>

#include <memory>

namespace autocuts {

class BrushStroke;
class ToolCanvas;

//! What a stroke does to the part of an island under the brush.
enum class ShapeBrush {
    Relax, //!< lowers the distortion
    Pinch, //!< draws together; with Ctrl apart
    Grab   //!< moves along with the mouse
};

//! Shapes the map in either view, inside one island at a time. Shift relaxes with each of the brushes.
//! Nothing turns over and nothing comes to lie on anything; locked islands and pins stay. One stroke is one
//! undo entry. A live solve is paused first.
class ShapeTool final : public AbstractTool
{
    Q_OBJECT

public:
    ShapeTool(const StudioContext &context, const QString &id, ShapeBrush kind, QObject *parent = nullptr);
    ~ShapeTool() override;

    const Brush &brush() const { return mBrush; }

    QString hint() const override;
    std::vector<ToolOption> options() override;
    bool movesMap() const override { return true; }
    QCursor cursor() const override { return Qt::CrossCursor; }
    void deactivate() override;
    void press(const ToolEvent &event) override;
    void move(const ToolEvent &event) override;
    void release(const ToolEvent &event) override;
    void leave() override;
    bool wheel(const QWheelEvent &event, ToolCanvas &canvas) override;
    bool isBusy() const override { return mState != State::Idle; }
    void cancel() override;
    bool marksHover() const override { return false; }
    void drawOverlay(QPainter &painter, const ToolCanvas &canvas) override;

private:
    //! Waiting: until the solver has put its map into the document.
    enum class State { Idle, Waiting, Active };

    void start();
    //! Works along the way of the mouse.
    void strokeTo(const QPointF &place, const PickResult &pick);
    bool dab(const MapSpot &spot);
    void push();
    //! Works on under a mouse that is held still.
    void workOn();
    //! Ends the stroke and keeps its result.
    void finish();

    const ShapeBrush mKind;
    Brush mBrush{.radius = 60, .strength = 0.5, .hardness = 0};
    QPointer<ToolCanvas> mCanvas; //!< under the mouse, or where the stroke began
    QPointF mMouse;
    bool mLocked = false; //!< why the last stroke did nothing

    // State of the stroke.
    State mState = State::Idle;
    ShapeBrush mStroke = ShapeBrush::Relax;
    bool mApart = false;
    bool mPushing = false; //!< the change of the map comes from this tool
    int mNumber = 0;       //!< of strokes so far
    QPointF mStart;
    MapSpot mGrabbed;
    std::unique_ptr<BrushStroke> mWork; //!< set while Active
    QTimer mStill{this};                //!< runs while Active
};

} // namespace autocuts
