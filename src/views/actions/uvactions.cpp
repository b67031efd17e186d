#include "views/actions/uvactions.h"

#include "commands/changesettings.h"
#include "commands/editpins.h"
#include "commands/keepstraight.h"
#include "model/document/scenegroups.h"
#include "views/actions/choice.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/selecting/selecting.h"
#include "views/tools/pinning.h"
#include "views/ui/icons.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

constexpr Choice<StartMode> startChoices[] = {{"uv.start.rigid", StartMode::Rigid},
                                              {"uv.start.tutte", StartMode::Tutte},
                                              {"uv.start.random", StartMode::Random},
                                              {"uv.start.existing", StartMode::ExistingUv}};
constexpr Choice<DistortionEnergy> energyChoices[] = {
    {"uv.energy.symmetricDirichlet", DistortionEnergy::SymmetricDirichlet},
    {"uv.energy.amips", DistortionEnergy::Amips}};
constexpr Choice<SeamWeighting> weightingChoices[] = {{"uv.weighting.length", SeamWeighting::Length},
                                                      {"uv.weighting.count", SeamWeighting::Count}};

} // namespace

UvActions::UvActions(const StudioContext &context, QObject *parent) : QObject(parent), mContext(context)
{
    mTyping.setSingleShot(true);
    mTyping.setInterval(1000);
    connectSolver();
    connectJobs();
    connectSteering();
    connect(&context.solver, &SolverController::stateChanged, this, &UvActions::showState);
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        mAutomaticUntil.reset();
        showState();
    });
    connect(&context.workspace, &Workspace::historyChanged, this, &UvActions::takeUpHistory);
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::SolveSettings)
            showState();
    });
    showState();
}

//! Does nothing without a document.
template <typename Function>
void UvActions::onTriggered(const char *id, Function function)
{
    connect(mContext.actions.action(id), &QAction::triggered, this, [this, function] {
        if (mContext.workspace.document())
            function();
    });
}

template <typename Value>
void UvActions::connectSetting(const char *id, Value SolveSettings::*field, Value value)
{
    onTriggered(id, [this, field, value] {
        Document &document = *mContext.workspace.document();
        SolveSettings settings = document.solveSettings();
        settings.*field = value;
        pushCommand(std::make_unique<ChangeSettings>(document, settings));
    });
}

void UvActions::connectSolver()
{
    SolverController &solver = mContext.solver;
    onTriggered("uv.run", [&solver] { solver.toggle(); });
    onTriggered("uv.runSelection", [&solver] { solver.runOnSelection(); });
    onTriggered("uv.step", [&solver] { solver.step(); });
    onTriggered("uv.restart", [&solver] { solver.restart(); });
    onTriggered("uv.lambdaLess", [this] { changeLambda(-lambdaStep); });
    onTriggered("uv.lambdaMore", [this] { changeLambda(lambdaStep); });
    onTriggered("uv.deltaDouble", [this] { changeDelta(2); });
    onTriggered("uv.deltaHalve", [this] { changeDelta(0.5); });
    connect(mContext.actions.action("uv.budget"), &QAction::triggered, this, [this, &solver](bool checked) {
        mAutomaticUntil.reset();
        solver.setMode(checked ? homotopy::SolveMode::Budget : homotopy::SolveMode::Manual);
    });
    connect(mContext.actions.action("uv.soup"), &QAction::triggered, this,
            [&solver](bool checked) { solver.setLiveView(checked ? LiveView::Soup : LiveView::Map); });
    connect(mContext.actions.action("uv.ghost"), &QAction::triggered, this,
            [&solver](bool checked) { solver.setGhost(checked); });
    for (const auto &[id, value] : startChoices)
        connectSetting(id, &SolveSettings::start, value);
    for (const auto &[id, value] : energyChoices)
        connectSetting(id, &SolveSettings::energy, value);
    for (const auto &[id, value] : weightingChoices)
        connectSetting(id, &SolveSettings::weighting, value);
}

