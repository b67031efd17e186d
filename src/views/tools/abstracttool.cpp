#include "views/tools/abstracttool.h"

#include <QKeyEvent>

namespace autocuts {

bool AbstractTool::keyPress(const QKeyEvent &event, Canvas &)
{
    if (event.key() != Qt::Key_Escape || !isBusy())
        return false;
    cancel();
    return true;
}

} // namespace autocuts
