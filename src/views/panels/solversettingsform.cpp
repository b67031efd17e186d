#include "views/panels/solversettingsform.h"

#include "views/panels/controls.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QSpinBox>

#include <limits>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

void select(QComboBox *box, int value)
{
    const QSignalBlocker blocker(box);
    box->setCurrentIndex(box->findData(value));
}

} // namespace

SolverSettingsForm::SolverSettingsForm(QWidget *parent)
    : QWidget(parent), mStart(new QComboBox), mEnergy(new QComboBox), mWeighting(new QComboBox),
      mSolver(new QComboBox), mBoxWeight(new QDoubleSpinBox), mSeed(new QSpinBox)
{
    auto *form = makeForm(this);
    addChoices(form);
    addNumbers(form);
    follow(mStart, [](SolveSettings &s, int value) { s.start = StartMode(value); });
    follow(mEnergy, [](SolveSettings &s, int value) { s.energy = DistortionEnergy(value); });
    follow(mWeighting, [](SolveSettings &s, int value) { s.weighting = SeamWeighting(value); });
    follow(mSolver, [](SolveSettings &s, int value) { s.solver = SolverKind(value); });
    connect(mBoxWeight, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        Q_EMIT edited([value](SolveSettings &settings) { settings.boxWeight = value; });
    });
    connect(mSeed, &QSpinBox::valueChanged, this, [this](int value) {
        Q_EMIT edited([value](SolveSettings &settings) { settings.seed = unsigned(value); });
    });
}

void SolverSettingsForm::addChoices(QFormLayout *form)
{
    mStart->setObjectName("start"_L1);
    mStart->addItem(tr("Rigid triangles"), int(StartMode::Rigid));
    mStart->addItem(tr("Tutte"), int(StartMode::Tutte));
    mStart->addItem(tr("Random"), int(StartMode::Random));
    mStart->addItem(tr("Existing UVs"), int(StartMode::ExistingUv));
    addRow(
        form, tr("Start"), mStart,
        tr("Where Restart begins. Rigid: every triangle apart and without distortion. Tutte: flattened with "
           "few cuts. Random: triangles thrown anywhere. Existing UVs: the map as it is."));
    mEnergy->setObjectName("energy"_L1);
    mEnergy->addItem(tr("Symmetric Dirichlet"), int(DistortionEnergy::SymmetricDirichlet));
    mEnergy->addItem(tr("Conformal (AMIPS)"), int(DistortionEnergy::Amips));
    addRow(
        form, tr("Distortion"), mEnergy,
        tr("What counts as distortion. Symmetric Dirichlet keeps lengths; conformal keeps angles. Both are 4 "
           "where nothing is distorted."));
    mWeighting->setObjectName("weighting"_L1);
    mWeighting->addItem(tr("Length of seams"), int(SeamWeighting::Length));
    mWeighting->addItem(tr("Number of seam edges"), int(SeamWeighting::Count));
    addRow(form, tr("Minimise"), mWeighting, tr("What is kept small besides the distortion."));
    mSolver->setObjectName("solverKind"_L1);
    mSolver->addItem(tr("Fast"), int(SolverKind::Fast));
    mSolver->addItem(tr("Exact"), int(SolverKind::Exact));
    addRow(form, tr("Solver"), mSolver,
           tr("Fast: an approximate Newton step, many times quicker. Exact: the full Newton step of the "
              "paper."));
}

void SolverSettingsForm::addNumbers(QFormLayout *form)
{
    mBoxWeight->setObjectName("boxWeight"_L1);
    mBoxWeight->setRange(0, 1e6);
    mBoxWeight->setDecimals(1);
    mBoxWeight->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    mBoxWeight->setKeyboardTracking(false);
    addRow(form, tr("Rectangles"), mBoxWeight,
           tr("Weight β of the energy that keeps islands inside their rectangles, 100 by default."));
    mSeed->setObjectName("seed"_L1);
    mSeed->setRange(0, std::numeric_limits<int>::max());
    mSeed->setKeyboardTracking(false);
    addRow(form, tr("Seed"), mSeed,
           tr("Another number gives another random start. The same number always gives the same map."));
}

void SolverSettingsForm::follow(QComboBox *box, void (*apply)(SolveSettings &, int))
{
    connect(box, &QComboBox::activated, this, [this, box, apply] {
        const int value = box->currentData().toInt();
        Q_EMIT edited([apply, value](SolveSettings &settings) { apply(settings, value); });
    });
}

void SolverSettingsForm::setSettings(const SolveSettings &settings)
{
    select(mStart, int(settings.start));
    select(mEnergy, int(settings.energy));
    select(mWeighting, int(settings.weighting));
    select(mSolver, int(settings.solver));
    const QSignalBlocker blockWeight(mBoxWeight);
    mBoxWeight->setValue(settings.boxWeight);
    const QSignalBlocker blockSeed(mSeed);
    mSeed->setValue(int(settings.seed & unsigned(std::numeric_limits<int>::max())));
}

} // namespace autocuts
