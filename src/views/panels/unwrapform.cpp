#include "views/panels/unwrapform.h"

#include "views/panels/controls.h"
#include "views/panels/stretchcontrol.h"
#include "views/ui/reasons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QPushButton>

#include <cmath>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! SolveSettings::visibility that the switch sets. Chosen by hand.
constexpr double hiddenSeams = 0.5;

} // namespace

UnwrapForm::UnwrapForm(QWidget *parent)
    : QWidget(parent), mUnwrap(makeButton(tr("Unwrap"), "unwrap"_L1)), mStretch(new StretchControl),
      mSurface(makeChoice("surface"_L1, &SolveSettings::surface,
                          {{{}, SurfaceKind::Auto},
                           {tr("Organic"), SurfaceKind::Organic},
                           {tr("Hard surface"), SurfaceKind::HardSurface}})),
      mAlike(makeChoice("alike"_L1, &SolveSettings::alike,
                        {{tr("Each on its own"), AlikeMode::Off},
                         {tr("Same cuts"), AlikeMode::SameCuts},
                         {tr("Same cuts, stacked"), AlikeMode::Stack}})),
      mSymmetry(makeChoice("symmetry"_L1, &SolveSettings::symmetry,
                           {{tr("Any cuts"), SymmetryMode::Off},
                            {tr("Same cuts if cheap"), SymmetryMode::Auto},
                            {tr("Same cuts"), SymmetryMode::On}})),
      mUp(makeChoice("worldUp"_L1, &SolveSettings::worldUp,
                     {{tr("Any direction"), WorldUp::Off},
                      {tr("Y of the model"), WorldUp::Y},
                      {tr("Z of the model"), WorldUp::Z},
                      {tr("Y if cheap"), WorldUp::AutoY},
                      {tr("Z if cheap"), WorldUp::AutoZ}})),
      mQuality(new QComboBox)
{
    mUnwrap->setProperty("primary", true);
    mUnwrap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(mUnwrap, &QPushButton::clicked, this, &UnwrapForm::unwrapRequested);
    auto *form = makeForm(this);
    form->addRow(mUnwrap);
    mStretch->setObjectName("stretch"_L1);
    connect(mStretch, &StretchControl::edited, this, [this](double bound, bool first) {
        Q_EMIT edited([bound](SolveSettings &settings) { settings.maxDistortion = bound; }, first);
    });
    addRow(
        form, tr("Stretch"), mStretch,
        tr("How much the map may be stretched: little stretch needs long seams. D is the mean symmetric "
           "Dirichlet energy over the surface, 4 where nothing is distorted. Also used by the live solve and "
           "Finish."));
    setRecognised({});
    addRow(form, tr("Model"), mSurface,
           tr("What the model is like. Hard surface: flat faces with sharp edges; these keep their shape and "
              "get "
              "the seams. Organic: curved, so that the stretch may go anywhere. Recognise: each part by "
              "itself"));
    addRow(
        form, tr("Alike parts"), mAlike,
        tr("Parts that are copies of each other, also mirrored ones, get the same seams and islands: one of "
           "them is solved, which is faster. Stacked: Unwrap also lays islands that are copies on each "
           "other. Parts that you cut or join by hand are left out"));
    addRow(
        form, tr("Both sides"), mSymmetry,
        tr("Whether both sides of a symmetric model are cut alike. If cheap: Unwrap does so on curved models "
           "where its seams hardly become longer, and symmetric seams stay symmetric"));
    mFlat = addSwitch(
        tr("Keep flat faces rigid"), "flat"_L1,
        tr("Flat faces, and what unrolls without stretch, keep their shape; the stretch goes to the curved "
           "parts. Off: "
           "seams become shorter, and faces bend"),
        [](SolveSettings &settings, bool on) { settings.flat = on ? FlatMode::Rigid : FlatMode::Free; });
    mHidden = addSwitch(tr("Seams where they are hard to see"), "hidden"_L1,
                        tr("Seams rather in folds, between parts, underneath; Advanced sets how strongly"),
                        [](SolveSettings &settings, bool on) { settings.visibility = on ? hiddenSeams : 0; });
    mSharp = addSwitch(
        tr("Seams along sharp edges"), "sharp"_L1,
        tr("Where clear creases make up the sharp edges, seams rather run along them; Advanced sets how "
           "strongly"),
        [](SolveSettings &settings, bool on) { settings.creases = on ? CreaseMode::Auto : CreaseMode::Off; });
    mAlign = addSwitch(
        tr("Straight and along the axes"), "align"_L1,
        tr("On hard surfaces, islands run along the axes, and what is straight on the model is straight in "
           "the "
           "map, as far as the stretch allows; seams become a little longer"),
        [](SolveSettings &settings, bool on) { settings.align = on ? CreaseMode::Auto : CreaseMode::Off; });
    mMirror = addSwitch(tr("Mirrored maps of mirrored parts"), "mirror"_L1,
                        tr("Symmetric islands get symmetric maps, those of a left and a right part mirror "
                           "images of each other; goes with the same cuts on both sides"),
                        [](SolveSettings &settings, bool on) { settings.mirrorMaps = on; });
    for (QCheckBox *box : {mFlat, mHidden, mSharp, mAlign, mMirror})
        form->addRow(box);
    addRow(
        form, tr("Up in the map"), mUp,
        tr("Turns islands so that this direction is up; they are packed as they stand. If cheap: an unwrap "
           "does so where it costs at most 5 % of the texel density"));
    mQuality->setObjectName("quality"_L1);
    mQuality->addItem(tr("Draft"), int(unwrap::UnwrapQuality::Draft));
    mQuality->addItem(tr("Standard"), int(unwrap::UnwrapQuality::Standard));
    mQuality->addItem(tr("Best"), int(unwrap::UnwrapQuality::Best));
    mQuality->setCurrentIndex(1);
    connect(mQuality, &QComboBox::currentIndexChanged, this,
            [this] { Q_EMIT qualityChosen(unwrap::UnwrapQuality(mQuality->currentData().toInt())); });
    addRow(form, tr("Quality"), mQuality, tr("How much work Unwrap puts into short seams"));
}

