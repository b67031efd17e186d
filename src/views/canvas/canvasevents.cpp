// Event handlers of Canvas: navigation is tried first, then the tool.
#include "views/canvas/canvas.h"

#include "views/canvas/mapcamera.h"
#include "views/canvas/toolmanager.h"
#include "views/control/session/workspace.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>

#include <cmath>

namespace autocuts {

ToolEvent Canvas::toolEvent(const QMouseEvent &event, bool withPick)
{
    ToolEvent result{*this, event.position(), event.button(), event.buttons(), event.modifiers(), {}};
    if (withPick && mContent.mesh())
        result.pick = pick(event.position());
    return result;
}

// The release event can get lost, for example when a dialog opens during a drag.
void Canvas::endLostGestures(Qt::MouseButtons held)
{
    if (mNavigation != Navigation::None && !held.testFlag(mNavigationButton)) {
        mNavigation = Navigation::None;
        updateCursor();
    }
    if (mToolPressed && held == Qt::NoButton) {
        mToolPressed = false;
        if (mTools.tool())
            mTools.tool()->cancel();
    }
}

void Canvas::mousePressEvent(QMouseEvent *event)
{
    setFocus(Qt::MouseFocusReason);
    endLostGestures(event->buttons() & ~event->button());
    mLastMouse = event->position();
    const NavigationPreset preset = studio().preferences.values().navigation;
    const Navigation navigation = navigationOf(preset, event->button(), event->modifiers());
    if (mNavigation != Navigation::None)
        return;
    if (navigation != Navigation::None && !mToolPressed) {
        mNavigation = navigation;
        mNavigationButton = event->button();
        mNavigationStart = event->position();
        setCursor(navigation == Navigation::Zoom ? Qt::SizeVerCursor : Qt::ClosedHandCursor);
        return;
    }
    const bool toolIsBusy = mToolPressed || (mTools.tool() && mTools.tool()->isBusy());
    mMenuPress.reset();
    if (event->button() == Qt::RightButton && !toolIsBusy) {
        mMenuPress = event->position();
        return;
    }
    if (!mContent.mesh() ||
        (event->button() == Qt::LeftButton && !toolIsBusy && overlayTakes(mLastMouse, true)) ||
        !mTools.mayBegin())
        return;
    mToolPressed = true;
    mTools.tool()->press(toolEvent(*event, true));
}

void Canvas::mouseMoveEvent(QMouseEvent *event)
{
    endLostGestures(event->buttons());
    const QPointF moved = event->position() - mLastMouse;
    mLastMouse = event->position();
    mTools.setMouse(this, mLastMouse);
    if (mNavigation != Navigation::None) {
        navigate(mNavigation, moved, mNavigationStart);
        update();
        return;
    }
    if (!mContent.mesh() || !mTools.tool())
        return;
    if (event->buttons() == Qt::NoButton && !mTools.tool()->isBusy() && overlayTakes(mLastMouse, false)) {
        studio().view.setHover({});
        mTools.tool()->leave();
        return;
    }
    const ToolEvent toTool = toolEvent(*event, mTools.tool()->wantsPicks());
    studio().view.setHover(toTool.pick.hover());
    mTools.tool()->move(toTool);
}

void Canvas::mouseReleaseEvent(QMouseEvent *event)
{
    if (mNavigation != Navigation::None) {
        if (event->button() == mNavigationButton) {
            mNavigation = Navigation::None;
            updateCursor();
        }
        return;
    }
    if (event->button() == Qt::RightButton && mMenuPress) {
        const bool isClick =
            (event->position() - *mMenuPress).manhattanLength() < QApplication::startDragDistance();
        mMenuPress.reset();
        if (isClick && event->modifiers() == Qt::ShiftModifier && mapCamera())
            placeCursor(event->position());
        else if (isClick)
            Q_EMIT menuRequested(event->position());
        return;
    }
    mToolPressed = event->buttons() != Qt::NoButton && mToolPressed;
    if (mContent.mesh() && mTools.tool())
        mTools.tool()->release(toolEvent(*event, true));
}

//! Puts the 2D cursor at a pixel and makes it the pivot.
void Canvas::placeCursor(const QPointF &pixel)
{
    ToolSettings tools = studio().view.tools();
    tools.cursor = mapCamera()->toUv(pixel);
    tools.pivot = Pivot::Cursor;
    studio().view.setTools(tools);
}

void Canvas::mouseDoubleClickEvent(QMouseEvent *event)
{
    const NavigationPreset preset = studio().preferences.values().navigation;
    if (event->button() == Qt::RightButton || !mContent.mesh() || !mTools.tool() ||
        overlayTakes(event->position(), false) ||
        navigationOf(preset, event->button(), event->modifiers()) != Navigation::None) {
        mousePressEvent(event);
        return;
    }
    if (!mTools.mayBegin())
        return;
    mToolPressed = true;
    mTools.tool()->doubleClick(toolEvent(*event, true));
}

void Canvas::contextMenuEvent(QContextMenuEvent *event)
{
    if (event->reason() == QContextMenuEvent::Keyboard)
        Q_EMIT menuRequested(rect().contains(mLastMouse.toPoint()) ? mLastMouse : QRectF(rect()).center());
}

void Canvas::wheelEvent(QWheelEvent *event)
{
    if (mContent.mesh() && mTools.tool() && mTools.tool()->wheel(*event, *this))
        return;
    const QPointF at = event->position();
    const bool touchPad =
        event->device()->type() == QInputDevice::DeviceType::TouchPad && !event->pixelDelta().isNull();
    if (touchPad && !event->modifiers().testFlag(Qt::ControlModifier)) {
        const bool orbit = kind() == Kind::Model && !event->modifiers().testFlag(Qt::ShiftModifier);
        navigate(orbit ? Navigation::Orbit : Navigation::Pan, event->pixelDelta(), at);
    } else {
        // Some platforms report horizontal scrolling while Alt is held.
        const QPoint angle = event->angleDelta();
        zoomAt(wheelZoomFactor(angle.y() != 0 ? angle.y() : angle.x()), at);
    }
    event->accept();
    update();
}

void Canvas::keyPressEvent(QKeyEvent *event)
{
    const NavigationPreset preset = studio().preferences.values().navigation;
    const bool toTool = mContent.mesh() && mTools.tool() && mTools.tool()->wantsKey(*event);
    const NavigationKey key =
        toTool ? NavigationKey::None : navigationKeyOf(preset, event->key(), event->modifiers());
    if (key == NavigationKey::FrameAll)
        frameAll();
    else if (key == NavigationKey::FrameSelection)
        frameSelection();
    else if (!mContent.mesh() || !mTools.tool() || !mTools.tool()->keyPress(*event, *this))
        QOpenGLWidget::keyPressEvent(event);
}

void Canvas::enterEvent(QEnterEvent *event)
{
    // The view under the mouse gets the keyboard focus, but never takes it from a field that is being edited.
    if (qobject_cast<Canvas *>(window()->focusWidget()))
        setFocus(Qt::MouseFocusReason);
    mTools.setMouse(this, event->position()); // it need not move before a key is pressed
    QOpenGLWidget::enterEvent(event);
}

void Canvas::leaveEvent(QEvent *event)
{
    mTools.setMouse(nullptr, {});
    studio().view.setHover({});
    if (mTools.tool())
        mTools.tool()->leave();
    QOpenGLWidget::leaveEvent(event);
}

bool Canvas::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        // Keys of navigation, keys of the tool, and Escape during a gesture come here instead of triggering
        // actions.
        const auto *key = static_cast<QKeyEvent *>(event);
        const NavigationPreset preset = studio().preferences.values().navigation;
        const AbstractTool *tool = mTools.tool();
        const bool cancels = tool && key->key() == Qt::Key_Escape && tool->isBusy();
        if (cancels || (tool && mContent.mesh() && tool->wantsKey(*key)) ||
            navigationKeyOf(preset, key->key(), key->modifiers()) != NavigationKey::None) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::NativeGesture) {
        const auto *gesture = static_cast<QNativeGestureEvent *>(event);
        if (gesture->gestureType() == Qt::ZoomNativeGesture) {
            zoomAt(std::exp(gesture->value()), gesture->position());
            update();
            return true;
        }
    }
    return QOpenGLWidget::event(event);
}

} // namespace autocuts
