#include "views/control/live/solvercontroller.h"

#include "commands/changesettings.h"
#include "commands/newmap.h"
#include "jobs/mapremarks.h"
#include "model/document/makesnapshot.h"
#include "solver/packing/packmap.h"
#include "views/control/mapjobs/mapjobs.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/ui/numbertext.h"

namespace autocuts {

SolverController::SolverController(Workspace &workspace, ShownMap &shownMap, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mShownMap(shownMap), mWorker(new live::SolveWorker),
      mKeeper(new live::MapKeeper), mDisplay(workspace, shownMap)
{
    mThread.setObjectName(QStringLiteral("solver"));
    mKeeperThread.setObjectName(QStringLiteral("map keeper"));
    mWorker->moveToThread(&mThread);
    mKeeper->moveToThread(&mKeeperThread);
    connect(&mThread, &QThread::finished, mWorker, &QObject::deleteLater);
    connect(&mKeeperThread, &QThread::finished, mKeeper, &QObject::deleteLater);
    connect(mWorker, &live::SolveWorker::resultReady, this, &SolverController::takeResult);
    connect(mWorker, &live::SolveWorker::waiting, this, &SolverController::workerWaits);
    connect(mWorker, &live::SolveWorker::failed, this, [this] { fail(mWorker->takeFailure()); });
    connect(mKeeper, &live::MapKeeper::mapReady, this, &SolverController::takeMap);
    connect(mKeeper, &live::MapKeeper::rests, this, &SolverController::keeperRests);
    connect(mKeeper, &live::MapKeeper::rests, this, &SolverController::workerRests, Qt::DirectConnection);
    connect(mKeeper, &live::MapKeeper::failed, this, [this] { fail(mKeeper->takeFailure()); });
    connect(&workspace, &Workspace::documentReplaced, this, &SolverController::documentReplaced);
    connect(&workspace, &Workspace::changed, this, &SolverController::documentChanged);
    connect(&mDisplay, &LiveDisplay::arranged, this, &SolverController::showResult);
    mSendSoon.setSingleShot(true);
    mSendSoon.setInterval(0);
    connect(&mSendSoon, &QTimer::timeout, this, [this] { sendSnapshot(); });
    mThread.start();
    mKeeperThread.start();
}

SolverController::~SolverController()
{
    mWorker->pause();
    mKeeper->pause();
    for (QThread *thread : {&mThread, &mKeeperThread})
        thread->quit();
    for (QThread *thread : {&mThread, &mKeeperThread})
        thread->wait();
}

bool SolverController::canContinue() const
{
    return mToken.has_value();
}

void SolverController::setMode(homotopy::SolveMode mode)
{
    if (mode == mMode)
        return;
    const live::SolveStatus before = mDisplay.soupStatus();
    mMode = mode;
    mWorker->setMode(mMode);
    if (mMode == homotopy::SolveMode::Manual && mDisplay.soupRan() && before.iteration > 0) {
        SolveSettings settings = mWorkspace.document()->solveSettings();
        settings.lambda = before.lambda;
        settings.delta = before.delta;
        pushCommand(std::make_unique<ChangeSettings>(*mWorkspace.document(), settings));
    }
    mSendSoon.start();
    // By hand, the soup is steered, over the map that a pause puts into the document.
    const bool byHand = mMode == homotopy::SolveMode::Manual;
    mDisplay.setGhost(byHand);
    setLiveView(byHand ? LiveView::Soup : LiveView::Map);
    Q_EMIT stateChanged();
}

void SolverController::setLiveView(LiveView view)
{
    if (view == mDisplay.view())
        return;
    mDisplay.setView(view);
    runSoup();
    showResult();
    Q_EMIT stateChanged();
    Q_EMIT statusChanged();
}

void SolverController::setGhost(bool ghost)
{
    if (ghost == mDisplay.ghost())
        return;
    mDisplay.setGhost(ghost);
    runSoup();
    showResult();
    Q_EMIT stateChanged();
}

void SolverController::whenPaused(std::function<void()> then)
{
    if (mRunning)
        pause();
    if (mPausing)
        mWhenPaused.push_back(std::move(then));
    else
        then();
}

void SolverController::setPulls(std::vector<Pin> pulls, std::vector<int> dragged)
{
    if (!mRunning || (pulls.empty() && mPulls.empty()))
        return;
    if (mPulls.empty()) {
        mBeforePulls = mDisplay.soup();
        mMapBeforePulls = mDisplay.map();
    }
    mPulls = std::move(pulls);
    mDragged = std::move(dragged);
    mSendSoon.start();
}

void SolverController::cancelPulls()
{
    if (mPulls.empty())
        return;
    setPulls({});
    mSendSoon.stop();
    // Both changes are sent together: a solve without pulls could otherwise come to rest in the pulled
    // position.
    sendSnapshot(true);
    // A pause must not find the pulled map.
    if (mMapBeforePulls && mToken && mMapBeforePulls->token == *mToken) {
        mDisplay.take(mMapBeforePulls);
        showResult();
        Q_EMIT statusChanged();
    }
}

void SolverController::run()
{
    if (!mWorkspace.document() || mRunning)
        return;
    setScope(nullptr);
    goOn();
}

void SolverController::runOnSelection()
{
    const Document *document = mWorkspace.document();
    if (!document || document->selection().faces.isEmpty())
        return;
    // What runs is put into the document first: the rest keeps that map.
    whenPaused([this, limit = scopeOf(document->mesh(), document->selection().faces, true)] {
        setScope(limit);
        goOn();
    });
}

//! Other faces may change from now on; a solve of the faces before is over.
void SolverController::setScope(std::shared_ptr<const JobScope> scope)
{
    if (scope || mScope)
        discard();
    mScope = std::move(scope);
}

//! Continues the solve, or begins one.
void SolverController::goOn()
{
    if (!mToken)
        beginWhereTheMapIs();
    mStepping = false;
    mMapRests = false;
    setRunning(true, false);
    mKeeper->run();
    runSoup();
}

//! The soup is stepped only while it can be seen.
void SolverController::runSoup()
{
    if (!mRunning || mStepping)
        return;
    if (mDisplay.seesSoup()) {
        mDisplay.setSoupRan();
        mWorker->run();
    } else {
        mWorker->pause();
    }
}

void SolverController::pause()
{
    if (!mRunning)
        return;
    mWorker->pause();
    setRunning(false, true);
    takeMap();
    // Edits of this turn of the event loop have not been sent yet.
    if (mSendSoon.isActive()) {
        mSendSoon.stop();
        sendSnapshot();
    }
    endPause(mMapRests); // no other map will come then
}

void SolverController::pauseAtOnce()
{
    pause();
    endPause(true);
}

void SolverController::toggle()
{
    if (mRunning)
        pause();
    else
        run();
}

void SolverController::step()
{
    if (!mWorkspace.document())
        return;
    if (!mToken)
        beginWhereTheMapIs();
    // waiting() is emitted at the end of the step.
    setLiveView(LiveView::Soup);
    mDisplay.setSoupRan();
    mStepping = true;
    setRunning(true, false);
    mKeeper->run();
    mWorker->runSteps(1);
}

void SolverController::restart()
{
    const Document *document = mWorkspace.document();
    if (!document)
        return;
    setScope(nullptr);
    begin(document->solveSettings().start);
    mStepping = false;
    setRunning(true, false);
    mKeeper->run();
    runSoup();
}

void SolverController::discard()
{
    mScope.reset();
    if (!mToken)
        return;
    mWorker->pause();
    mKeeper->pause();
    mToken.reset();
    mDisplay.clear();
    mWhenPaused.clear();
    mShownMap.showDocument();
    setRunning(false, false);
    Q_EMIT statusChanged();
}

//! An existing map is refined instead of made anew.
void SolverController::beginWhereTheMapIs()
{
    const Document &document = *mWorkspace.document();
    const bool map = hasUvs(document);
    begin(map ? StartMode::ExistingUv : document.solveSettings().start, map);
}

void SolverController::begin(StartMode start, bool warm)
{
    const Document &document = *mWorkspace.document();
    auto snapshot = std::make_shared<Snapshot>(makeSnapshot(document, start));
    snapshot->scope = mScope;
    mToken = snapshot->token;
    mDisplay.clear();
    mBeforePulls.reset();
    mMapBeforePulls.reset();
    mMapRests = false;
    mWorker->setMode(mMode);
    // Places the map at the centre of the first tile.
    const Vec2 centre = Vec2(0.5, 0.5 * snapshot->tileHeight) / document.uvScale();
    mWorker->start(snapshot, centre, warm);
    mKeeper->start(snapshot, mapOptions());
    Q_EMIT statusChanged();
}

unwrap::LiveMapOptions SolverController::mapOptions() const
{
    const Document &document = *mWorkspace.document();
    unwrap::LiveMapOptions options;
    options.maxDistortion = document.solveSettings().maxDistortion;
    options.packing = packing::tileOptions(document.packingSettings());
    options.dragged = mDragged;
    return options;
}

void SolverController::setRunning(bool running, bool pausing)
{
    if (running == mRunning && pausing == mPausing)
        return;
    mRunning = running;
    mPausing = pausing;
    if (!mRunning && !mPulls.empty()) {
        mPulls.clear();
        mDragged.clear();
        mSendSoon.start(); // a run that continues later continues without them
    }
    Q_EMIT stateChanged();
}

void SolverController::documentReplaced()
{
    mSendSoon.stop();
    discard();
    // Emitted even if there was nothing to discard, because panels show the state of the new document.
    Q_EMIT stateChanged();
}

void SolverController::documentChanged()
{
    if (!mToken)
        return;
    if (!mWorkspace.hasMapOf(*mToken))
        discard();
    else if (mWorkspace.document()->token() != *mToken)
        mSendSoon.start();
}

//! \param back the maps from before the pulls come back
void SolverController::sendSnapshot(bool back)
{
    if (!mToken || !mWorkspace.hasMapOf(*mToken))
        return;
    Snapshot snapshot = makeSnapshot(*mWorkspace.document());
    snapshot.scope = mScope;
    mToken = snapshot.token;
    if (!mPulls.empty()) {
        std::vector<Pin> &pins = snapshot.editSteering().pins;
        for (Pin pull : mPulls) {
            pull.target /= mWorkspace.document()->uvScale();
            pins.push_back(pull);
        }
    }
    const auto shared = std::make_shared<const Snapshot>(std::move(snapshot));
    mMapRests = false;
    mWorker->update(shared, !mPulls.empty(), back ? mBeforePulls : nullptr);
    mKeeper->update(shared, mapOptions(), !mPulls.empty(), back ? mMapBeforePulls : nullptr);
}

//! Shows the newest state, while a solve is running or about to pause.
void SolverController::showResult()
{
    if (mRunning || mPausing)
        mDisplay.show();
}

void SolverController::takeResult()
{
    const std::shared_ptr<const live::SolveResult> result = mWorker->takeResult();
    if (!result || !mToken || !result->token.sameMap(*mToken))
        return;
    mDisplay.take(result);
    showResult();
    Q_EMIT statusChanged();
}

void SolverController::takeMap()
{
    const std::shared_ptr<const unwrap::LiveMapResult> map = mKeeper->takeMap();
    if (!map || !mToken || !map->token.sameMap(*mToken))
        return;
    mDisplay.take(map);
    showResult();
    Q_EMIT statusChanged();
    if (mPausing)
        endPause();
}

void SolverController::setLivePacking(bool pack)
{
    if (pack == mDisplay.packs())
        return;
    mDisplay.setPacks(pack);
    showResult();
    Q_EMIT stateChanged();
}

//! The soup stopped by itself: a single step is done, the budget is reached, or it has converged. Only after
//! a single step does the solve end.
void SolverController::workerWaits()
{
    if (!mWorker->takeRest())
        return; // it was started again meanwhile
    takeResult();
    if (mStepping && mRunning)
        pause();
}

//! No shorter seams are found. With manual settings the run stays active and waits for edits.
void SolverController::keeperRests()
{
    if (!mKeeper->takeRest())
        return; // it was told something meanwhile
    takeMap();
    mMapRests = true;
    Q_EMIT statusChanged();
    if (mRunning && mPulls.empty() && mMode == homotopy::SolveMode::Budget && !mStepping) {
        mEndsByItself = true;
        pause();
        mEndsByItself = false;
    } else
        endPause(true);
}

//! Puts the map into the document, as soon as there is one that obeys the steering.
//! \param withAnyMap do not wait for one
void SolverController::endPause(bool withAnyMap)
{
    const std::shared_ptr<const unwrap::LiveMapResult> map = mDisplay.map();
    const bool obeys = map && mToken && map->token.steering == mToken->steering;
    if (!mPausing || !(obeys || withAnyMap))
        return;
    mKeeper->pause();
    bool changed = true;
    if (map) {
        Document &document = *mWorkspace.document();
        // Pushing does not invalidate the state of the solver: it belongs to the document's new map now.
        mToken.reset();
        changed = pushCommand(newMapCommand(document, UvEdit::Solve, map->uv));
        mToken = document.token();
        mWorker->setToken(*mToken);
        mKeeper->setToken(*mToken);
    }
    mShownMap.showDocument();
    setRunning(false, false);
    if (map)
        tellProblems();
    else if (mMapRests)
        Q_EMIT foundProblems(tr("The solve found no map of this model: Unwrap makes one of flat patches"),
                             {});
    if (!changed && mEndsByItself)
        Q_EMIT said(tr("The solve has ended: no better map was found, it stays as it was"));
    for (const auto &then : std::exchange(mWhenPaused, {}))
        then();
}

//! Says what the map in the document does not obey.
void SolverController::tellProblems()
{
    const unwrap::LiveMapResult &map = *mDisplay.map();
    jobs::Remarks problems = jobs::remarksOn(map.unmet);
    if (problems.empty() && map.withinBound)
        problems = jobs::remarksOnSymmetry(map.mirroredArea.value_or(1));
    if (!problems.empty())
        Q_EMIT foundProblems(jobs::textsOf(problems).join(QStringLiteral(". ")),
                             itemsOf(makeSnapshot(*mWorkspace.document()), problems));
    else if (!map.withinBound)
        Q_EMIT foundProblems(tr("The distortion of %1 is above the bound of %2: let the solver run on, allow "
                                "more, or remove joins")
                                 .arg(fixedText(map.distortion, 4))
                                 .arg(mWorkspace.document()->solveSettings().maxDistortion, 0, 'f', 4),
                             {});
}

void SolverController::fail(const std::optional<QString> &message)
{
    if (!message)
        return; // it was started again meanwhile
    discard();
    Q_EMIT failed(*message);
}

} // namespace autocuts
