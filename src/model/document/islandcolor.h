// The colours of islands in the views, lists and layout pictures.
#pragma once

#include <QColor>

namespace autocuts {

//! The colour of an island. Hues are spaced by the golden ratio around the colour circle, so that consecutive
//! numbers get different colours; a number always gets the same one. Reds are left out: they mark seams and
//! problems.
QRgb islandColor(int number);

} // namespace autocuts