void UvActions::connectJobs()
{
    MapController &map = mContext.map;
    onTriggered("uv.unwrap", [&map] { map.unwrap(map.quality()); });
    const auto onSelection = [this, &map](const char *id, JobReach reach) {
        onTriggered(id, [&map, reach] { map.unwrap(map.quality(), reach); });
    };
    onSelection("uv.unwrapSelection", JobReach::SelectionAttached);
    onSelection("uv.unwrapSelectionFree", JobReach::SelectionFree);
    onTriggered("uv.finishSelection", [&map] { map.finish(JobReach::SelectionAttached); });
    onTriggered("uv.finish", [&map] { map.finish(); });
    onTriggered("uv.pack", [&map] { map.pack(PackScope::All); });
    onTriggered("uv.packObjects", [&map] { map.packEach(SceneKind::Objects); });
    onTriggered("uv.packMaterials", [&map] { map.packEach(SceneKind::Materials); });
    onTriggered("uv.packTags", [&map] { map.packEach(SceneKind::Tags); });
    onTriggered("uv.fillTiles", [&map] { map.fillTiles(); });
    onTriggered("uv.packSelection", [&map] { map.pack(PackScope::Selection); });
    onTriggered("uv.separate", [&map] { map.separateOverlaps(); });
    onTriggered("uv.separateGreedy", [&map] { map.separateGreedily(); });
    onTriggered("uv.density", [&map] { map.equalizeDensity(); });
    const auto selectedEdges = [this](auto edges) {
        const Document &document = *mContext.workspace.document();
        return edges(document, document.selection());
    };
    onTriggered("uv.rip", [&map, selectedEdges] { map.rip(selectedEdges(edgesToCut)); });
    onTriggered("uv.stitch", [&map, selectedEdges] { map.stitch(selectedEdges(edgesToJoin)); });
    connect(mContext.actions.action("uv.cancel"), &QAction::triggered, this, [this] {
        mContext.map.cancel();
        mContext.files.jobs().cancel();
    });
}

void UvActions::connectSteering()
{
    const auto connectSeams = [this](const char *id, SetSeamState::Edit edit, auto edges) {
        onTriggered(id, [this, edit, edges] {
            const Document &document = *mContext.workspace.document();
            setSeams(edit, edges(document, document.selection()));
        });
    };
    connectSeams("uv.cut", SetSeamState::Edit::Cut, edgesToCut);
    connectSeams("uv.join", SetSeamState::Edit::Join, edgesToJoin);
    connectSeams("uv.clearSteering", SetSeamState::Edit::Clear, edgesToClear);
    onTriggered("uv.keepStraight", [this] { keepStraight(true); });
    onTriggered("uv.releaseStraight", [this] { keepStraight(false); });
    onTriggered("uv.pin", [this] { pinSelected(); });
    onTriggered("uv.unpin", [this] { unpinSelected(); });
    const auto connectFlags = [this](const char *id, SetIslandFlags::Edit edit) {
        onTriggered(id, [this, edit] { setFlags(edit); });
    };
    connectFlags("uv.lock", SetIslandFlags::Edit::Lock);
    connectFlags("uv.unlock", SetIslandFlags::Edit::Unlock);
    connectFlags("uv.keepOrientation", SetIslandFlags::Edit::KeepOrientation);
    connectFlags("uv.freeOrientation", SetIslandFlags::Edit::FreeOrientation);
    connectFlags("uv.stack", SetIslandFlags::Edit::Stack);
    connectFlags("uv.unstack", SetIslandFlags::Edit::Unstack);
    connectFlags("uv.group", SetIslandFlags::Edit::Group);
    connectFlags("uv.ungroup", SetIslandFlags::Edit::Ungroup);
}

//! When the solver has chosen lambda and delta, the user continues from its values.
SolveSettings UvActions::settingsInEffect() const
{
    SolveSettings settings = mContext.workspace.document()->solveSettings();
    const SolverController &solver = mContext.solver;
    if (solver.mode() == homotopy::SolveMode::Budget && solver.status().iteration > 0) {
        settings.lambda = solver.status().lambda;
        settings.delta = solver.status().delta;
    }
    return settings;
}

void UvActions::changeLambda(double change)
{
    SolveSettings settings = settingsInEffect();
    // Rounded, so that equally many steps up and down give the original value.
    const double lambda = std::clamp(std::round((settings.lambda + change) * 1e9) / 1e9, 0.0, 1.0);
    if (lambda == settings.lambda) {
        Q_EMIT mContext.map.done(tr("Lambda is %1 already and cannot go further").arg(lambda));
        return;
    }
    settings.lambda = lambda;
    setByHand(settings);
}

