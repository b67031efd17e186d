// Sizes of dialogs that fit on the screen.
#pragma once

#include <QSize>

class QLayout;
class QWidget;

namespace autocuts {

//! Gives a window its first size, less where its screen has no room for it and its frame.
void resizeOnScreen(QWidget &window, const QSize &wanted);
//! Gives a window the size that its widgets want, as far as the screen has room.
void resizeToContent(QWidget &window);

//! A widget with a layout that is scrolled where the window has no room for it.
[[nodiscard]] QWidget *scrolled(QLayout *layout);

} // namespace autocuts
