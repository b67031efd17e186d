#include "views/panels/seampreferenceform.h"

#include "views/panels/controls.h"
#include "views/panels/sliderspin.h"
#include "views/ui/reasons.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

SeamPreferenceForm::SeamPreferenceForm(QWidget *parent)
    : QWidget(parent), mCreases(new QComboBox),
      mCreaseStrength(makeShare("creaseStrength"_L1, &SolveSettings::creaseStrength)),
      mVisibility(makeShare("visibility"_L1, &SolveSettings::visibility))
{
    auto *form = makeForm(this);
    mCreases->setObjectName("creases"_L1);
    mCreases->addItem(tr("Off"), int(CreaseMode::Off));
    mCreases->addItem(tr("On creases"), int(CreaseMode::Auto));
    mCreases->addItem(tr("On"), int(CreaseMode::On));
    connect(mCreases, &QComboBox::activated, this, [this] {
        const auto mode = CreaseMode(mCreases->currentData().toInt());
        Q_EMIT edited([mode](SolveSettings &settings) { settings.creases = mode; }, true);
    });
    addRow(form, tr("Sharp edges"), mCreases,
           tr("Seams along sharp edges. On creases: where clear creases make up the sharp edges of the "
              "model."));
    addRow(form, tr("Strength"), mCreaseStrength,
           tr("Part of its cost that a seam on a sharp edge saves. Higher: seams leave the creases less "
              "often."));
    addRow(form, tr("Hide seams"), mVisibility,
           tr("Seams rather where the model hides them: in folds, between parts, underneath. 0 is no matter "
              "where."));
}

SliderSpin *SeamPreferenceForm::makeShare(QLatin1StringView name, double SolveSettings::*field)
{
    auto *box = new QDoubleSpinBox;
    box->setDecimals(2);
    box->setSingleStep(0.05);
    box->setKeyboardTracking(false);
    auto *spin = new SliderSpin(SliderScale::linear(0, 1), box);
    spin->setObjectName(name);
    connect(spin, &SliderSpin::edited, this, [this, field](double value, bool first) {
        Q_EMIT edited([field, value](SolveSettings &settings) { settings.*field = value; }, first);
    });
    return spin;
}

void SeamPreferenceForm::setSettings(const SolveSettings &settings)
{
    const QSignalBlocker blockCreases(mCreases);
    mCreases->setCurrentIndex(mCreases->findData(int(settings.creases)));
    mCreaseStrength->setValue(settings.creaseStrength);
    enableOrSay(mCreaseStrength, settings.creases != CreaseMode::Off, tr("Sharp edges do not count"));
    mVisibility->setValue(settings.visibility);
}

} // namespace autocuts
