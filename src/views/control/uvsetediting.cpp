#include "views/control/uvsetediting.h"

#include "views/control/mapcontroller.h"
#include "views/control/solvercontroller.h"
#include "views/control/workspace.h"

namespace autocuts {

void editUvSets(const StudioContext &context,
                const std::function<std::unique_ptr<DocumentCommand>(Document &)> &make)
{
    context.solver.whenPaused([context, make] {
        Document *document = context.workspace.document();
        if (document && !context.map.jobs().isBusy())
            pushCommand(make(*document));
    });
}

} // namespace autocuts
