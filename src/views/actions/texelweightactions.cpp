#include "views/actions/texelweightactions.h"

#include "commands/reset.h"
#include "commands/settexelweights.h"
#include "model/plain/texelweights.h"
#include "views/actions/actionregistry.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/numberdialog.h"
#include "views/ui/questions.h"

#include <QAction>

#include <functional>

namespace autocuts {

namespace {

std::unique_ptr<SetTexelWeights> weightOfSelection(Document &document, double weight)
{
    const QList<int> &faces = document.selection().faces;
    return SetTexelWeights::uniform(
        document, IndexRanges::fromSorted(std::vector<int>(faces.begin(), faces.end())), weight);
}

} // namespace

TexelWeightActions::TexelWeightActions(const StudioContext &context, Questions &questions, QObject *parent)
    : QObject(parent), mContext(context), mQuestions(questions)
{
    const auto onTriggered = [this](const char *id, const std::function<void(Document &)> &function) {
        connect(mContext.actions.action(id), &QAction::triggered, this, [this, function] {
            if (Document *document = mContext.workspace.document())
                function(*document);
        });
    };
    onTriggered("uv.texelWeight", [this](Document &document) { ask(document); });
    onTriggered("uv.clearTexelWeight", [](Document &d) { pushCommand(weightOfSelection(d, 1)); });
    onTriggered("uv.clearTexelWeights",
                [](Document &d) { pushCommand(std::make_unique<Reset>(d, Reset::TexelWeights)); });
}

void TexelWeightActions::ask(Document &document)
{
    const QList<int> &faces = document.selection().faces;
    if (faces.isEmpty())
        return;
    const std::vector<double> weights = document.texelWeights();
    const double first = weights[static_cast<std::size_t>(faces.front())];
    NumberDialog dialog({tr("Texel density weight"),
                         tr("How many times the texels per length of other faces, from 1/8 to 8. Unwrap, "
                            "Finish and the live solve aim for it."),
                         tr("&Weight:"), tr(" times"), tr("&Set"), first != 1 ? first : mWeight,
                         minTexelWeight, maxTexelWeight, 3},
                        mQuestions.window());
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    mWeight = dialog.number();
    pushCommand(weightOfSelection(document, mWeight));
}

} // namespace autocuts
