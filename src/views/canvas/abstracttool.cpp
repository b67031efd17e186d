#include "views/canvas/abstracttool.h"

#include <QKeyEvent>

namespace autocuts {

bool AbstractTool::keyPress(const QKeyEvent &event, ToolCanvas &)
{
    if (event.key() != Qt::Key_Escape || !isBusy())
        return false;
    cancel();
    return true;
}

} // namespace autocuts
