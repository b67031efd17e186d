// The colours and line widths of both views, for each theme and the preferences.
#pragma once

#include <QColor>

#include <array>

namespace autocuts {

struct PreferenceValues;

//! What is drawn along a side of a triangle.
enum class SideStyle : quint8 {
    None,
    Wire,
    Border,
    Seam,
    ForcedCut,
    Joined,
    Selected,
    Given,
    Straight,
    Count
};

//! The colours of one theme. Widths are in logical pixels.
struct ViewColors
{
    //! \param map true for the UV view, where lines are drawn on a darker background
    static ViewColors of(const PreferenceValues &preferences, bool map);

    bool dark = true;
    QColor backgroundTop, backgroundBottom; //!< of the 3D view
    QColor mapBackground;                   //!< of the UV view, between the grid lines
    QColor mapInside;                       //!< of the tiles in use in the UV view
    QColor gridMinor, gridMajor;
    QColor text, dimText, panel; //!< panel: background of rulers and legends
    QColor model;                //!< of faces without another colour
    QColor mapFill;              //!< of islands without another colour
    QColor selection, hover;
    QColor flipped, overlap;
    QColor hardPin, softPin;
    std::array<QColor, 3> axes;
    std::array<QColor, static_cast<int>(SideStyle::Count)> sides;
    std::array<float, static_cast<int>(SideStyle::Count)> sideWidths; //!< total width of each kind of line
};

} // namespace autocuts
