// The texel density that islands should get.
#pragma once

#include <QDialog>

class QDoubleSpinBox;

namespace autocuts {

//! Asks for a texel density; proposes that of the selection.
class DensityDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param present of the selection; not a number when it has none
    //! \param textureSize that the density refers to
    DensityDialog(double present, int textureSize, QWidget *parent = nullptr);

    //! Texels per unit of the model.
    double density() const;

private:
    QDoubleSpinBox *mDensity;
};

} // namespace autocuts
