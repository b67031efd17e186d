// Widgets that cannot be used say why.
#pragma once

#include <QString>

class QWidget;

namespace autocuts {

//! Enables a widget, or disables it and says why below its tooltip.
void enableOrSay(QWidget *widget, bool enabled, const QString &why);
//! Disables a widget for as long as there is a problem, which its tooltip says.
void disableFor(const QString &problem, QWidget *widget);

} // namespace autocuts
