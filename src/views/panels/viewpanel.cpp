#include "views/panels/viewpanel.h"

#include "views/actions/actionregistry.h"
#include "views/control/pictures/bakemaptexts.h"
#include "views/control/pictures/livebake.h"
#include "views/control/pictures/modelpictures.h"
#include "views/gl/colormap.h"
#include "views/gl/letteredpattern.h"
#include "views/panels/controls.h"
#include "views/panels/elidedlabel.h"
#include "views/panels/heatlegend.h"
#include "views/panels/sliderspin.h"
#include "views/ui/icons.h"
#include "views/ui/numbertext.h"
#include "views/ui/preferences.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include <cmath>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Lets a choice be narrower than its longest text.
void narrowest(QComboBox &box)
{
    box.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box.setMinimumContentsLength(10);
}

} // namespace

ViewPanel::ViewPanel(const StudioContext &context, QWidget *parent)
    : Panel(context, tr("Open a model to choose how it is shown."), parent)
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing + 2);
    auto *choices = new QWidget;
    mForm = makeForm(choices);
    addColoringRows();
    addPatternRows();
    layout->addWidget(choices);
    layout->addStretch();
    connect(&context.view, &ViewState::optionsChanged, this, [this] { refreshSoon(); });
    connect(&context.preferences, &Preferences::changed, this, [this] { refreshSoon(); });
    connect(&context.pictures, &ModelPictures::changed, this, [this] { refreshSoon(); });
}

template <class Edit>
void ViewPanel::change(Edit edit)
{
    ViewOptions options = context().view.options();
    edit(options);
    context().view.setOptions(options);
}

void ViewPanel::addColoringRows()
{
    mColoring = new QComboBox;
    mColoring->setObjectName("coloring"_L1);
    narrowest(*mColoring);
    mColoring->addItem(tr("Plain"), int(Coloring::Plain));
    mColoring->addItem(tr("Islands"), int(Coloring::Islands));
    mColoring->addItem(tr("Signed stretch"), int(Coloring::SignedStretch));
    mColoring->addItem(tr("Magnitude of stretch"), int(Coloring::StretchMagnitude));
    mColoring->addItem(tr("Painted weights"), int(Coloring::PaintWeights));
    mColoring->addItem(tr("Texel density"), int(Coloring::Density));
    mColoring->addItem(tr("Painted texel density"), int(Coloring::TexelWeights));
    mColoring->addItem(tr("Vertex colours"), int(Coloring::VertexColors));
    connect(mColoring, &QComboBox::activated, this, [this] {
        const auto coloring = Coloring(mColoring->currentData().toInt());
        change([coloring](ViewOptions &options) { options.coloring = coloring; });
    });
    const QString tip = tr("What gives the faces their colour");
    QLabel *label = addRow(mForm, tr("Colours"), mColoring, tip);
    explain(mColoring, tip, {"view.heatMap"});
    explain(label, tip, {"view.heatMap"});

    addClampRows();
    addDensityRows();
    mLegend = new HeatLegend;
    mLegend->setObjectName("legend"_L1);
    mForm->addRow(mLegend);
}

void ViewPanel::addClampRows()
{
    auto *factor = new QDoubleSpinBox;
    factor->setDecimals(2);
    factor->setSingleStep(0.1);
    mStretchClamp = new SliderSpin(SliderScale::fineNearMinimum(0.05, 6), factor);
    mStretchClamp->setObjectName("stretchClamp"_L1);
    connect(mStretchClamp, &SliderSpin::edited, this, [this](double value) {
        change([value](ViewOptions &options) { options.stretchClamp = value; });
    });
    addRow(
        mForm, tr("Full colour at"), mStretchClamp,
        tr("log2 of the area ratio that gets the full colour: at 1 that is half or double the right size"));

    auto *energy = new QDoubleSpinBox;
    energy->setDecimals(2);
    energy->setSingleStep(0.1);
    mMagnitudeClamp = new SliderSpin(SliderScale::fineNearMinimum(4.01, 60), energy);
    mMagnitudeClamp->setObjectName("magnitudeClamp"_L1);
    connect(mMagnitudeClamp, &SliderSpin::edited, this, [this](double value) {
        change([value](ViewOptions &options) { options.magnitudeClamp = value; });
    });
    addRow(mForm, tr("Full colour at"), mMagnitudeClamp,
           tr("Symmetric Dirichlet energy that gets the full colour; 4 is without distortion"));
}

