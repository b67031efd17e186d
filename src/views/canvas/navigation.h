// Mouse buttons and keys that move the cameras, for each preset in the preferences.
#pragma once

#include "views/ui/preferences.h"

#include <Qt>

namespace autocuts {

enum class Navigation { None, Orbit, Pan, Zoom };

//! The navigation by dragging with a mouse button. Blender: the middle button orbits, with Shift it pans,
//! with Ctrl it zooms. Maya: with Alt, the left button orbits, the middle one pans and the right one zooms.
Navigation navigationOf(NavigationPreset preset, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

//! What a key does to the camera.
enum class NavigationKey { None, FrameAll, FrameSelection };

//! Blender: Home frames everything, the period key of the numeric pad the selection. Maya: A frames
//! everything, F the selection.
NavigationKey navigationKeyOf(NavigationPreset preset, int key, Qt::KeyboardModifiers modifiers);

//! Zoom factor of a drag. \param pixels up or to the right zooms in
double dragZoomFactor(double pixels);
//! Zoom factor of the mouse wheel. \param angle in eighths of a degree, as in QWheelEvent
double wheelZoomFactor(double angle);

} // namespace autocuts
