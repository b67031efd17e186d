// What the mouse does in the views besides moving the camera.
#pragma once

#include "views/canvas/picking.h"
#include "views/control/studiocontext.h"

#include <QCursor>
#include <QObject>
#include <QPointF>
#include <QString>
#include <Qt>

class QKeyEvent;
class QPainter;
class QWheelEvent;

namespace autocuts {

class ToolCanvas;

//! Moves shorter than this are clicks of an unsteady hand, logical pixels.
inline constexpr double dragDistance = 4;

//! A mouse event with what is under the mouse in the canvas that it came from.
struct ToolEvent
{
    ToolCanvas &canvas;
    QPointF position; //!< logical pixels in the canvas
    Qt::MouseButton button = Qt::NoButton;
    Qt::MouseButtons buttons = Qt::NoButton;
    Qt::KeyboardModifiers modifiers = Qt::NoModifier;
    PickResult pick;
};

//! Base of all tools. A tool keeps the state of a gesture, reads the document and pushes commands. It works
//! in both views; a gesture stays in the canvas where it began. Events come only while a document is open.
class AbstractTool : public QObject
{
    Q_OBJECT

public:
    AbstractTool(const StudioContext &context, const QString &id, QObject *parent = nullptr)
        : QObject(parent), mContext(context), mId(id)
    {}

    //! For ToolManager::setTool().
    const QString &id() const { return mId; }
    //! What the mouse does now, translated, one line for the status bar.
    virtual QString hint() const = 0;
    virtual QCursor cursor() const { return Qt::ArrowCursor; }

    virtual void activate() {}
    virtual void deactivate() { cancel(); }
    //! The user chose the tool, which is active, while the mouse is over a canvas.
    virtual void chosen(ToolCanvas &, const QPointF &) {}
    virtual void press(const ToolEvent &event) = 0;
    virtual void move(const ToolEvent &event) = 0;
    virtual void release(const ToolEvent &event) = 0;
    virtual void doubleClick(const ToolEvent &event) { press(event); }
    //! The mouse left the view.
    virtual void leave() {}
    //! \returns true when the key was for the tool. Escape ends a gesture.
    virtual bool keyPress(const QKeyEvent &event, ToolCanvas &canvas);
    //! Keys that come to keyPress() and not to the action that has them.
    virtual bool wantsKey(const QKeyEvent &) const { return false; }
    //! \returns true when the wheel was for the tool and not for the camera
    virtual bool wheel(const QWheelEvent &, ToolCanvas &) { return false; }

    //! A gesture is under way.
    virtual bool isBusy() const { return false; }
    //! Ends the gesture and leaves the document as it was before it.
    virtual void cancel() {}
    //! False when mouse moves need no pick, as while a box is dragged.
    virtual bool wantsPicks() const { return true; }
    //! False when what a click would select is not to be marked under the mouse.
    virtual bool marksHover() const { return true; }
    virtual void drawOverlay(QPainter &, const ToolCanvas &) {}

Q_SIGNALS:
    void hintChanged();
    //! What drawOverlay() draws.
    void overlayChanged();

protected:
    const StudioContext &context() const { return mContext; }

private:
    const StudioContext mContext;
    const QString mId;
};

} // namespace autocuts
