#include "views/ui/inputguard.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QChildEvent>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QScrollBar>

namespace autocuts {

namespace {

bool takesWheel(const QObject *object)
{
    return qobject_cast<const QAbstractSpinBox *>(object) || qobject_cast<const QComboBox *>(object) ||
           (qobject_cast<const QAbstractSlider *>(object) && !qobject_cast<const QScrollBar *>(object));
}

//! The editor of an entry of a list ends by keys of its own.
bool isEditorInView(const QObject *object)
{
    const QObject *parent = object->parent();
    return parent && qobject_cast<const QAbstractItemView *>(parent->parent());
}

//! Takes back what was typed and has not become the value.
void forgetTyped(QWidget *field)
{
    if (auto *box = qobject_cast<QSpinBox *>(field))
        box->setValue(box->value());
    else if (auto *numbers = qobject_cast<QDoubleSpinBox *>(field))
        numbers->setValue(numbers->value());
    const auto *combo = qobject_cast<const QComboBox *>(field);
    auto *text = combo ? combo->lineEdit() : qobject_cast<QLineEdit *>(field);
    while (text && text->isUndoAvailable())
        text->undo();
}

void focusTheView(QWidget *field)
{
    const auto *window = qobject_cast<QMainWindow *>(field->window());
    if (window && window->centralWidget())
        window->centralWidget()->setFocus();
    else
        field->clearFocus();
}

bool isOperatedBy(const QObject *object, const QKeyEvent &event)
{
    if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier))
        return false;
    const bool isView = qobject_cast<const QAbstractItemView *>(object);
    switch (event.key()) {
    case Qt::Key_Escape:
        return isField(object);
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        return takesWheel(object) || isView;
    case Qt::Key_Space:
        return qobject_cast<const QAbstractButton *>(object) != nullptr;
    default:
        return false;
    }
}

//! A number field has no use for these keys: they are the program's. E is for powers of ten.
bool isNotForNumbers(const QObject *object, const QKeyEvent &event)
{
    if (!qobject_cast<const QAbstractSpinBox *>(object) || (event.modifiers() & ~Qt::ShiftModifier))
        return false;
    const int key = event.key();
    return key == Qt::Key_Space || (key >= Qt::Key_A && key <= Qt::Key_Z && key != Qt::Key_E);
}

//! Space runs and pauses the solver also while a list has the focus.
bool isNotForLists(const QObject *object, const QKeyEvent &event)
{
    return event.key() == Qt::Key_Space && event.modifiers() == Qt::NoModifier &&
           (qobject_cast<const QAbstractItemView *>(object) || qobject_cast<const QComboBox *>(object)) &&
           !isField(object);
}

} // namespace

bool isField(const QObject *object)
{
    const auto *combo = qobject_cast<const QComboBox *>(object);
    return qobject_cast<const QAbstractSpinBox *>(object) || qobject_cast<const QLineEdit *>(object) ||
           (combo && combo->isEditable());
}

InputGuard::InputGuard(QWidget *root) : QObject(root)
{
    guard(root);
}

bool InputGuard::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::ChildPolished:
        // The child's constructor has run by now, so its type is known.
        guard(static_cast<QChildEvent *>(event)->child());
        break;
    case QEvent::Wheel:
        if (takesWheel(watched) && !static_cast<QWidget *>(watched)->hasFocus()) {
            event->ignore();
            return true;
        }
        break;
    case QEvent::KeyPress:
        if (isField(watched) && !isEditorInView(watched) &&
            leavesField(static_cast<QWidget *>(watched), static_cast<QKeyEvent *>(event)->key()))
            return true;
        break;
    case QEvent::ShortcutOverride:
        if (const auto &key = *static_cast<QKeyEvent *>(event);
            isNotForNumbers(watched, key) || isNotForLists(watched, key)) {
            // What was typed counts for what the key does.
            if (auto *box = qobject_cast<QAbstractSpinBox *>(watched))
                box->interpretText();
            event->ignore();
            return true;
        }
        if (isOperatedBy(watched, *static_cast<QKeyEvent *>(event))) {
            event->accept();
            return true;
        }
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

//! \returns true when the field shall not get the key
bool InputGuard::leavesField(QWidget *field, int key)
{
    if (key == Qt::Key_Escape) {
        forgetTyped(field);
        focusTheView(field);
        return true;
    }
    // The field takes the value over first.
    if (key == Qt::Key_Return || key == Qt::Key_Enter)
        QMetaObject::invokeMethod(
            field, [field] { focusTheView(field); }, Qt::QueuedConnection);
    return false;
}

void InputGuard::guard(QObject *object)
{
    if (!object->isWidgetType())
        return;
    object->installEventFilter(this);
    auto *widget = static_cast<QWidget *>(object);
    if (takesWheel(object))
        widget->setFocusPolicy(Qt::StrongFocus);
    else if (qobject_cast<QAbstractButton *>(object))
        widget->setFocusPolicy(Qt::TabFocus);
    for (QObject *child : object->children())
        guard(child);
}

} // namespace autocuts
