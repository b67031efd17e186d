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
    : QDialog(parent), mPacking(packing), mDensity(new QDoubleSpinBox), mRemark(new QLabel),
      mTexture(new QLabel)
{
    setWindowTitle(tr("Texel density"));
    mDensity->setObjectName("density"_L1);
    mDensity->setRange(1e-3, 1e9);
    mDensity->setDecimals(3);
    mDensity->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    mDensity->setSuffix(tr(" px/unit"));
    mDensity->setValue(std::isfinite(present) ? present : 512);
    mDensity->setToolTip(tr("Texels per unit of the model"));
    mRemark->setText(std::isfinite(present)
                         ? tr("The islands have %1 texels per unit now.").arg(present, 0, 'g', 6)
                         : tr("The islands have no area."));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    mSet = buttons->addButton(tr("&Set"), QDialogButtonBox::AcceptRole);
    mSet->setDefault(true);
    auto *form = new QFormLayout(this);
    form->addRow(mRemark);
    form->addRow(tr("&Density:"), mDensity);
    mTexture->setObjectName("texture"_L1);
    mTexture->setText(tr("With a texture of %1 \u00d7 %2 texels; locked islands stay.")
                          .arg(packing.textureSize)
                          .arg(packing.height()));
    form->addRow(mTexture);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void DensityDialog::askForPacking(double area)
{
    setWindowTitle(tr("Pack at a texel density"));
    mSet->setText(tr("&Pack"));
    const auto showTiles = [this, area, texture = mTexture->text()] {
        const double texels = area * density() * density();
        const double tiles = texels / mPacking.textureSize / mPacking.height();
        mTexture->setText(
            tr("%1\nThe islands alone fill %2 tiles; with the room between them they need more.")
                .arg(texture)
                .arg(tiles, 0, 'f', 2));
    };
    connect(mDensity, &QDoubleSpinBox::valueChanged, this, showTiles);
    showTiles();
}

double DensityDialog::density() const
{
    return mDensity->value();
}

} // namespace autocuts
