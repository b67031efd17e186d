#include "views/dialogs/lightbakedialog.h"

#include "jobs/lightmapfiles.h"
#include "model/document/document.h"
#include "views/dialogs/albedoform.h"
#include "views/dialogs/lampform.h"
#include "views/dialogs/pathfield.h"
#include "views/ui/colorbutton.h"
#include "views/ui/dialogsize.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"
#include "views/ui/reasons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The formats and their bits.
constexpr std::pair<const char *, int> lightFormats[]{{"png", 8}, {"png", 16}, {"tif", 8}, {"tif", 16},
                                                      {"tga", 8}, {"exr", 16}, {"exr", 32}};

ColorButton *makeColor(const QString &title, const Vec3f &linear, const char *name)
{
    auto *button = new ColorButton(title);
    button->setLinear(linear);
    button->setObjectName(QLatin1StringView(name));
    button->setToolTip(title);
    button->setAutoDefault(false);
    return button;
}

QDoubleSpinBox *makeNumber(double low, double high, int decimals, double value, const char *name)
{
    auto *box = new QDoubleSpinBox;
    box->setRange(low, high);
    box->setDecimals(decimals);
    box->setValue(value);
    box->setObjectName(QLatin1StringView(name));
    return box;
}

QSpinBox *makeCount(int low, int high, int value, const char *name)
{
    auto *box = new QSpinBox;
    box->setRange(low, high);
    box->setValue(value);
    box->setObjectName(QLatin1StringView(name));
    return box;
}

QComboBox *makeBox(const char *name)
{
    auto *box = new QComboBox;
    box->setObjectName(QLatin1StringView(name));
    return box;
}

QCheckBox *makeTick(const QString &text, bool on, const char *name)
{
    auto *box = new QCheckBox(text);
    box->setChecked(on);
    box->setObjectName(QLatin1StringView(name));
    return box;
}

void choose(QComboBox &box, const QVariant &data)
{
    box.setCurrentIndex(std::max(0, box.findData(data)));
}

} // namespace

jobs::LightChoice LightBakeDialog::firstChoice(const Document &document, const QString &folder)
{
    jobs::LightChoice choice;
    choice.lights.sun = Vec2(135, 40);
    choice.lights.sunStrength = 1.5;
    choice.lights.sky = {Vec3f::Ones()};
    choice.lights.skyStrength = 0.4;
    const std::vector<UvSet> &sets = document.uvSets();
    const auto found = std::ranges::find_if(
        sets, [](const UvSet &set) { return set.name.startsWith(u"lightmap"_s, Qt::CaseInsensitive); });
    choice.uvSet = found != sets.end() ? static_cast<int>(found - sets.begin())
                   : sets.size() > 1   ? document.activeUvSet()
                                       : jobs::LightChoice::newSet;
    const QString model = QFileInfo(document.state().scene.path).completeBaseName();
    choice.path = QDir(folder).filePath((model.isEmpty() ? u"model"_s : model) + u"_light.png"_s);
    return choice;
}