void ViewPanel::addDensityRows()
{
    addDensityUnitRows();
    mDensityTarget = new QDoubleSpinBox;
    mDensityTarget->setObjectName("densityTarget"_L1);
    mDensityTarget->setRange(0, 1e9);
    mDensityTarget->setKeyboardTracking(false);
    mDensityTarget->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    mDensityTarget->setDecimals(2);
    mDensityTarget->setSpecialValueText(tr("median of the map"));
    connect(mDensityTarget, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        change([value](ViewOptions &options) { options.densityTarget = value * shownDensityUnit(options); });
    });
    addRow(mForm, tr("Right density"), mDensityTarget,
           tr("Texels per length of the model that get the colour in the middle; 0: the median of the map. "
              "Painted faces are to have theirs times their weight"));
    mDensityTolerance = new QDoubleSpinBox;
    mDensityTolerance->setObjectName("densityTolerance"_L1);
    mDensityTolerance->setRange(0, 100);
    mDensityTolerance->setDecimals(0);
    mDensityTolerance->setSuffix(tr(" %"));
    mDensityTolerance->setSpecialValueText(tr("none: smooth colours"));
    mDensityTolerance->setKeyboardTracking(false);
    connect(mDensityTolerance, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
        change([percent](ViewOptions &options) { options.densityTolerance = percent / 100; });
    });
    addRow(mForm, tr("Tolerance"), mDensityTolerance,
           tr("Faces off the right density by no more than this get one colour, those with too many and with "
              "too few texels two others"));
    auto *factor = new QDoubleSpinBox;
    factor->setDecimals(2);
    factor->setSingleStep(0.1);
    mDensityClamp = new SliderSpin(SliderScale::fineNearMinimum(0.05, 4), factor);
    mDensityClamp->setObjectName("densityClamp"_L1);
    connect(mDensityClamp, &SliderSpin::edited, this, [this](double value) {
        change([value](ViewOptions &options) { options.densityClamp = value; });
    });
    addRow(mForm, tr("Full colour at"), mDensityClamp,
           tr("log2 of the factor that gets the full colour: at 1 that is half or double the right density"));
}

void ViewPanel::addDensityUnitRows()
{
    mDensityUnit = new QComboBox;
    mDensityUnit->setObjectName("densityUnit"_L1);
    mDensityUnit->addItems({tr("px per unit"), tr("px per cm")});
    connect(mDensityUnit, &QComboBox::activated, this, [this](int index) {
        change([index](ViewOptions &options) { options.densityPerCentimetre = index == 1; });
    });
    addRow(mForm, tr("Shown as"), mDensityUnit, tr("The length to which texel densities refer"));
    mUnitLength = new QDoubleSpinBox;
    mUnitLength->setObjectName("unitLength"_L1);
    mUnitLength->setRange(1e-4, 1e6);
    mUnitLength->setDecimals(4);
    mUnitLength->setSuffix(tr(" cm"));
    mUnitLength->setKeyboardTracking(false);
    mUnitLength->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    connect(mUnitLength, &QDoubleSpinBox::valueChanged, this, [this](double centimetres) {
        change([centimetres](ViewOptions &options) {
            if (options.densityPerCentimetre) // the right density stays the same per cm
                options.densityTarget *= centimetres / options.unitCentimetres;
            options.unitCentimetres = centimetres;
        });
    });
    addRow(mForm, tr("Model unit"), mUnitLength,
           tr("How long a unit of the model is: 100 cm for metres, 1 for centimetres, 2.54 for inches"));
    mDensityPreset = new QComboBox;
    mDensityPreset->setObjectName("densityPreset"_L1);
    mDensityPreset->addItem(tr("Choose…"));
    for (const double density : {5.12, 10.24, 20.48})
        mDensityPreset->addItem(tr("%1 px/cm").arg(density), density);
    connect(mDensityPreset, &QComboBox::activated, this, &ViewPanel::choosePreset);
    addRow(mForm, tr("Presets"), mDensityPreset, tr("Usual right densities"));
}

double ViewPanel::shownDensityUnit(const ViewOptions &options)
{
    return options.densityPerCentimetre ? options.unitCentimetres : 1;
}

void ViewPanel::choosePreset()
{
    const double density = mDensityPreset->currentData().toDouble();
    mDensityPreset->setCurrentIndex(0);
    if (!(density > 0))
        return;
    change([density](ViewOptions &options) {
        options.densityPerCentimetre = true;
        options.densityTarget = density * options.unitCentimetres;
    });
}

