#include "views/tools/layoutchoices.h"

#include "views/state/viewstate.h"

#include <QCoreApplication>

namespace autocuts {

namespace {

struct LayoutChoices
{
    Q_DECLARE_TR_FUNCTIONS(LayoutChoices)
};

} // namespace

ToolOption pivotChoice(ViewState &view)
{
    return ToolOption::choice(LayoutChoices::tr("Pivot"),
                              LayoutChoices::tr("The point about which islands are turned and scaled"),
                              int(view.tools().pivot),
                              {LayoutChoices::tr("Centre of the box"), LayoutChoices::tr("Lower left corner"),
                               LayoutChoices::tr("2D cursor"), LayoutChoices::tr("Each island its own")},
                              [&view](double index) {
                                  ToolSettings tools = view.tools();
                                  tools.pivot = Pivot(static_cast<int>(index));
                                  view.setTools(tools);
                              });
}

ToolOption snapChoice(ViewState &view)
{
    return ToolOption::choice(
        LayoutChoices::tr("Snap to"),
        LayoutChoices::tr("What a move snaps to without keys; Ctrl, Shift and Alt ask for something else"),
        int(view.tools().snap),
        {LayoutChoices::tr("Nothing"), LayoutChoices::tr("Other islands"), LayoutChoices::tr("Grid"),
         LayoutChoices::tr("Texels"), LayoutChoices::tr("Tiles")},
        [&view](double index) {
            ToolSettings tools = view.tools();
            tools.snap = SnapTo(static_cast<int>(index));
            view.setTools(tools);
        });
}

ToolOption unitChoice(ViewState &view)
{
    return ToolOption::choice(
        LayoutChoices::tr("In"),
        LayoutChoices::tr("Unit of lengths that are shown here and typed during a move; texels are those of "
                          "the texture size of the Packing panel"),
        int(view.tools().unit), {LayoutChoices::tr("UV units"), LayoutChoices::tr("Texels")},
        [&view](double index) {
            ToolSettings tools = view.tools();
            tools.unit = LengthUnit(static_cast<int>(index));
            view.setTools(tools);
        });
}

Vec2 unitsPerLength(LengthUnit unit, const PackingSettings &packing)
{
    return unit == LengthUnit::Texels ? Vec2(Vec2::Constant(packing.textureSize))
                                      : Vec2(1, 1 / packing.tileHeight());
}

} // namespace autocuts