template <class T>
QComboBox *UnwrapForm::makeChoice(QLatin1StringView name, T SolveSettings::*setting,
                                  std::initializer_list<std::pair<QString, T>> choices)
{
    auto *box = new QComboBox;
    box->setObjectName(name);
    for (const auto &[text, choice] : choices)
        box->addItem(text, int(choice));
    connect(box, &QComboBox::activated, this, [this, box, setting] {
        const auto choice = T(box->currentData().toInt());
        Q_EMIT edited([setting, choice](SolveSettings &settings) { settings.*setting = choice; }, true);
    });
    return box;
}

QCheckBox *UnwrapForm::addSwitch(const QString &text, QLatin1StringView name, const QString &tip,
                                 std::function<void(SolveSettings &, bool)> set)
{
    auto *box = new QCheckBox(text);
    box->setObjectName(name);
    box->setToolTip(tip);
    connect(box, &QCheckBox::clicked, this, [this, set = std::move(set)](bool on) {
        Q_EMIT edited([set, on](SolveSettings &settings) { set(settings, on); }, true);
    });
    return box;
}

void UnwrapForm::setQuality(unwrap::UnwrapQuality quality)
{
    mQuality->setCurrentIndex(mQuality->findData(int(quality)));
}

void UnwrapForm::setRecognised(std::optional<double> hardShare)
{
    QString text = tr("Recognise");
    if (hardShare) {
        const int percent = static_cast<int>(std::lround(100 * *hardShare));
        text = percent == 0     ? tr("Recognise (organic)")
               : percent == 100 ? tr("Recognise (hard surface)")
                                : tr("Recognise (%1 % hard surface)").arg(percent);
    }
    mSurface->setItemText(mSurface->findData(int(SurfaceKind::Auto)), text);
}

void UnwrapForm::setSettings(const SolveSettings &settings)
{
    mSurface->setCurrentIndex(mSurface->findData(int(settings.surface)));
    enableOrSay(mFlat, settings.surface != SurfaceKind::Organic,
                tr("An organic surface has no flat faces to keep"));
    mStretch->setValue(settings.maxDistortion);
    mFlat->setChecked(settings.flat == FlatMode::Rigid && settings.surface != SurfaceKind::Organic);
    mAlike->setCurrentIndex(mAlike->findData(int(settings.alike)));
    mSymmetry->setCurrentIndex(mSymmetry->findData(int(settings.symmetry)));
    mHidden->setChecked(settings.visibility > 0);
    mSharp->setChecked(settings.creases != CreaseMode::Off);
    mAlign->setChecked(settings.align != CreaseMode::Off);
    mMirror->setChecked(settings.mirrorMaps);
    mUp->setCurrentIndex(mUp->findData(int(settings.worldUp)));
}

} // namespace autocuts
