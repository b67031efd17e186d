// How the mouse and the keys move the cameras, by the preset of the preferences.
#pragma once

#include "views/ui/preferences.h"

#include <Qt>

namespace autocuts {

enum class Navigation { None, Orbit, Pan, Zoom };

//! What dragging with a button does. Blender: the middle button orbits, with Shift it pans, with Ctrl it
//! zooms. Maya: with Alt the left button orbits, the middle one pans and the right one zooms.
Navigation navigationOf(NavigationPreset preset, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

//! What a key does to the camera.
enum class NavigationKey { None, FrameAll, FrameSelection, Front, Side, Top, ToggleOrthographic };

//! Blender: Home and the . of the numeric pad frame all and the selection, 1, 3, 7 and 5 there turn the
//! camera. Maya: A and F frame all and the selection.
NavigationKey navigationKeyOf(NavigationPreset preset, int key, Qt::KeyboardModifiers modifiers);

//! Factor of a zoom by dragging. \param pixels to the right and up comes nearer
double dragZoomFactor(double pixels);
//! Factor of a turn of the wheel. \param angle eighths of a degree, as QWheelEvent has it
double wheelZoomFactor(double angle);

} // namespace autocuts
