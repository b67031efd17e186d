#include "views/panels/givenseamform.h"

#include "views/panels/controls.h"
#include "views/ui/reasons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

GivenSeamForm::GivenSeamForm(QWidget *parent) : QWidget(parent), mMode(new QComboBox), mSourceBox(new QWidget)
{
    auto *form = makeForm(this);
    mMode->setObjectName("seamMode"_L1);
    mMode->addItem(tr("Free"), int(SeamMode::Free));
    mMode->addItem(tr("Keep mine"), int(SeamMode::Keep));
    mMode->addItem(tr("Only mine"), int(SeamMode::Only));
    connect(mMode, &QComboBox::activated, this, [this] {
        const auto mode = SeamMode(mMode->currentData().toInt());
        Q_EMIT edited([mode](SolveSettings &settings) { settings.seams = mode; });
    });
    addRow(form, tr("Whose"), mMode,
           tr("Free: the search finds the seams. Keep mine: the seams given below stay, and the search adds "
              "what the distortion budget needs. Only mine: exactly the seams given below."));
    auto *sources = new QVBoxLayout(mSourceBox);
    sources->setContentsMargins(0, 0, 0, 0);
    sources->setSpacing(rowSpacing);
    sources->addWidget(
        addSource("seamCuts"_L1, tr("Forced cuts"), tr("Edges that you cut"), &GivenSeamOptions::cuts));
    sources->addWidget(addSource("seamMap"_L1, tr("Seams of the map"), tr("Seams of the map as it is now"),
                                 &GivenSeamOptions::map));
    sources->addWidget(makeSharpRow());
    sources->addWidget(addSource("seamHard"_L1, tr("Hard edges of the file"),
                                 tr("Edges that the model's file does not shade smoothly: between smoothing "
                                    "groups, or where the normals "
                                    "of the two sides differ"),
                                 &GivenSeamOptions::hard));
    sources->addWidget(addSource("seamMaterials"_L1, tr("Material borders"),
                                 tr("Edges between two materials. Borders of objects are seams in any case."),
                                 &GivenSeamOptions::materials));
    form->addRow(mSourceBox);
}

QCheckBox *GivenSeamForm::addSource(QLatin1StringView name, const QString &text, const QString &tip,
                                    bool GivenSeamOptions::*option)
{
    auto *box = new QCheckBox(text);
    box->setObjectName(name);
    box->setToolTip(tip);
    connect(box, &QCheckBox::clicked, this, [this, option](bool on) {
        Q_EMIT edited([option, on](SolveSettings &settings) { settings.givenSeams.*option = on; });
    });
    mSources.push_back({box, option});
    return box;
}

QWidget *GivenSeamForm::makeSharpRow()
{
    const QString tip = tr("Edges at which the model is bent by more than this angle");
    auto *box = addSource("seamSharp"_L1, tr("Edges sharper than"), tip, &GivenSeamOptions::sharp);
    mAngle = new QDoubleSpinBox;
    mAngle->setObjectName("sharpAngle"_L1);
    mAngle->setToolTip(tip);
    mAngle->setAccessibleName(box->text());
    mAngle->setRange(0, 180);
    mAngle->setDecimals(1);
    mAngle->setSingleStep(5);
    mAngle->setSuffix(tr("°"));
    mAngle->setKeyboardTracking(false);
    connect(mAngle, &QDoubleSpinBox::valueChanged, this, [this](double angle) {
        Q_EMIT edited([angle](SolveSettings &settings) { settings.givenSeams.sharpAngle = angle; });
    });
    return makeRow({box, mAngle}, RowWidths::AsNeeded);
}

void GivenSeamForm::setSettings(const SolveSettings &settings)
{
    mMode->setCurrentIndex(mMode->findData(int(settings.seams)));
    for (const Source &source : mSources)
        source.box->setChecked(settings.givenSeams.*source.option);
    const QSignalBlocker blocker(mAngle);
    mAngle->setValue(settings.givenSeams.sharpAngle);
    const bool given = settings.seams != SeamMode::Free;
    const QString why = tr("Free seams do not depend on it: choose those of yours, to keep or alone");
    for (const Source &source : mSources)
        enableOrSay(source.box, given, why);
    enableOrSay(mAngle, given, why);
}

} // namespace autocuts
