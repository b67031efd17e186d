// The dialog for setting a texel density.
#pragma once

#include "model/plain/packingsettings.h"

#include <QDialog>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace autocuts {

//! Asks for a texel density; suggests that of the selection.
class DensityDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param present density of the selection; NaN when it has none
    //! \param packing the texture that the density refers to
    DensityDialog(double present, const PackingSettings &packing, QWidget *parent = nullptr);

    //! Makes it a dialog for packing over tiles. \param area of the islands, in the model's units
    void askForPacking(double area);
    //! Texels per unit of the model.
    double density() const;

private:
    PackingSettings mPacking;
    QDoubleSpinBox *mDensity;
    QLabel *mRemark, *mTexture;
    QPushButton *mSet;
};

} // namespace autocuts
