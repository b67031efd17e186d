#include "views/shell/tooloptionbar.h"

#include "views/actions/actionregistry.h"
#include "views/canvas/toolmanager.h"
#include "views/state/viewstate.h"
#include "views/ui/inputguard.h"
#include "views/ui/scrublabel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSpinBox>

#include <cmath>

namespace autocuts {

ToolOptionBar::ToolOptionBar(const StudioContext &context, ToolManager &tools, QWidget *parent)
    : QToolBar(tr("Tool options"), parent), mContext(context), mTools(tools)
{
    new InputGuard(this);
    connect(&tools, &ToolManager::toolChanged, this, &ToolOptionBar::build);
    connect(&tools, &ToolManager::hintChanged, this, &ToolOptionBar::refresh);
    connect(&tools, &ToolManager::overlayChanged, this, &ToolOptionBar::refresh);
    connect(&context.view, &ViewState::toolsChanged, this, &ToolOptionBar::refresh);
    build();
}

void ToolOptionBar::build()
{
    clear();
    mFields.clear();
    const QAction *action = mContext.actions.action(("tool." + mTools.tool()->id().toLatin1()).constData());
    auto *box = new QWidget;
    auto *layout = new QHBoxLayout(box);
    layout->setContentsMargins(8, 0, 0, 0);
    layout->setSpacing(4);
    auto *name = new QLabel(actionTitle(mContext.actions.info(action)));
    QFont bold = name->font();
    bold.setBold(true);
    name->setFont(bold);
    layout->addWidget(name);
    for (const ToolOption &option : mTools.tool()->options()) {
        layout->addSpacing(8);
        QWidget *field = makeField(option, mFields.size());
        field->setObjectName(QStringLiteral("toolOption%1").arg(mFields.size()));
        field->setToolTip(option.tip);
        field->setAccessibleName(option.name);
        mFields.push_back(field);
        if (!option.isSwitch) {
            QAbstractSpinBox *number = spinBoxOf(field);
            auto *caption = number ? new ScrubLabel(option.name, number) : new QLabel(option.name);
            caption->setToolTip(option.tip);
            caption->setBuddy(field);
            layout->addWidget(caption);
        }
        layout->addWidget(field);
    }
    layout->addStretch();
    addWidget(box);
    refresh();
}

QWidget *ToolOptionBar::makeField(const ToolOption &option, std::size_t index)
{
    if (option.isSwitch) {
        auto *box = new QCheckBox(option.name);
        connect(box, &QCheckBox::toggled, this, [this, index](bool on) { set(index, on); });
        return box;
    }
    if (!option.choices.isEmpty()) {
        auto *box = new QComboBox;
        box->addItems(option.choices);
        connect(box, &QComboBox::currentIndexChanged, this, [this, index](int item) { set(index, item); });
        return box;
    }
    auto *box = new QSpinBox;
    box->setRange(static_cast<int>(option.minimum), static_cast<int>(option.maximum));
    box->setSuffix(option.suffix);
    box->setKeyboardTracking(false);
    connect(box, &QSpinBox::valueChanged, this, [this, index](int value) { set(index, value); });
    return box;
}

void ToolOptionBar::set(std::size_t index, double value)
{
    if (!mShowing)
        mTools.tool()->options()[index].set(value);
}

void ToolOptionBar::refresh()
{
    const QScopedValueRollback showing(mShowing, true);
    const std::vector<ToolOption> options = mTools.tool()->options();
    for (std::size_t i = 0; i < options.size() && i < mFields.size(); ++i) {
        if (auto *number = qobject_cast<QSpinBox *>(mFields[i]))
            number->setValue(static_cast<int>(std::lround(options[i].value)));
        else if (auto *choice = qobject_cast<QComboBox *>(mFields[i]))
            choice->setCurrentIndex(static_cast<int>(options[i].value));
        else if (auto *box = qobject_cast<QCheckBox *>(mFields[i]))
            box->setChecked(options[i].value != 0);
    }
}

} // namespace autocuts
