#include "views/actions/hideactions.h"

#include "commands/hidefaces.h"
#include "views/actions/actionregistry.h"
#include "views/control/session/workspace.h"
#include "views/selecting/selecting.h"

namespace autocuts {

HideActions::HideActions(const StudioContext &context, QObject *parent) : QObject(parent), mContext(context)
{
    const auto onTriggered = [this](const char *id, auto function) {
        connect(mContext.actions.action(id), &QAction::triggered, this, [this, function] {
            if (mContext.workspace.document())
                (this->*function)();
        });
    };
    onTriggered("view.hide", &HideActions::hide);
    onTriggered("view.hideOthers", &HideActions::hideOthers);
    onTriggered("view.showAll", &HideActions::showAll);
}

void HideActions::hide()
{
    Document &document = *mContext.workspace.document();
    pushCommand(HideFaces::change(document, facesOf(document, document.selection()), true));
}

void HideActions::hideOthers()
{
    Document &document = *mContext.workspace.document();
    pushCommand(HideFaces::others(document, facesOf(document, document.selection())));
}

//! As in Blender, what comes back is selected.
void HideActions::showAll()
{
    Document &document = *mContext.workspace.document();
    const QList<int> faces = document.state().hiddenFaces;
    if (pushCommand(std::make_unique<HideFaces>(document, QList<int>())))
        document.setSelection(selectionOf(document, faces, document.selection().mode));
}

} // namespace autocuts