QDoubleSpinBox *ViewPanel::makeCountBox(QLatin1StringView name, double low, double high,
                                        double ViewOptions::*field)
{
    auto *box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setRange(low, high);
    box->setDecimals(0);
    box->setKeyboardTracking(false);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, field](double value) {
        change([value, field](ViewOptions &options) { options.*field = value; });
    });
    return box;
}

void ViewPanel::addPatternRows()
{
    mPattern = new QComboBox;
    mPattern->setObjectName("pattern"_L1);
    narrowest(*mPattern);
    mPattern->addItem(tr("None"), int(Pattern::None));
    mPattern->addItem(tr("Checkerboard"), int(Pattern::Checker));
    mPattern->addItem(tr("Lettered cells"), int(Pattern::Lettered));
    mPattern->addItem(tr("Textures of the model"), int(Pattern::Materials));
    mPattern->addItem(tr("Texture sets in light"), int(Pattern::Physical));
    mPattern->addItem(tr("Live bake"), int(Pattern::Baked));
    mPattern->addItem(tr("Texture"), int(Pattern::Texture));
    connect(mPattern, &QComboBox::activated, this, &ViewPanel::choosePattern);
    const QString tip = tr("What lies on the model, and behind the map");
    QLabel *label = addRow(mForm, tr("Pattern"), mPattern, tip);
    explain(mPattern, tip, {"view.texture"});
    explain(label, tip, {"view.texture"});

    mBakedMap = new QComboBox;
    mBakedMap->setObjectName("bakedMap"_L1);
    narrowest(*mBakedMap);
    for (const QString &name : jobs::bakeMapNames())
        mBakedMap->addItem(bakeMapTitle(name), name);
    connect(mBakedMap, &QComboBox::activated, this,
            [this] { context().liveBake.choose(mBakedMap->currentData().toString()); });
    connect(&context().liveBake, &LiveBake::changed, this, [this] { refreshSoon(); });
    addRow(mForm, tr("Map"), mBakedMap, tr("Which map of the bake is shown while the UVs change"));

    mCheckerSize = makeCountBox("checkerSize"_L1, 1, 1024, &ViewOptions::checkerSize);
    addRow(mForm, tr("Squares"), mCheckerSize, tr("Squares along the width of the texture"));
    mLetteredCells =
        makeCountBox("letteredCells"_L1, leastLetteredCells, mostLetteredCells, &ViewOptions::letteredCells);
    addRow(mForm, tr("Cells"), mLetteredCells, tr("Lettered cells along the width of the texture"));

    QPushButton *load = makeButton(tr("Load…"), "loadTexture"_L1);
    explain(load, tr("Choose the picture to show on the model"), {"view.loadTexture"});
    connect(load, &QPushButton::clicked, context().actions.action("view.loadTexture"), &QAction::trigger);
    mTextureName = new ElidedLabel;
    mTextureRow = new QWidget;
    auto *layout = new QHBoxLayout(mTextureRow);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(rowSpacing);
    layout->addWidget(mTextureName, 1);
    layout->addWidget(load);
    mTextureRow->setFocusProxy(load);
    addRow(mForm, tr("Texture"), mTextureRow, tr("Picture that is shown on the model, and behind the map"));
    mModelTextures = new QLabel;
    mModelTextures->setObjectName("modelTextures"_L1);
    addRow(mForm, tr("Textures"), mModelTextures,
           tr("Pictures that the model's file names. Behind the map lies that of the selected face, or that "
              "of the material with the most faces"));
}

void ViewPanel::choosePattern()
{
    const auto pattern = Pattern(mPattern->currentData().toInt());
    if (pattern == Pattern::Texture && context().view.options().texturePath.isEmpty()) {
        // No texture yet: ask for one. The box is reset when none is chosen.
        context().actions.action("view.loadTexture")->trigger();
        refreshSoon();
        return;
    }
    if (pattern == Pattern::Baked && !context().liveBake.isOn()) {
        context().actions.action("uv.bake")->trigger();
        refreshSoon();
        return;
    }
    change([pattern](ViewOptions &options) { options.pattern = pattern; });
}

