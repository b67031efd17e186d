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
    const auto add = [form](const QString &label, QWidget *field, QLatin1StringView name,
                            const QString &tip) {
        field->setObjectName(name);
        addRow(form, label, field, tip);
    };
    mStart->addItem(tr("Rigid triangles"), int(StartMode::Rigid));
    mStart->addItem(tr("Tutte"), int(StartMode::Tutte));
    mStart->addItem(tr("Random"), int(StartMode::Random));
    mStart->addItem(tr("Existing UVs"), int(StartMode::ExistingUv));
    add(tr("Start"), mStart, "start"_L1,
        tr("Where Restart begins. Rigid: every triangle apart and without distortion. Tutte: flattened with "
           "few "
           "cuts. Random: triangles thrown anywhere. Existing UVs: the map as it is."));
    mEnergy->addItem(tr("Symmetric Dirichlet"), int(DistortionEnergy::SymmetricDirichlet));
    mEnergy->addItem(tr("Conformal (AMIPS)"), int(DistortionEnergy::Amips));
    add(tr("Distortion"), mEnergy, "energy"_L1,
        tr("What counts as distortion. Symmetric Dirichlet keeps lengths; conformal keeps angles. Both are 4 "
           "where "
           "nothing is distorted."));
    mWeighting->addItem(tr("Length of seams"), int(SeamWeighting::Length));
    mWeighting->addItem(tr("Number of seam edges"), int(SeamWeighting::Count));
    add(tr("Minimise"), mWeighting, "weighting"_L1, tr("What is kept small besides the distortion."));
    mSolver->addItem(tr("Fast"), int(SolverKind::Fast));
    mSolver->addItem(tr("Exact"), int(SolverKind::Exact));
    add(tr("Solver"), mSolver, "solverKind"_L1,
        tr("Fast: an approximate Newton step, many times quicker. Exact: the full Newton step of the "
           "paper."));
    mBoxWeight->setRange(0, 1e6);
    mBoxWeight->setDecimals(1);
    mBoxWeight->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    mBoxWeight->setKeyboardTracking(false);
    add(tr("Rectangles"), mBoxWeight, "boxWeight"_L1,
        tr("Weight β of the energy that keeps islands inside their rectangles, 100 by default."));
    mSeed->setRange(0, std::numeric_limits<int>::max());
    mSeed->setKeyboardTracking(false);
    add(tr("Seed"), mSeed, "seed"_L1,
        tr("Another number gives another random start. The same number always gives the same map."));

    const auto follow = [this](QComboBox *box, auto apply) {
        connect(box, &QComboBox::activated, this, [this, box, apply] {
            const int value = box->currentData().toInt();
            Q_EMIT edited([apply, value](SolveSettings &settings) { apply(settings, value); });
        });
    };
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
