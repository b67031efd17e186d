#include "views/panels/solverpanel.h"

#include "views/actions/actionregistry.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/panels/convergencegraph.h"
#include "views/panels/deltaspinbox.h"
#include "views/panels/foldsection.h"
#include "views/panels/mapoutcome.h"
#include "views/panels/presetmenu.h"
#include "views/panels/seampreferenceform.h"
#include "views/panels/sliderspin.h"
#include "views/panels/solversettingsform.h"
#include "views/panels/unwrapform.h"
#include "views/ui/icons.h"
#include "views/ui/numbertext.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int smallestDelta = -24, largestDelta = 2; //!< exponents of two

QString liveText(const unwrap::LiveMapResult &map)
{
    return figureLine(
        SolverPanel::tr("Live map: D %1, seams %2, islands: %3")
            .arg(fixedText(map.distortion, 3), fixedText(map.seamLength, 2), countText(map.islands)));
}

} // namespace

SolverPanel::SolverPanel(const StudioContext &context, Questions &questions, QWidget *parent)
    : Panel(context, tr("Open a model to unwrap it."), parent)
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing + 2);
    layout->addWidget(makeUnwrapForm());
    layout->addWidget(makePresets(questions));
    layout->addWidget(makeOutcomeRow());
    layout->addWidget(makeHeading(tr("Live")));
    layout->addWidget(makeRunButtons());
    auto *modes = new QWidget;
    addModeRows(makeForm(modes));
    layout->addWidget(modes);
    mAdvanced = new FoldSection(tr("Advanced"), makeAdvanced());
    mAdvanced->setObjectName("advanced"_L1);
    layout->addWidget(mAdvanced);
    layout->addStretch();
    connectSolver();
}

QWidget *SolverPanel::makeUnwrapForm()
{
    mUnwrap = new UnwrapForm;
    explain(mUnwrap->button(), tr("Make a packed map automatically, within the stretch that is allowed"),
            {"uv.unwrap"});
    mUnwrap->button()->setIcon(accentIcon(u"unwrap"_s));
    connect(mUnwrap, &UnwrapForm::edited, this, &SolverPanel::applyEdit);
    connect(mUnwrap, &UnwrapForm::qualityChosen, &context().map, &MapController::setQuality);
    connect(mUnwrap, &UnwrapForm::unwrapRequested, &context().map,
            [this] { context().map.unwrap(context().map.quality()); });
    return mUnwrap;
}

QWidget *SolverPanel::makePresets(Questions &questions)
{
    QPushButton *button = makeButton(tr("Presets"), "presets"_L1);
    button->setToolTip(tr("Settings of this panel and of Packing under a name, also for the command line"));
    auto *menu = new PresetMenu(context(), questions, button);
    button->setMenu(menu);
    connect(menu, &PresetMenu::applied, this, [this](const QString &message) {
        mUnwrap->setQuality(context().map.quality());
        Q_EMIT said(message);
    });
    return button;
}

QWidget *SolverPanel::makeOutcomeRow()
{
    mOutcome = makeRemark();
    mOutcome->setObjectName("outcome"_L1);
    mNext = makeButton({}, "next"_L1);
    mNext->setToolTip(tr("What usually comes next"));
    connect(mNext, &QPushButton::clicked, this, [this] { context().actions.action(mNextAction)->trigger(); });
    auto *row = new QWidget;
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(rowSpacing);
    layout->addWidget(mOutcome, 1);
    layout->addWidget(mNext);
    return row;
}

QWidget *SolverPanel::makeAdvanced()
{
    auto *box = new QWidget;
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(rowSpacing + 2);
    auto *controls = new QWidget;
    addSliderRows(makeForm(controls));
    layout->addWidget(controls);
    mGraph = new ConvergenceGraph;
    mGraph->setObjectName("graph"_L1);
    mGraph->setMinimumHeight(140);
    mGraph->setMaximumHeight(260);
    layout->addWidget(mGraph, 1);
    layout->addWidget(makeReadOut());
    layout->addWidget(makeHeading(tr("Seam preferences")));
    mPreference = new SeamPreferenceForm;
    mPreference->setObjectName("preference"_L1);
    connect(mPreference, &SeamPreferenceForm::edited, this, &SolverPanel::applyEdit);
    layout->addWidget(mPreference);
    layout->addWidget(makeHeading(tr("Settings")));
    mSettings = new SolverSettingsForm;
    mSettings->setObjectName("settings"_L1);
    connect(mSettings, &SolverSettingsForm::edited, this,
            [this](const std::function<void(SolveSettings &)> &edit) { changeSolveSettings(edit); });
    layout->addWidget(mSettings);
    return box;
}

