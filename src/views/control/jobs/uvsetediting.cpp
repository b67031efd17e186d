#include "views/control/jobs/uvsetediting.h"

#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"

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
