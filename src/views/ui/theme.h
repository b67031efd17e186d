// How the program looks: colours and the shape of widgets, dark or light.
#pragma once

#include "views/ui/preferences.h"

class QApplication;

namespace autocuts {

//! Gives the application a style, a palette and a style sheet; does nothing when they are its
//! present ones.
void applyTheme(QApplication &application, Theme theme);

} // namespace autocuts
