#include "views/panels/uvsetpanel.h"

#include "commands/edituvsets.h"
#include "views/actions/actionregistry.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/jobs/uvsetediting.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/ui/reasons.h"

#include <QAction>
#include <QListWidget>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

UvSetPanel::UvSetPanel(const StudioContext &context, QWidget *parent)
    : Panel(context, tr("Open a model to see its UV sets."), parent), mList(new QListWidget)
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing);
    mList->setObjectName("uvSets"_L1);
    mList->setAccessibleName(tr("UV sets"));
    mList->setToolTip(tr("The chosen set is shown and edited; a double-click renames it"));
    mList->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    mList->setMinimumHeight(60);
    layout->addWidget(mList, 1);
    auto *row = new QWidget;
    auto *rowLayout = new QHBoxLayout(row);
    rowLayout->setContentsMargins(0, 0, 0, 0);
    rowLayout->setSpacing(2);
    for (const char *id : {"uvset.add", "uvset.copy", "uvset.lightmap", "uvset.delete"}) {
        auto *button = new QToolButton;
        button->setDefaultAction(context.actions.action(id));
        button->setObjectName(QLatin1String(id));
        button->setAutoRaise(true);
        rowLayout->addWidget(button);
    }
    rowLayout->addStretch();
    layout->addWidget(row);

    connect(mList, &QListWidget::currentRowChanged, this, &UvSetPanel::choose);
    connect(mList, &QListWidget::itemChanged, this, [this](const QListWidgetItem *item) { rename(*item); });
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] { refreshSoon(); });
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::UvSet || event.type == ChangeEvent::Type::Model)
            refreshSoon();
    });
    connect(&context.map.jobs(), &JobRunner::busyChanged, this, [this] { refreshSoon(); });
}

void UvSetPanel::choose(int row)
{
    if (mShowing || row < 0)
        return;
    editUvSets(context(), [row](Document &document) { return std::make_unique<ChooseUvSet>(document, row); });
    refreshSoon(); // when it could not be chosen
}

void UvSetPanel::rename(const QListWidgetItem &item)
{
    if (mShowing)
        return;
    const int row = mList->row(&item);
    const QString name = item.text().trimmed();
    if (row < static_cast<int>(document()->uvSets().size()))
        pushCommand(std::make_unique<RenameUvSet>(*document(), row, name));
    refreshSoon(); // a name that is in use is not taken
}

void UvSetPanel::refresh()
{
    const QScopedValueRollback showing(mShowing, true);
    if (!document()) {
        mList->clear();
        return;
    }
    const std::vector<UvSet> &sets = document()->uvSets();
    while (mList->count() > static_cast<int>(sets.size()))
        delete mList->takeItem(mList->count() - 1);
    for (int i = 0; i < static_cast<int>(sets.size()); ++i) {
        if (i == mList->count()) {
            mList->addItem(QString());
            mList->item(i)->setFlags(mList->item(i)->flags() | Qt::ItemIsEditable);
        }
        mList->item(i)->setText(sets[static_cast<std::size_t>(i)].name);
    }
    mList->setCurrentRow(document()->activeUvSet());
    enableOrSay(mList, !context().map.jobs().isBusy(),
                tr("A job is running: wait for its end, or cancel it"));
}

} // namespace autocuts
