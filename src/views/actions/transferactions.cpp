#include "views/actions/transferactions.h"

#include "views/actions/actionregistry.h"
#include "views/actions/fileactions.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/transferdialog.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"

#include <QAction>

namespace autocuts {

TransferActions::TransferActions(const StudioContext &context, Questions &questions, QObject *parent)
    : QObject(parent), mContext(context), mQuestions(questions)
{
    connect(context.actions.action("uv.transfer"), &QAction::triggered, this, [this] {
        if (const Document *document = mContext.workspace.document())
            ask(*document);
    });
}

void TransferActions::ask(const Document &document)
{
    TransferDialog dialog(document, mChoice, mContext.preferences.lastFolder(), openFilters(), mQuestions);
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    mChoice = dialog.choice();
    mContext.map.transferUvs(mChoice);
}

} // namespace autocuts
