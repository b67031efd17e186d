// The dialog that asks what light is to be baked.
#pragma once

#include "jobs/lightchoice.h"

#include <QDialog>

#include <array>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace autocuts {

class AlbedoForm;
class ColorButton;
class Document;
class LampForm;
class PathField;
class Questions;

//! Asks for the lights, the quality, the UV set and the file.
class LightBakeDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param last what was chosen last time; its UV set is one of the document
    LightBakeDialog(const Document &document, const jobs::LightChoice &last, Questions &questions);

    //! The choice of someone who has chosen nothing yet.
    static jobs::LightChoice firstChoice(const Document &document, const QString &folder);
    jobs::LightChoice choice() const;
    void accept() override;

private:
    enum class SkyKind { None, Color, Gradient, Day };

    QWidget *makeSun(const LightPlan &lights);
    QWidget *makeSky(const LightPlan &lights);
    QWidget *makeMap(const Document &document, const jobs::LightChoice &last);
    QWidget *makeQuality(const jobs::LightChoice &last);
    QWidget *makeFile(const jobs::LightChoice &last);
    void showState();
    QString problem() const;

    bool mHasUv;
    QGroupBox *mSun;
    QDoubleSpinBox *mAzimuth, *mElevation, *mSunStrength, *mSunAngle, *mSkyStrength, *mTurbidity;
    ColorButton *mSunColor;
    QComboBox *mSky, *mUp;
    std::array<ColorButton *, 3> mSkyColors; //!< zenith, horizon, ground
    LampForm *mLamps;
    AlbedoForm *mAlbedo;
    int mTextureSize; //!< of the document
    QComboBox *mUvSet, *mValues, *mFormat;
    QSpinBox *mSize, *mSamples, *mBounces, *mDilation;
    QCheckBox *mDirect, *mIndirect, *mDenoise;
    PathField *mPath;
    QLabel *mProblem;
    QPushButton *mBake;
};

} // namespace autocuts