QWidget *SolverPanel::makeRunButtons()
{
    SolverController &solver = context().solver;
    mRun = makeButton(tr("Run"), "run"_L1);
    mStep = makeButton(tr("Step"), "step"_L1);
    mRestart = makeButton(tr("Restart"), "restart"_L1);
    explain(mRun, tr("Start or pause the solver"), {"uv.run"});
    explain(mStep, tr("Do one Newton step"), {"uv.step"});
    explain(mRestart, tr("Begin anew from the start chosen below"), {"uv.restart"});
    // The width must not change with the text.
    mRun->setMinimumWidth(mRun->fontMetrics().horizontalAdvance(tr("Pause")) + 40);
    connect(mRun, &QPushButton::clicked, &solver, &SolverController::toggle);
    connect(mStep, &QPushButton::clicked, &solver, &SolverController::step);
    connect(mRestart, &QPushButton::clicked, &solver, &SolverController::restart);
    mFinish = makeButton(tr("Finish"), "finish"_L1);
    explain(
        mFinish,
        tr("Turn the map into a final one: definite seams, no overlaps, within the stretch that is allowed"),
        {"uv.finish"});
    connect(mFinish, &QPushButton::clicked, this, [this] { context().map.finish(); });
    return makeRow({mRun, mStep, mRestart, mFinish});
}

void SolverPanel::addModeRows(QFormLayout *form)
{
    mManual = new QRadioButton(tr("Manual"));
    mBudget = new QRadioButton(tr("Automatic"));
    mManual->setObjectName("manual"_L1);
    mBudget->setObjectName("budget"_L1);
    SolverController &solver = context().solver;
    connect(mManual, &QRadioButton::clicked, this, &SolverPanel::takeOverByHand);
    connect(mBudget, &QRadioButton::clicked, this,
            [&solver] { solver.setMode(homotopy::SolveMode::Budget); });
    QWidget *row = makeRow({mBudget, mManual}, RowWidths::AsNeeded);
    row->setFocusProxy(mBudget);
    addRow(form, tr("Mode"), row, tr("Who chooses lambda and delta"));
    mManual->setToolTip(tr("You choose lambda and delta"));
    mBudget->setToolTip(tr("The solver finds the shortest seams whose map stays within a distortion bound"));

    mShowMap = new QRadioButton(tr("Map"));
    mShowSoup = new QRadioButton(tr("Soup"));
    mGhost = new QCheckBox(tr("Ghost"));
    mShowMap->setObjectName("showMap"_L1);
    mShowSoup->setObjectName("showSoup"_L1);
    mGhost->setObjectName("ghost"_L1);
    connect(mShowMap, &QRadioButton::clicked, this, [&solver] { solver.setLiveView(LiveView::Map); });
    connect(mShowSoup, &QRadioButton::clicked, this, [&solver] { solver.setLiveView(LiveView::Soup); });
    connect(mGhost, &QCheckBox::clicked, this, [&solver](bool on) { solver.setGhost(on); });
    QWidget *views = makeRow({mShowMap, mShowSoup, mGhost}, RowWidths::AsNeeded);
    views->setFocusProxy(mShowMap);
    addRow(form, tr("Show"), views, tr("What the views show while the solver runs"));
    explain(mShowMap, tr("The definite map: valid at every moment. Pause puts it into the document"),
            {"uv.soup"});
    explain(mShowSoup, tr("The separate triangles that lambda and delta act on; Finish makes a map of them"),
            {"uv.soup"});
    explain(mGhost, tr("The other one shines through in the UV view"), {"uv.ghost"});
}

//! From now on the user chooses lambda and delta, beginning with the values in effect.
void SolverPanel::takeOverByHand()
{
    SolverController &solver = context().solver;
    if (solver.mode() == homotopy::SolveMode::Manual)
        return;
    const live::SolveStatus status = solver.status();
    solver.setMode(homotopy::SolveMode::Manual);
    mWasManual = true;
    mAdvanced->setOpen(true);
    if (status.iteration > 0) {
        changeSolveSettings([&status](SolveSettings &settings) {
            settings.lambda = std::clamp(status.lambda, 0.0, 1.0);
            settings.delta = std::clamp(status.delta, std::exp2(smallestDelta), std::exp2(largestDelta));
        });
    }
}

