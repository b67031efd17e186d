#include "views/gl/viewcolors.h"

#include "views/ui/preferences.h"

namespace autocuts {

namespace {

void setTheme(ViewColors &colors)
{
    const bool dark = colors.dark;
    const auto choose = [dark](QRgb ofDark, QRgb ofLight) {
        return QColor::fromRgba(dark ? ofDark : ofLight);
    };
    colors.backgroundTop = choose(0xff3b3f46, 0xffe9edf2);
    colors.backgroundBottom = choose(0xff1e2023, 0xffb9c1cb);
    colors.mapBackground = choose(0xff222427, 0xffd3d7dc);
    colors.mapInside = choose(0xff2b2e32, 0xffeef0f3);
    colors.gridMinor = choose(0x14ffffff, 0x14000000);
    colors.gridMajor = choose(0x2affffff, 0x2c000000);
    colors.text = choose(0xffe4e6e9, 0xff202327);
    colors.dimText = choose(0xffa3a8af, 0xff565c64);
    colors.panel = choose(0xd81b1d20, 0xd8f4f6f8);
    colors.model = choose(0xffb4b9c0, 0xffc9ced5);
    colors.mapFill = choose(0xff7c93b0, 0xff8aa6c8);
    colors.hover = choose(0xffffe08a, 0xff00939c);
    colors.sides[static_cast<int>(SideStyle::Wire)] = choose(0x90101215, 0x80202428);
    colors.sides[static_cast<int>(SideStyle::Border)] = choose(0xf0e8ebef, 0xf0202428);
}

} // namespace

ViewColors ViewColors::of(const PreferenceValues &preferences, bool map)
{
    ViewColors colors;
    colors.dark = preferences.theme == Theme::Dark;
    setTheme(colors);
    if (map && colors.dark)
        colors.sides[static_cast<int>(SideStyle::Wire)] = QColor(200, 210, 222, 90);
    colors.selection = preferences.selectionColor;
    colors.flipped = QColor(0xb01fd6);
    colors.overlap = QColor(0xff2fb3);
    colors.hardPin = QColor(0x2fbf4f);
    colors.softPin = QColor(0x8fdc9f);
    colors.axes = {QColor(0xe2504a), QColor(0x6fb53c), QColor(0x3f87e0)};
    colors.sides[static_cast<int>(SideStyle::None)] = Qt::transparent;
    colors.sides[static_cast<int>(SideStyle::Seam)] = preferences.seamColor;
    colors.sides[static_cast<int>(SideStyle::ForcedCut)] = preferences.forcedCutColor;
    colors.sides[static_cast<int>(SideStyle::Joined)] = preferences.joinedColor;
    colors.sides[static_cast<int>(SideStyle::Selected)] = preferences.selectionColor;
    colors.sides[static_cast<int>(SideStyle::Given)] = QColor(0x1fb8e0);
    colors.sides[static_cast<int>(SideStyle::Straight)] = QColor(0xb8e02a);
    colors.sideWidths = {0, 1, 1.4f, 2.6f, 3.2f, 3.2f, 3.4f, 2.8f, 6};
    return colors;
}

} // namespace autocuts
