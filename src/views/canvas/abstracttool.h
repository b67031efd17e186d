// The base class of tools: what the mouse does in the views besides moving the camera.
#pragma once

#include "views/canvas/picking.h"
#include "views/canvas/tooloption.h"
#include "views/control/session/studiocontext.h"

#include <QCursor>
#include <QObject>
#include <QPointF>
#include <QString>
#include <Qt>

#include <vector>

class QKeyEvent;
class QPainter;
class QWheelEvent;

namespace autocuts {

class ToolCanvas;

//! Logical pixels. Shorter mouse movements count as clicks. Chosen by hand.
inline constexpr double dragDistance = 4;

//! A mouse event, with the elements under the mouse in the canvas of the event.
struct ToolEvent
{
    ToolCanvas &canvas;
    QPointF position; //!< logical pixels in the canvas
    Qt::MouseButton button = Qt::NoButton;
    Qt::MouseButtons buttons = Qt::NoButton;
    Qt::KeyboardModifiers modifiers = Qt::NoModifier;
    PickResult pick;
};

//! Base of all tools. A tool holds the state of a gesture, reads the document and pushes commands. It works
//! in both views; a gesture stays in the canvas where it began. Tools get events only while a document is
//! open.
class AbstractTool : public QObject
{
    Q_OBJECT

public:
    AbstractTool(const StudioContext &context, const QString &id, QObject *parent = nullptr)
        : QObject(parent), mContext(context), mId(id)
    {}

    //! The id for ToolManager::setTool().
    const QString &id() const { return mId; }
    //! What the mouse does at the moment: one translated line for the status bar.
    virtual QString hint() const = 0;
    //! Its settings. Their number and kinds never change.
    virtual std::vector<ToolOption> options() { return {}; }
    virtual QCursor cursor() const { return Qt::ArrowCursor; }

    virtual void activate() {}
    virtual void deactivate() { cancel(); }
    //! Called when the user activates the tool while the mouse is over a canvas.
    virtual void chosen(ToolCanvas &, const QPointF &) {}
    virtual void press(const ToolEvent &event) = 0;
    virtual void move(const ToolEvent &event) = 0;
    virtual void release(const ToolEvent &event) = 0;
    virtual void doubleClick(const ToolEvent &event) { press(event); }
    //! True when a gesture changes the map that is shown. The best map of a running job must be let alone.
    virtual bool movesMap() const { return false; }
    //! Called when the mouse leaves the view.
    virtual void leave() {}
    //! \returns true when the tool used the key. Escape ends a gesture.
    virtual bool keyPress(const QKeyEvent &event, ToolCanvas &canvas);
    //! True for keys that are sent to keyPress() instead of triggering an action.
    virtual bool wantsKey(const QKeyEvent &) const { return false; }
    //! \returns true when the tool used the wheel; the camera then ignores it
    virtual bool wheel(const QWheelEvent &, ToolCanvas &) { return false; }

    //! True during a gesture.
    virtual bool isBusy() const { return false; }
    //! Ends the gesture and restores the document as it was before.
    virtual void cancel() {}
    //! False when mouse moves need no picking, for example while a box is dragged.
    virtual bool wantsPicks() const { return true; }
    //! False when the elements that a click would select are not to be highlighted.
    virtual bool marksHover() const { return true; }
    virtual void drawOverlay(QPainter &, const ToolCanvas &) {}

Q_SIGNALS:
    void hintChanged();
    //! Emitted when the result of drawOverlay() changes.
    void overlayChanged();

protected:
    const StudioContext &context() const { return mContext; }

private:
    const StudioContext mContext;
    const QString mId;
};

} // namespace autocuts