void UvActions::changeDelta(double factor)
{
    SolveSettings settings = settingsInEffect();
    const double delta = std::clamp(settings.delta * factor, minDelta, maxDelta);
    if (delta == settings.delta) {
        Q_EMIT mContext.map.done(tr("Delta is %1 already and cannot go further").arg(delta));
        return;
    }
    settings.delta = delta;
    setByHand(settings);
}

//! Ends the choice by the solver. Undo brings it back.
void UvActions::setByHand(const SolveSettings &settings)
{
    const bool automatic = mContext.solver.mode() == homotopy::SolveMode::Budget;
    mContext.solver.setMode(homotopy::SolveMode::Manual);
    pushTyped(settings);
    if (!automatic)
        return;
    mAutomaticUntil = mTypedIndex - 1;
    Q_EMIT mContext.map.done(
        tr("Lambda and delta are set by hand now: undo, or %1, leaves them to the solver")
            .arg(mContext.actions.nameWithKeys("uv.budget")));
}

void UvActions::takeUpHistory()
{
    const Document *document = mContext.workspace.document();
    if (!document || !mAutomaticUntil || document->undoStack().index() > *mAutomaticUntil)
        return;
    mAutomaticUntil.reset();
    mContext.solver.setMode(homotopy::SolveMode::Budget);
}

//! Presses in quick succession become one entry.
void UvActions::pushTyped(const SolveSettings &settings)
{
    Document &document = *mContext.workspace.document();
    if (!mTyping.isActive() || document.undoStack().index() != mTypedIndex)
        mTypedGesture = document.undoStack().newGesture();
    auto command = std::make_unique<ChangeSettings>(document, settings);
    command->setGesture(mTypedGesture);
    pushCommand(std::move(command));
    mTypedIndex = document.undoStack().index();
    mTyping.start();
}

void UvActions::setSeams(SetSeamState::Edit edit, const QList<int> &edges)
{
    Document &document = *mContext.workspace.document();
    const IndexRanges pairs = cornerPairsOfEdges(document.mesh(), {edges.data(), std::size_t(edges.size())});
    pushCommand(std::make_unique<SetSeamState>(document, edit, pairs));
}

void UvActions::keepStraight(bool on)
{
    Document &document = *mContext.workspace.document();
    const QList<int> &edges = document.selection().edges;
    const IndexRanges pairs = cornerPairsOfEdges(document.mesh(), {edges.data(), std::size_t(edges.size())});
    pushCommand(std::make_unique<KeepStraight>(document, on, pairs));
}

void UvActions::setFlags(SetIslandFlags::Edit edit)
{
    Document &document = *mContext.workspace.document();
    const std::vector<int> islands = document.islands().islandsOf(facesOf(document, document.selection()));
    if (!islands.empty() && !pushCommand(std::make_unique<SetIslandFlags>(document, edit, islands)))
        Q_EMIT mContext.map.done(tr("Nothing to do: the selected islands are so already"));
}

void UvActions::pinSelected()
{
    Document &document = *mContext.workspace.document();
    const QList<int> corners = cornersOf(document, document.selection());
    const std::vector<UvPin> pins = pinsAt(document.mesh(), mContext.shownMap.uv(), corners);
    pushCommand(std::make_unique<EditPins>(document, EditPins::Edit::Pin, pins));
}

void UvActions::unpinSelected()
{
    Document &document = *mContext.workspace.document();
    const QList<int> corners = cornersOf(document, document.selection());
    pushCommand(EditPins::unpin(document, {corners.data(), std::size_t(corners.size())}));
}

void UvActions::showState()
{
    const bool running = mContext.solver.isRunning();
    QAction *const run = mContext.actions.action("uv.run");
    run->setText(running ? tr("&Pause") : tr("&Run"));
    run->setIconText(running ? tr("Pause") : tr("Run"));
    run->setIcon(icon(running ? QStringLiteral("pause") : QStringLiteral("run")));
    mContext.actions.action("uv.budget")->setChecked(mContext.solver.mode() == homotopy::SolveMode::Budget);
    mContext.actions.action("uv.soup")->setChecked(mContext.solver.liveView() == LiveView::Soup);
    mContext.actions.action("uv.ghost")->setChecked(mContext.solver.ghost());
    const Document *document = mContext.workspace.document();
    const SolveSettings settings = document ? document->solveSettings() : SolveSettings();
    showChoice(mContext.actions, startChoices, settings.start);
    showChoice(mContext.actions, energyChoices, settings.energy);
    showChoice(mContext.actions, weightingChoices, settings.weighting);
}

} // namespace autocuts