void SolverPanel::addSliderRows(QFormLayout *form)
{
    auto *lambdaBox = new QDoubleSpinBox;
    lambdaBox->setDecimals(4);
    lambdaBox->setSingleStep(0.01);
    mLambda = new SliderSpin(SliderScale::fineNearMinimum(0, 1), lambdaBox);
    mLambda->setObjectName("lambda"_L1);
    connect(mLambda, &SliderSpin::edited, this, [this](double value, bool first) {
        changeSolveSettings([value](SolveSettings &settings) { settings.lambda = value; }, gestureFor(first));
    });
    const QString lambdaTip = tr("Balance of the energy (1 − λ) D + λ S: 0 is no distortion, 1 is no seams");
    explain(addRow(form, tr("Lambda λ"), mLambda, lambdaTip), lambdaTip, {"uv.lambdaLess", "uv.lambdaMore"});
    explain(mLambda, lambdaTip, {"uv.lambdaLess", "uv.lambdaMore"});

    mDelta = new SliderSpin(SliderScale::powersOfTwo(smallestDelta, largestDelta), new DeltaSpinBox);
    mDelta->setObjectName("delta"_L1);
    connect(mDelta, &SliderSpin::edited, this, [this](double value, bool first) {
        changeSolveSettings([value](SolveSettings &settings) { settings.delta = value; }, gestureFor(first));
    });
    const QString deltaTip =
        tr("How sharply an edge is either cut or joined: begin with 1 and halve it as the map settles");
    explain(addRow(form, tr("Delta δ"), makeDeltaRow(), deltaTip), deltaTip,
            {"uv.deltaHalve", "uv.deltaDouble"});
    explain(mDelta, deltaTip, {"uv.deltaHalve", "uv.deltaDouble"});
}

QWidget *SolverPanel::makeDeltaRow()
{
    mHalve = makeButton(u"½"_s, "halve"_L1);
    mDouble = makeButton(u"×2"_s, "double"_L1);
    explain(mHalve, tr("Halve delta: sharper cuts"), {"uv.deltaHalve"});
    explain(mDouble, tr("Double delta: softer cuts"), {"uv.deltaDouble"});
    for (QPushButton *button : {mHalve, mDouble}) {
        button->setMinimumWidth(button->fontMetrics().horizontalAdvance(u"×2"_s) + 10);
        button->setMaximumWidth(button->minimumWidth());
    }
    connect(mHalve, &QPushButton::clicked, this, [this] { scaleDelta(0.5); });
    connect(mDouble, &QPushButton::clicked, this, [this] { scaleDelta(2); });
    auto *row = new QWidget;
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(rowSpacing);
    layout->addWidget(mDelta, 1);
    layout->addWidget(mHalve);
    layout->addWidget(mDouble);
    row->setFocusProxy(mDelta);
    return row;
}

void SolverPanel::applyEdit(const std::function<void(SolveSettings &)> &edit, bool first)
{
    changeSolveSettings(edit, gestureFor(first));
}

void SolverPanel::scaleDelta(double factor)
{
    changeSolveSettings([factor](SolveSettings &settings) {
        settings.delta =
            std::clamp(settings.delta * factor, std::exp2(smallestDelta), std::exp2(largestDelta));
    });
}

QWidget *SolverPanel::makeReadOut()
{
    auto *box = new QWidget;
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    mState = new QLabel;
    mState->setObjectName("state"_L1);
    grid->addWidget(mState, 0, 0, 1, 5);
    const auto add = [&](int row, int column, const QString &caption, const QString &tip) {
        mFigures.push_back(addFigure(grid, row, column, caption, tip));
    };
    add(1, 0, tr("Iteration"), tr("Newton steps since the start"));
    add(1, 3, tr("Per second"), tr("Newton steps per second"));
    add(2, 0, tr("Energy E"), tr("(1 − λ) D + λ S, and the energy of pins and rectangles"));
    add(2, 3, tr("Islands"), tr("Islands that joining the nearly joined edges gives"));
    add(3, 0, tr("Distortion D"),
        tr("Area-weighted mean of the distortion energy, 4 where nothing is distorted"));
    add(3, 3, tr("Lambda λ"), tr("In effect; the distortion budget chooses it by itself"));
    add(4, 0, tr("Separation S"), tr("Smoothed length of the seams, on the mesh scaled to area π"));
    add(4, 3, tr("Delta δ"), tr("In effect; the distortion budget chooses it by itself"));
    add(5, 0, tr("Seam length"),
        tr("Length of the edges nearer to cut than to joined, on the mesh scaled to area π"));
    grid->setColumnMinimumWidth(2, 8);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(4, 1);
    return box;
}

