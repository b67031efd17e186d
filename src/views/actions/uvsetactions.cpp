#include "views/actions/uvsetactions.h"

#include "commands/edituvsets.h"
#include "views/actions/actionregistry.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/jobs/uvsetediting.h"

#include <QAction>

namespace autocuts {

UvSetActions::UvSetActions(const StudioContext &context, QObject *parent) : QObject(parent), mContext(context)
{
    connectCommand("uvset.add",
                   [](Document &document) { return std::make_unique<AddUvSet>(document, QString()); });
    connectCommand("uvset.copy", [](Document &document) {
        const int active = document.activeUvSet();
        return std::make_unique<AddUvSet>(document, document.uvSets()[active].name, active);
    });
    connectCommand("uvset.delete", [](Document &document) {
        return std::make_unique<DeleteUvSet>(document, document.activeUvSet());
    });
    connectCommand("uvset.next", [](Document &document) {
        const int count = static_cast<int>(document.uvSets().size());
        return std::make_unique<ChooseUvSet>(document, (document.activeUvSet() + 1) % count);
    });
    connect(context.actions.action("uvset.lightmap"), &QAction::triggered, this,
            [this] { mContext.map.addLightmapSet(); });
}

void UvSetActions::connectCommand(const char *id, const Maker &make)
{
    connect(mContext.actions.action(id), &QAction::triggered, this,
            [this, make] { editUvSets(mContext, make); });
}

} // namespace autocuts
