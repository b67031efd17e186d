// The dialog for scattering islands.
#pragma once

#include "model/editing/arrangement.h"

#include <QDialog>

class QDoubleSpinBox;
class QSpinBox;

namespace autocuts {

//! Asks for the limits of random moves, turns and scaling, and for the seed.
class ScatterDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param textureSize for moves in texels
    ScatterDialog(const ScatterRanges &ranges, int textureSize, QWidget *parent = nullptr);

    ScatterRanges ranges() const;

private:
    const int mTextureSize;
    QDoubleSpinBox *mMove, *mAngle, *mScale;
    QSpinBox *mSeed;
};

} // namespace autocuts
