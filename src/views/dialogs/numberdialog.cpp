#include "views/dialogs/numberdialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

NumberDialog::NumberDialog(const NumberQuestion &question, QWidget *parent)
    : QDialog(parent), mNumber(new QDoubleSpinBox)
{
    setWindowTitle(question.title);
    mNumber->setObjectName("number"_L1);
    mNumber->setDecimals(question.decimals);
    mNumber->setRange(question.low, question.high);
    mNumber->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    mNumber->setSuffix(question.suffix);
    mNumber->setValue(question.value);
    mNumber->setToolTip(question.remark);
    mNumber->selectAll();
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(question.action, QDialogButtonBox::AcceptRole)->setDefault(true);
    auto *form = new QFormLayout(this);
    form->addRow(new QLabel(question.remark));
    form->addRow(question.label, mNumber);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

double NumberDialog::number() const
{
    return mNumber->value();
}

} // namespace autocuts
