#include "views/tools/studiotools.h"

#include "views/canvas/toolmanager.h"
#include "views/tools/dragtool.h"
#include "views/tools/islandtool.h"
#include "views/tools/packboxtool.h"
#include "views/tools/painttool.h"
#include "views/tools/pintool.h"
#include "views/tools/rectangletool.h"
#include "views/tools/regiontool.h"
#include "views/tools/seamtool.h"
#include "views/tools/selecttool.h"
#include "views/tools/shapetool.h"
#include "views/tools/texeltool.h"

namespace autocuts {

void addStudioTools(ToolManager &tools, const StudioContext &context)
{
    tools.add(std::make_unique<SelectTool>(context, QStringLiteral("select"), SelectShape::Box));
    tools.add(std::make_unique<SelectTool>(context, QStringLiteral("lasso"), SelectShape::Lasso));
    tools.add(std::make_unique<SelectTool>(context, QStringLiteral("selectBrush"), SelectShape::Brush));
    tools.add(std::make_unique<SeamTool>(context, SeamTool::Kind::Cut));
    tools.add(std::make_unique<SeamTool>(context, SeamTool::Kind::Join));
    tools.add(std::make_unique<PaintTool>(context));
    tools.add(std::make_unique<TexelTool>(context));
    tools.add(std::make_unique<RegionTool>(context));
    tools.add(std::make_unique<IslandTool>(context, QStringLiteral("move"), UvEdit::Move));
    tools.add(std::make_unique<IslandTool>(context, QStringLiteral("rotate"), UvEdit::Rotate));
    tools.add(std::make_unique<IslandTool>(context, QStringLiteral("scale"), UvEdit::Scale));
    tools.add(std::make_unique<DragTool>(context));
    tools.add(std::make_unique<ShapeTool>(context, QStringLiteral("relaxBrush"), ShapeBrush::Relax));
    tools.add(std::make_unique<ShapeTool>(context, QStringLiteral("pinchBrush"), ShapeBrush::Pinch));
    tools.add(std::make_unique<ShapeTool>(context, QStringLiteral("grabBrush"), ShapeBrush::Grab));
    tools.add(std::make_unique<PinTool>(context));
    tools.add(std::make_unique<RectangleTool>(context));
    tools.add(std::make_unique<PackBoxTool>(context));
}

} // namespace autocuts