LightBakeDialog::LightBakeDialog(const Document &document, const jobs::LightChoice &last,
                                 Questions &questions)
    : QDialog(questions.window()), mHasUv(document.uv().array().isFinite().any()),
      mLamps(new LampForm(document.state().scene, last.lights.areas, last.surface.emission)),
      mAlbedo(new AlbedoForm(document.uvSets(), last.surface, questions)),
      mTextureSize(document.packingSettings().textureSize), mPath(new PathField(tr("Light map"), questions)),
      mProblem(new QLabel)
{
    setWindowTitle(tr("Bake light"));
    auto *left = new QVBoxLayout, *right = new QVBoxLayout;
    left->addWidget(makeSun(last.lights));
    left->addWidget(makeSky(last.lights));
    left->addWidget(mLamps);
    left->addStretch();
    right->addWidget(makeMap(document, last));
    right->addWidget(makeQuality(last));
    right->addWidget(mAlbedo);
    right->addWidget(makeFile(last));
    right->addStretch();
    auto *columns = new QHBoxLayout;
    columns->addLayout(left, 1);
    columns->addLayout(right, 1);
    mProblem->setWordWrap(true);
    mProblem->setObjectName("problem"_L1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    mBake = buttons->addButton(tr("Ba&ke light"), QDialogButtonBox::AcceptRole);
    mBake->setObjectName("bake"_L1);
    mBake->setDefault(true);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(scrolled(columns), 1);
    layout->addWidget(mProblem);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &LightBakeDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(mSun, &QGroupBox::toggled, this, &LightBakeDialog::showState);
    for (QComboBox *box : {mSky, mUp})
        connect(box, &QComboBox::currentIndexChanged, this, &LightBakeDialog::showState);
    connect(mFormat, &QComboBox::currentIndexChanged, this, [this] {
        mPath->setSuffix(QString::fromLatin1(lightFormats[std::max(0, mFormat->currentIndex())].first));
    });
    for (QCheckBox *box : {mDirect, mIndirect})
        connect(box, &QCheckBox::toggled, this, &LightBakeDialog::showState);
    connect(mAlbedo, &AlbedoForm::changed, this, &LightBakeDialog::showState);
    connect(mLamps, &LampForm::changed, this, &LightBakeDialog::showState);
    connect(mPath, &PathField::pathChanged, this, &LightBakeDialog::showState);
    showState();
    resizeToContent(*this);
}

QWidget *LightBakeDialog::makeSun(const LightPlan &lights)
{
    mSun = new QGroupBox(tr("&Sun"));
    mSun->setObjectName("sun"_L1);
    mSun->setCheckable(true);
    mSun->setChecked(lights.sun && !lights.sunHidden);
    const Vec2 place = lights.sun.value_or(Vec2(135, 40));
    mAzimuth = makeNumber(-360, 360, 1, place.x(), "azimuth");
    mElevation = makeNumber(-90, 90, 1, place.y(), "elevation");
    for (QDoubleSpinBox *box : {mAzimuth, mElevation})
        box->setSuffix(tr("°"));
    mAzimuth->setToolTip(tr("Direction of the sun, clockwise from north, which is -z, or y where z is up"));
    mElevation->setToolTip(tr("Height of the sun above the horizon"));
    mSunStrength = makeNumber(0, 1e6, 2, lights.sunStrength, "sunStrength");
    mSunStrength->setToolTip(
        tr("Light on a surface that faces the sun (irradiance); 3.14 makes white of white"));
    mSunAngle = makeNumber(0, 90, 2, lights.sunAngle, "sunAngle");
    mSunAngle->setSuffix(tr("°"));
    mSunAngle->setToolTip(tr("Diameter as seen from the model; a larger sun makes softer shadows"));
    mSunColor = makeColor(tr("Colour of the sun"), lights.sunColor, "sunColor");
    auto *form = new QFormLayout(mSun);
    form->addRow(tr("Direction:"), mAzimuth);
    form->addRow(tr("Height:"), mElevation);
    form->addRow(tr("Strength:"), mSunStrength);
    form->addRow(tr("Size:"), mSunAngle);
    form->addRow(tr("Colour:"), mSunColor);
    return mSun;
}

QWidget *LightBakeDialog::makeSky(const LightPlan &lights)
{
    auto *group = new QGroupBox(tr("Sky"));
    mSky = makeBox("sky");
    mSky->addItem(tr("None"), int(SkyKind::None));
    mSky->addItem(tr("One colour"), int(SkyKind::Color));
    mSky->addItem(tr("Gradient"), int(SkyKind::Gradient));
    mSky->addItem(tr("Clear day"), int(SkyKind::Day));
    const std::vector<Vec3f> colors = lights.sky.value_or(std::vector<Vec3f>());
    choose(*mSky, int(lights.day           ? SkyKind::Day
                      : colors.empty()     ? SkyKind::None
                      : colors.size() == 1 ? SkyKind::Color
                                           : SkyKind::Gradient));
    mSky->setToolTip(
        tr("Light from all around; a clear day is that of the sun's place, also where the sun is off"));
    mSkyStrength = makeNumber(0, 1e6, 2, lights.skyStrength, "skyStrength");
    mSkyStrength->setToolTip(tr("Factor on the colours; of a clear day, the brightness of the zenith"));
    mTurbidity = makeNumber(2, 10, 1, lights.turbidity, "turbidity");
    mTurbidity->setToolTip(tr("Haze of a clear day: 2 is clear, 10 hazy"));
    const std::array<Vec3f, 3> standard{Vec3f(0.35F, 0.55F, 1), Vec3f(1, 1, 1), Vec3f(0.3F, 0.25F, 0.2F)};
    const std::array titles{tr("Colour of the zenith"), tr("Colour of the horizon"),
                            tr("Colour of the ground")};
    const std::array names{"skyZenith", "skyHorizon", "skyGround"};
    auto *row = new QWidget;
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3f color = k < colors.size() ? colors[k] : standard[k];
        mSkyColors[k] = makeColor(titles[k], color, names[k]);
        layout->addWidget(mSkyColors[k]);
    }
    auto *form = new QFormLayout(group);
    form->addRow(tr("Sk&y:"), mSky);
    form->addRow(tr("Colours:"), row);
    form->addRow(tr("Strength:"), mSkyStrength);
    form->addRow(tr("Haze:"), mTurbidity);
    return group;
}