void ViewPanel::refresh()
{
    const ViewOptions &options = context().view.options();
    mColoring->setCurrentIndex(mColoring->findData(int(options.coloring)));
    mPattern->setCurrentIndex(mPattern->findData(int(options.pattern)));
    mStretchClamp->setValue(options.stretchClamp);
    mMagnitudeClamp->setValue(options.magnitudeClamp);
    mDensityClamp->setValue(options.densityClamp);
    for (const auto &[box, value] :
         {std::pair(mCheckerSize, options.checkerSize), std::pair(mLetteredCells, options.letteredCells),
          std::pair(mDensityTarget, options.densityTarget / shownDensityUnit(options)),
          std::pair(mDensityTolerance, 100 * options.densityTolerance),
          std::pair(mUnitLength, options.unitCentimetres)}) {
        const QSignalBlocker blocker(box);
        box->setValue(value);
    }
    mDensityTarget->setSuffix(options.densityPerCentimetre ? tr(" px/cm") : tr(" px/unit"));
    mDensityUnit->setCurrentIndex(options.densityPerCentimetre ? 1 : 0);
    mTextureName->setText(options.texturePath.isEmpty() ? tr("none")
                                                        : QFileInfo(options.texturePath).fileName());
    const int textures = context().pictures.count();
    mModelTextures->setText(context().pictures.isLoading() ? tr("being read...")
                            : textures == 0                ? tr("the model names none")
                                                           : tr("of %n materials", nullptr, textures));
    mForm->setRowVisible(mStretchClamp, options.coloring == Coloring::SignedStretch);
    mForm->setRowVisible(mMagnitudeClamp, options.coloring == Coloring::StretchMagnitude);
    const bool isDensity = options.coloring == Coloring::Density;
    for (QWidget *field : std::initializer_list<QWidget *>{mDensityTarget, mDensityTolerance, mDensityUnit,
                                                           mUnitLength, mDensityPreset})
        mForm->setRowVisible(field, isDensity);
    mForm->setRowVisible(mDensityClamp, isDensity && options.densityTolerance == 0);
    mForm->setRowVisible(mCheckerSize, options.pattern == Pattern::Checker);
    const LiveBake &live = context().liveBake;
    mBakedMap->setCurrentIndex(mBakedMap->findData(live.map()));
    mForm->setRowVisible(mBakedMap, options.pattern == Pattern::Baked && live.isOn() && !live.isReceiving());
    mForm->setRowVisible(mLetteredCells, options.pattern == Pattern::Lettered);
    mForm->setRowVisible(mTextureRow, options.pattern == Pattern::Texture);
    mForm->setRowVisible(mModelTextures,
                         options.pattern == Pattern::Materials || options.pattern == Pattern::Physical);
    showLegend(options);
}

void ViewPanel::showLegend(const ViewOptions &options)
{
    const bool isSigned = options.coloring == Coloring::SignedStretch;
    const bool isDensity = options.coloring == Coloring::Density;
    const bool isWeights = options.coloring == Coloring::TexelWeights;
    mForm->setRowVisible(mLegend, isSigned || isDensity || isWeights ||
                                      options.coloring == Coloring::StretchMagnitude);
    const bool colorBlind = context().preferences.values().colorBlindHeatMap;
    if (isSigned) {
        const QString factor = significantText(std::exp2(options.stretchClamp), 3);
        mLegend->setLegend(heatStops(HeatMap::SignedStretch, colorBlind),
                           {tr("%1× too small").arg(factor), tr("right"), tr("%1× too large").arg(factor)});
    } else if (isWeights) {
        mLegend->setLegend(heatStops(HeatMap::Density, colorBlind), {tr("1/8"), tr("1×"), tr("8×")});
    } else if (isDensity && options.densityTolerance > 0) {
        const QString percent = QString::number(std::lround(100 * options.densityTolerance));
        mLegend->setLegend(bandedDensityStops(),
                           {tr("too coarse"), tr("±%1 %").arg(percent), tr("too fine")});
    } else if (isDensity) {
        const QString factor = significantText(std::exp2(options.densityClamp), 3);
        mLegend->setLegend(heatStops(HeatMap::Density, colorBlind),
                           {tr("%1× too coarse").arg(factor), tr("right"), tr("%1× too fine").arg(factor)});
    } else {
        const double middle = (4 + options.magnitudeClamp) / 2;
        mLegend->setLegend(
            heatStops(HeatMap::Magnitude, colorBlind),
            {u"4"_s, significantText(middle, 3), u"≥ "_s + significantText(options.magnitudeClamp, 4)});
    }
}

} // namespace autocuts
