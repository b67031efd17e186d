#include "views/dialogs/presetdialog.h"

#include "views/ui/reasons.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

PresetDialog::PresetDialog(const QStringList &names, QWidget *parent) : QDialog(parent), mName(new QComboBox)
{
    setWindowTitle(tr("Save settings as preset"));
    mName->setObjectName("name"_L1);
    mName->setEditable(true);
    mName->addItems(names);
    mName->clearEditText();
    mName->setToolTip(tr("The name of a new preset, or of one that is replaced"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
    mSave = buttons->button(QDialogButtonBox::Save);
    auto *remark =
        new QLabel(tr("The settings of the panels Unwrap and Packing, for other sessions and for the "
                      "command line: autocuts-cli unwrap --preset NAME"));
    remark->setWordWrap(true);
    auto *form = new QFormLayout(this);
    form->addRow(remark);
    form->addRow(tr("&Name:"), mName);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(mName, &QComboBox::editTextChanged, this, &PresetDialog::enableSave);
    enableSave();
    mName->setFocus();
}

QString PresetDialog::name() const
{
    return mName->currentText().trimmed();
}

void PresetDialog::enableSave()
{
    disableFor(name().isEmpty()        ? tr("Type a name first")
               : name().contains(u'/') ? tr("A name has no slash")
                                       : QString(),
               mSave);
}

} // namespace autocuts
