#include "views/canvas/navigation.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

Navigation navigationOf(NavigationPreset preset, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    if (preset == NavigationPreset::Maya) {
        if (!modifiers.testFlag(Qt::AltModifier))
            return Navigation::None;
        switch (button) {
        case Qt::LeftButton:
            return Navigation::Orbit;
        case Qt::MiddleButton:
            return Navigation::Pan;
        case Qt::RightButton:
            return Navigation::Zoom;
        default:
            return Navigation::None;
        }
    }
    if (button != Qt::MiddleButton)
        return Navigation::None;
    if (modifiers.testFlag(Qt::ShiftModifier))
        return Navigation::Pan;
    return modifiers.testFlag(Qt::ControlModifier) ? Navigation::Zoom : Navigation::Orbit;
}

NavigationKey navigationKeyOf(NavigationPreset preset, int key, Qt::KeyboardModifiers modifiers)
{
    const bool keypad = modifiers.testFlag(Qt::KeypadModifier);
    if ((modifiers & ~Qt::KeypadModifier) != Qt::NoModifier)
        return NavigationKey::None;
    if (preset == NavigationPreset::Maya) {
        if (keypad)
            return NavigationKey::None;
        return key == Qt::Key_A   ? NavigationKey::FrameAll
               : key == Qt::Key_F ? NavigationKey::FrameSelection
                                  : NavigationKey::None;
    }
    if (key == Qt::Key_Home)
        return NavigationKey::FrameAll;
    if (!keypad)
        return NavigationKey::None;
    switch (key) {
    case Qt::Key_Period:
    case Qt::Key_Comma: // the period key of the numeric pad on many European keyboards
    case Qt::Key_Delete:
        return NavigationKey::FrameSelection;
    default:
        return NavigationKey::None;
    }
}

double dragZoomFactor(double pixels)
{
    return std::exp(0.006 * std::clamp(pixels, -500.0, 500.0));
}

double wheelZoomFactor(double angle)
{
    return std::exp(0.0015 * std::clamp(angle, -1200.0, 1200.0));
}

} // namespace autocuts
