// The dark and light themes: colours and the style of widgets.
#pragma once

#include "views/ui/preferences.h"

class QApplication;

namespace autocuts {

//! Sets the style, palette and style sheet of the application; does nothing when they are current.
void applyTheme(QApplication &application, Theme theme);

} // namespace autocuts
