#include "views/dialogs/densitydialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <cmath>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

DensityDialog::DensityDialog(double present, const PackingSettings &packing, QWidget *parent)
    : QDialog(parent), mDensity(new QDoubleSpinBox)
{
    setWindowTitle(tr("Texel density"));
    mDensity->setObjectName("density"_L1);
    mDensity->setRange(1e-3, 1e9);
    mDensity->setDecimals(3);
    mDensity->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    mDensity->setSuffix(tr(" px/unit"));
    mDensity->setValue(std::isfinite(present) ? present : 512);
    mDensity->setToolTip(tr("Texels per unit of the model"));
    auto *remark = new QLabel(std::isfinite(present)
                                  ? tr("The selection has %1 texels per unit now.").arg(present, 0, 'g', 6)
                                  : tr("The selection has no area."));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    buttons->addButton(tr("&Set"), QDialogButtonBox::AcceptRole)->setDefault(true);
    auto *form = new QFormLayout(this);
    form->addRow(remark);
    form->addRow(tr("&Density:"), mDensity);
    form->addRow(new QLabel(tr("With a texture of %1 \u00d7 %2 texels; locked islands stay.")
                                .arg(packing.textureSize)
                                .arg(packing.height())));
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

double DensityDialog::density() const
{
    return mDensity->value();
}

} // namespace autocuts
