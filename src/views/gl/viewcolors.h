// The colours and line widths of both views, by theme and preferences.
#pragma once

#include <QColor>

#include <array>

namespace autocuts {

struct PreferenceValues;

//! What is drawn along a side of a triangle.
enum class SideStyle : quint8 { None, Wire, Border, Seam, ForcedCut, Joined, Selected, Count };

//! Colours of one theme. Widths are in logical pixels.
struct ViewColors
{
    //! \param map for the UV view, where lines lie on a darker ground
    static ViewColors of(const PreferenceValues &preferences, bool map);

    bool dark = true;
    QColor backgroundTop, backgroundBottom; //!< of the 3D view
    QColor mapBackground;                   //!< of the UV view, between the lines of the grid
    QColor mapInside;                       //!< of the unit square
    QColor gridMinor, gridMajor;
    QColor text, dimText, panel; //!< panel: behind rulers and legends
    QColor model;                //!< faces without another colour
    QColor mapFill;              //!< islands without another colour
    QColor selection, hover;
    QColor flipped, overlap;
    QColor hardPin, softPin;
    std::array<QColor, 3> axes;
    std::array<QColor, static_cast<int>(SideStyle::Count)> sides;
    std::array<float, static_cast<int>(SideStyle::Count)> sideWidths; //!< of the whole line
};

} // namespace autocuts
