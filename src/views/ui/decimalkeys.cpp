#include "views/ui/decimalkeys.h"

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>

namespace autocuts {

DecimalKeys::DecimalKeys(QObject *parent) : QObject(parent)
{
    qApp->installEventFilter(this);
}

bool DecimalKeys::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress)
        return false;
    const auto &key = static_cast<const QKeyEvent &>(*event);
    if (key.text() != QLatin1String(".") && key.text() != QLatin1String(","))
        return false;
    const auto *field = qobject_cast<const QDoubleSpinBox *>(watched);
    if (!field || key.text() == field->locale().decimalPoint())
        return false;
    QKeyEvent translated(QEvent::KeyPress, key.key(), key.modifiers(), field->locale().decimalPoint());
    QCoreApplication::sendEvent(watched, &translated);
    return true;
}

} // namespace autocuts
