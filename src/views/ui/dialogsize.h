// Sizes of dialogs that fit on the screen.
#pragma once

#include <QSize>

class QWidget;

namespace autocuts {

//! Gives a window its first size, less where its screen has no room for it and its frame.
void resizeOnScreen(QWidget &window, const QSize &wanted);

} // namespace autocuts
