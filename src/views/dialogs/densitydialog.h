// The dialog for setting a texel density.
#pragma once

#include "model/plain/packingsettings.h"

#include <QDialog>

class QDoubleSpinBox;

namespace autocuts {

//! Asks for a texel density; suggests that of the selection.
class DensityDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param present density of the selection; NaN when it has none
    //! \param packing the texture that the density refers to
    DensityDialog(double present, const PackingSettings &packing, QWidget *parent = nullptr);

    //! Texels per unit of the model.
    double density() const;

private:
    QDoubleSpinBox *mDensity;
};

} // namespace autocuts