void SolverPanel::connectSolver()
{
    connect(&context().workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::SolveSettings)
            refreshSoon();
    });
    connect(&context().solver, &SolverController::stateChanged, this, [this] { refreshSoon(); });
    connect(&context().solver, &SolverController::statusChanged, this, [this] { refreshSoon(); });
    connect(&context().map.jobs(), &JobRunner::busyChanged, this, [this] { refreshSoon(); });
    connect(&context().map, &MapController::figuresChanged, this, [this] { refreshSoon(); });
}

void SolverPanel::refresh()
{
    const SolveSettings settings = document() ? document()->solveSettings() : SolveSettings();
    showEnergyBalance(settings);
    mUnwrap->setSettings(settings);
    const unwrap::LiveMapResult *live = context().solver.map().get();
    mUnwrap->setRecognised(context().map.hardShare()                       ? context().map.hardShare()
                           : live && settings.surface == SurfaceKind::Auto ? std::optional(live->hardShare)
                                                                           : std::nullopt);
    mPreference->setSettings(settings);
    mSettings->setSettings(settings);
    showState();
    showStatus();
    showOutcome(settings);
}

void SolverPanel::showEnergyBalance(const SolveSettings &settings)
{
    // In budget mode, the values chosen by the solver are shown.
    const SolverController &solver = context().solver;
    const bool own = solver.mode() == homotopy::SolveMode::Budget && solver.status().iteration > 0;
    mLambda->setValue(own ? solver.status().lambda : settings.lambda);
    mDelta->setValue(own ? solver.status().delta : settings.delta);
}

void SolverPanel::showState()
{
    const SolverController &solver = context().solver;
    const bool manual = solver.mode() == homotopy::SolveMode::Manual;
    mRun->setText(solver.isRunning() ? tr("Pause") : tr("Run"));
    mRun->setIcon(icon(solver.isRunning() ? u"pause"_s : u"run"_s));
    (manual ? mManual : mBudget)->setChecked(true);
    (solver.liveView() == LiveView::Soup ? mShowSoup : mShowMap)->setChecked(true);
    mGhost->setChecked(solver.ghost());
    for (QWidget *widget : std::initializer_list<QWidget *>{mLambda, mDelta, mHalve, mDouble})
        widget->setEnabled(manual);
    const bool idle = !context().map.jobs().isBusy();
    for (QWidget *widget : {mRun, mStep, mRestart, mFinish, mUnwrap->button()})
        widget->setEnabled(idle);
    if (manual && !std::exchange(mWasManual, true))
        mAdvanced->setOpen(true);
    mWasManual = manual;
}

void SolverPanel::showOutcome(const SolveSettings &settings)
{
    MapController &map = context().map;
    MapOutcome outcome;
    if (map.isPreviewing())
        outcome = {map.jobs().stage(), ""};
    else if (context().solver.isRunning() && context().solver.map())
        outcome = {liveText(*context().solver.map()), "uv.run"};
    else if (document() && map.figures() && map.figuresAreFresh() && !map.jobs().isBusy())
        outcome = outcomeOf(*document(), *map.figures(), settings.maxDistortion);
    mOutcome->setText(outcome.text);
    mNextAction = outcome.nextAction;
    mNext->setVisible(*mNextAction != '\0');
    if (*mNextAction == '\0')
        return;
    const QAction *action = context().actions.action(mNextAction);
    mNext->setText(action->iconText());
    mNext->setIcon(action->icon());
    mNext->setMinimumWidth(mNext->sizeHint().width());
}

void SolverPanel::showStatus()
{
    const SolverController &solver = context().solver;
    mGraph->setTrace(solver.trace());
    const live::SolveStatus status = solver.status();
    mState->setText(!document()            ? QString()
                    : solver.isRunning()   ? (status.converged     ? tr("Converged")
                                              : solver.isLimited() ? tr("Running on the selection")
                                                                   : tr("Running"))
                    : solver.isPausing()   ? tr("Waiting for a map that obeys the steering")
                    : solver.canContinue() ? (status.converged ? tr("Done") : tr("Paused"))
                                           : tr("Ready"));
    const bool none = status.iteration == 0;
    const auto text = [none](const QString &value) { return none ? missingText() : value; };
    const QString texts[] = {
        text(countText(status.iteration)),
        solver.isRunning() && status.stepsPerSecond > 0 ? fixedText(status.stepsPerSecond, 1) : missingText(),
        text(fixedText(status.energy, 4)),
        text(countText(status.islands)),
        text(fixedText(status.distortion, 4)),
        text(fixedText(status.lambda, 4)),
        text(fixedText(status.separation, 3)),
        text(significantText(status.delta, 4)),
        text(fixedText(status.seamLength, 3))};
    for (std::size_t i = 0; i < mFigures.size(); ++i)
        mFigures[i]->setText(texts[i]);
}

} // namespace autocuts