QWidget *LightBakeDialog::makeMap(const Document &document, const jobs::LightChoice &last)
{
    auto *group = new QGroupBox(tr("Light map"));
    mUvSet = makeBox("uvSet");
    const std::vector<UvSet> &sets = document.uvSets();
    for (int s = 0; s < std::ssize(sets); ++s)
        mUvSet->addItem(sets[std::size_t(s)].name, s);
    mUvSet->addItem(tr("New set for lightmaps"), jobs::LightChoice::newSet);
    choose(*mUvSet, last.uvSet);
    mUvSet->setToolTip(
        tr("The map that light is baked into. In a map for lightmaps no islands lie on each other: a "
           "new one is made of the active map, and packed with the margin of the Packing panel"));
    mSize = makeCount(PreferenceLimits::minTextureSize, jobs::maxLightMapSide,
                      last.textureSize > 0 ? last.textureSize : mTextureSize, "size");
    mSize->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    mSize->setSuffix(tr(" px"));
    mSize->setToolTip(tr("Width of the picture; at first that of the texture in the Packing panel, whose "
                         "proportions it has"));
    mValues = makeBox("values");
    mValues->addItem(tr("Light, times the colour of the surface it is what is seen"),
                     int(bake::LightValue::Light));
    mValues->addItem(tr("Irradiance"), int(bake::LightValue::Irradiance));
    mValues->addItem(tr("What is seen, with the colours of the materials"), int(bake::LightValue::Lit));
    mValues->setMinimumContentsLength(16);
    mValues->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choose(*mValues, int(last.values));
    mDilation = makeCount(0, 1024, last.dilation, "dilation");
    mDilation->setSuffix(tr(" px"));
    mDilation->setToolTip(tr("Texels around islands that are filled with the nearest value"));
    auto *form = new QFormLayout(group);
    form->addRow(tr("&UV set:"), mUvSet);
    form->addRow(tr("Si&ze:"), mSize);
    form->addRow(tr("&Values:"), mValues);
    form->addRow(tr("D&ilation:"), mDilation);
    return group;
}

QWidget *LightBakeDialog::makeQuality(const jobs::LightChoice &last)
{
    auto *group = new QGroupBox(tr("Light"));
    mSamples = makeCount(1, 1'000'000, last.samples, "samples");
    mSamples->setToolTip(tr("Paths of light in each texel: more of them leave less noise"));
    mBounces = makeCount(0, 1000, last.bounces, "bounces");
    mBounces->setToolTip(tr("How often light is reflected before it arrives"));
    mDirect = makeTick(tr("Direct light"), last.direct, "direct");
    mIndirect = makeTick(tr("Indirect light"), last.indirect, "indirect");
    mDenoise = makeTick(tr("Take out the &noise"), last.denoise, "denoise");
    mUp = makeBox("up");
    mUp->addItem(u"Y"_s, false);
    mUp->addItem(u"Z"_s, true);
    choose(*mUp, last.lights.zUp);
    mUp->setToolTip(tr("The axis that points to the zenith"));
    auto *form = new QFormLayout(group);
    form->addRow(tr("Sam&ples per texel:"), mSamples);
    form->addRow(tr("B&ounces:"), mBounces);
    form->addRow(QString(), mDirect);
    form->addRow(QString(), mIndirect);
    form->addRow(QString(), mDenoise);
    form->addRow(tr("Up:"), mUp);
    return group;
}

