#include "views/actions/keyfield.h"

#include <QKeyEvent>

namespace autocuts {

namespace {

bool isModifier(int key)
{
    switch (key) {
    case Qt::Key_Shift:
    case Qt::Key_Control:
    case Qt::Key_Alt:
    case Qt::Key_AltGr:
    case Qt::Key_Meta:
    case Qt::Key_CapsLock:
    case Qt::Key_NumLock:
    case Qt::Key_unknown:
    case 0:
        return true;
    default:
        return false;
    }
}

//! Shift is left out where it only produces the character: "?" instead of "Shift+?".
QKeySequence sequenceOf(const QKeyEvent &event)
{
    Qt::KeyboardModifiers modifiers = event.modifiers();
    int key = event.key();
    if (key == Qt::Key_Backtab)
        key = Qt::Key_Tab;
    const bool symbol = key > Qt::Key_Space && key < Qt::Key_AsciiTilde && !QChar(key).isLetterOrNumber();
    if (symbol)
        modifiers &= ~Qt::ShiftModifier;
    return QKeySequence(QKeyCombination(modifiers, Qt::Key(key)));
}

} // namespace

KeyField::KeyField(QWidget *parent) : QLineEdit(parent)
{
    setReadOnly(true);
    setContextMenuPolicy(Qt::NoContextMenu);
}

void KeyField::setKeys(const QString &text)
{
    mKeys = text;
    stopRecording();
}

void KeyField::startRecording()
{
    if (!isEnabled())
        return;
    mRecording = true;
    setFocus();
    setText(tr("Press a key..."));
}

void KeyField::stopRecording()
{
    mRecording = false;
    setText(mKeys.isEmpty() ? tr("None") : mKeys);
}

//! While recording, keys must not trigger shortcuts, dialog buttons or the tab order.
bool KeyField::event(QEvent *event)
{
    if (mRecording && event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (mRecording && event->type() == QEvent::KeyPress) {
        keyPressEvent(static_cast<QKeyEvent *>(event));
        return true;
    }
    return QLineEdit::event(event);
}

void KeyField::keyPressEvent(QKeyEvent *event)
{
    if (!mRecording) {
        if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Select)
            startRecording();
        else
            QLineEdit::keyPressEvent(event);
        return;
    }
    event->accept();
    if (isModifier(event->key()))
        return;
    stopRecording();
    if (event->key() != Qt::Key_Escape || event->modifiers() != Qt::NoModifier)
        Q_EMIT recorded(sequenceOf(*event));
}

void KeyField::mousePressEvent(QMouseEvent *)
{
    startRecording();
}

void KeyField::focusOutEvent(QFocusEvent *event)
{
    if (mRecording)
        stopRecording();
    QLineEdit::focusOutEvent(event);
}

} // namespace autocuts
