#include "views/actions/bakeactions.h"

#include "views/actions/actionregistry.h"
#include "views/actions/fileactions.h"
#include "views/control/mapcontroller.h"
#include "views/control/workspace.h"
#include "views/dialogs/bakedialog.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"

#include <QAction>
#include <QFileInfo>

namespace autocuts {

BakeActions::BakeActions(const StudioContext &context, Questions &questions, QObject *parent)
    : QObject(parent), mContext(context), mQuestions(questions)
{
    connect(context.actions.action("uv.bake"), &QAction::triggered, this, [this] {
        if (const Document *document = mContext.workspace.document())
            ask(*document);
    });
}

void BakeActions::ask(const Document &document)
{
    if (mChoice.folder.isEmpty()) {
        const QString &model = document.state().scene.path;
        mChoice.folder = model.isEmpty() ? mContext.preferences.lastFolder() : QFileInfo(model).path();
    }
    BakeDialog dialog(document, mChoice, openFilters(), mQuestions);
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    mChoice = dialog.choice();
    mContext.map.bake(mChoice);
}

} // namespace autocuts
