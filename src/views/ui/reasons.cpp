#include "views/ui/reasons.h"

#include <QVariant>
#include <QWidget>

namespace autocuts {

void enableOrSay(QWidget *widget, bool enabled, const QString &why)
{
    static constexpr auto said = "autocutsWhyDisabled";
    QString tip = widget->toolTip();
    if (const QString before = widget->property(said).toString(); !before.isEmpty() && tip.endsWith(before))
        tip.chop(before.size());
    QString reason = enabled ? QString() : tip.isEmpty() ? why : QLatin1Char('\n') + why;
    if (tip.endsWith(reason)) // as Panel::explain() said already
        reason.clear();
    widget->setProperty(said, reason);
    widget->setToolTip(tip + reason);
    widget->setEnabled(enabled);
}

void disableFor(const QString &problem, QWidget *widget)
{
    enableOrSay(widget, problem.isEmpty(), problem);
}

} // namespace autocuts
