// The panel of view options.
#pragma once

#include "views/panels/panel.h"
#include "views/state/viewstate.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QPushButton;

namespace autocuts {

class ElidedLabel;
class HeatLegend;
class SliderSpin;

//! Sets the colouring with its legend and limits, the pattern and the texture. Changes ViewState, which is
//! not an edit of the document.
class ViewPanel final : public Panel
{
    Q_OBJECT

public:
    explicit ViewPanel(const StudioContext &context, QWidget *parent = nullptr);

protected:
    void refresh() override;

private:
    void addColoringRows();
    void addClampRows();
    void addDensityRows();
    void addDensityUnitRows();
    //! Texels per unit of the model of a shown density of 1.
    static double shownDensityUnit(const ViewOptions &options);
    void choosePreset();
    QDoubleSpinBox *makeCountBox(QLatin1StringView name, double low, double high, double ViewOptions::*field);
    void addPatternRows();
    template <class Edit>
    void change(Edit edit);
    void choosePattern();
    void showLegend(const ViewOptions &options);

    QFormLayout *mForm = nullptr;
    QComboBox *mColoring = nullptr, *mPattern = nullptr, *mBakedMap = nullptr;
    SliderSpin *mStretchClamp = nullptr, *mMagnitudeClamp = nullptr, *mDensityClamp = nullptr;
    HeatLegend *mLegend = nullptr;
    QComboBox *mDensityUnit = nullptr, *mDensityPreset = nullptr;
    QDoubleSpinBox *mDensityTolerance = nullptr, *mUnitLength = nullptr;
    QDoubleSpinBox *mDensityTarget = nullptr, *mCheckerSize = nullptr, *mLetteredCells = nullptr;
    QWidget *mTextureRow = nullptr;
    ElidedLabel *mTextureName = nullptr;
    QLabel *mModelTextures = nullptr;
};

} // namespace autocuts