QWidget *LightBakeDialog::makeFile(const jobs::LightChoice &last)
{
    auto *group = new QGroupBox(tr("File"));
    mFormat = makeBox("format");
    for (const auto &[suffix, bits] : lightFormats) {
        mFormat->addItem(tr("%1, %2 bits").arg(QString::fromLatin1(suffix).toUpper()).arg(bits));
        if (last.path.endsWith(u'.' + QLatin1StringView(suffix)) && last.bits == bits)
            mFormat->setCurrentIndex(mFormat->count() - 1);
    }
    mFormat->setToolTip(tr("EXR keeps light above 1 and is linear; the others are cut off at 1 and in sRGB"));
    mPath->setObjectName("path"_L1);
    mPath->setPath(last.path);
    mPath->setFilters({tr("Pictures (%1)").arg(u"*.png *.tif *.tga *.exr"_s)});
    auto *form = new QFormLayout(group);
    form->addRow(tr("&Format:"), mFormat);
    form->addRow(tr("Fil&e:"), mPath);
    return group;
}

void LightBakeDialog::showState()
{
    const auto kind = SkyKind(mSky->currentData().toInt());
    const QString why = tr("This kind of sky has no such colour");
    enableOrSay(mSkyColors[0], kind == SkyKind::Color || kind == SkyKind::Gradient, why);
    for (const std::size_t k : {1U, 2U})
        enableOrSay(mSkyColors[k], kind == SkyKind::Gradient, why);
    enableOrSay(mSkyStrength, kind != SkyKind::None, tr("There is no sky"));
    enableOrSay(mTurbidity, kind == SkyKind::Day, tr("Only the sky of a day has haze"));
    mLamps->setUp(mUp->currentData().toBool() ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::UnitY()));
    mProblem->setText(problem());
    disableFor(mProblem->text(), mBake);
}

QString LightBakeDialog::problem() const
{
    if (!mHasUv)
        return tr("The model has no UVs: unwrap it first.");
    if (const QString problem = mLamps->problem(); !problem.isEmpty())
        return problem;
    if (const QString problem = mAlbedo->problem(); !problem.isEmpty())
        return problem;
    const jobs::LightChoice chosen = choice();
    const bool dark = chosen.lights.sunHidden && !chosen.lights.day && chosen.lights.sky->empty() &&
                      chosen.lights.areas.empty() && chosen.surface.emission.empty();
    if (dark)
        return tr("Choose at least one light.");
    if (!chosen.direct && !chosen.indirect)
        return tr("Choose direct or indirect light.");
    if (const QString problem = mPath->problem(); !problem.isEmpty())
        return problem;
    const Result<PictureDepth> depth = jobs::lightMapDepth(chosen.path, chosen.bits);
    return depth ? QString() : tr("The file cannot be written in this format: %1").arg(depth.error().message);
}

void LightBakeDialog::accept()
{
    if (problem().isEmpty() && mPath->confirmReplacing())
        QDialog::accept();
}

jobs::LightChoice LightBakeDialog::choice() const
{
    jobs::LightChoice choice;
    LightPlan &lights = choice.lights;
    lights.sun = Vec2(mAzimuth->value(), mElevation->value());
    lights.sunHidden = !mSun->isChecked();
    lights.sunStrength = mSunStrength->value();
    lights.sunAngle = mSunAngle->value();
    lights.sunColor = mSunColor->linear();
    const auto kind = SkyKind(mSky->currentData().toInt());
    lights.sky.emplace();
    const std::size_t colors = kind == SkyKind::Color ? 1 : kind == SkyKind::Gradient ? 3 : 0;
    for (std::size_t k = 0; k < colors; ++k)
        lights.sky->push_back(mSkyColors[k]->linear());
    lights.day = kind == SkyKind::Day;
    lights.skyStrength = mSkyStrength->value();
    lights.turbidity = mTurbidity->value();
    lights.areas = mLamps->areas().value_or(std::vector<LightPlan::Area>());
    lights.zUp = mUp->currentData().toBool();
    mAlbedo->apply(choice.surface);
    choice.surface.emission = mLamps->emission().value_or(LampForm::Emission());
    choice.uvSet = mUvSet->currentData().toInt();
    choice.textureSize = mSize->value() == mTextureSize ? 0 : mSize->value();
    choice.values = bake::LightValue(mValues->currentData().toInt());
    choice.dilation = mDilation->value();
    choice.samples = mSamples->value();
    choice.bounces = mBounces->value();
    choice.direct = mDirect->isChecked();
    choice.indirect = mIndirect->isChecked();
    choice.denoise = mDenoise->isChecked();
    choice.path = mPath->path();
    choice.bits = lightFormats[std::max(0, mFormat->currentIndex())].second;
    return choice;
}

} // namespace autocuts
