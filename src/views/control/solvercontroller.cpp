#include "views/control/solvercontroller.h"

#include "commands/changesettings.h"
#include "commands/setuvs.h"
#include "model/document/makesnapshot.h"
#include "model/plain/uvlayout.h"
#include "views/control/shownmap.h"
#include "views/control/workspace.h"

namespace autocuts {

namespace {

//! Largest number of points in the graph. When there are more, every other one is dropped. Chosen by hand.
constexpr std::size_t mostTracePoints = 4000;

} // namespace

SolverController::SolverController(Workspace &workspace, ShownMap &shownMap, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mShownMap(shownMap), mWorker(new live::SolveWorker)
{
    mThread.setObjectName(QStringLiteral("solver"));
    mWorker->moveToThread(&mThread);
    connect(&mThread, &QThread::finished, mWorker, &QObject::deleteLater);
    connect(mWorker, &live::SolveWorker::resultReady, this, &SolverController::takeResult);
    connect(mWorker, &live::SolveWorker::pausedMapReady, this, &SolverController::takePausedMap);
    connect(mWorker, &live::SolveWorker::waiting, this, &SolverController::workerWaits);
    connect(mWorker, &live::SolveWorker::waiting, this, &SolverController::workerRests, Qt::DirectConnection);
    connect(mWorker, &live::SolveWorker::failed, this, &SolverController::workerFailed);
    connect(&workspace, &Workspace::documentReplaced, this, &SolverController::documentReplaced);
    connect(&workspace, &Workspace::changed, this, &SolverController::documentChanged);
    connect(&mPacker, &LivePacker::arranged, this, &SolverController::showResult);
    mSendSoon.setSingleShot(true);
    mSendSoon.setInterval(0);
    connect(&mSendSoon, &QTimer::timeout, this, [this] { sendSnapshot(); });
    mThread.start();
}

SolverController::~SolverController()
{
    mWorker->pause();
    mThread.quit();
    mThread.wait();
}

bool SolverController::canContinue() const
{
    return mToken.has_value();
}

void SolverController::setMode(homotopy::SolveMode mode)
{
    if (mode == mMode)
        return;
    mMode = mode;
    mWorker->setMode(mMode, mMaxDistortion);
    if (mMode == homotopy::SolveMode::Manual && mStatus.iteration > 0) {
        SolveSettings settings = mWorkspace.document()->solveSettings();
        settings.lambda = mStatus.lambda;
        settings.delta = mStatus.delta;
        pushCommand(std::make_unique<ChangeSettings>(*mWorkspace.document(), settings));
    }
    Q_EMIT stateChanged();
}

void SolverController::setMaxDistortion(double bound)
{
    if (bound == mMaxDistortion || !(bound > 4))
        return;
    mMaxDistortion = bound;
    mWorker->setMode(mMode, mMaxDistortion);
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

void SolverController::setPulls(std::vector<Pin> pulls)
{
    if (!mRunning || (pulls.empty() && mPulls.empty()))
        return;
    if (mPulls.empty())
        mBeforePulls = mResult;
    mPulls = std::move(pulls);
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
    sendSnapshot(mBeforePulls);
}

void SolverController::run()
{
    const Document *document = mWorkspace.document();
    if (!document || mRunning)
        return;
    if (!mToken)
        beginWhereTheMapIs();
    mStepping = false;
    setRunning(true, false);
    mWorker->run();
}

void SolverController::pause()
{
    if (!mRunning)
        return;
    setRunning(false, true);
    mWorker->pauseWithMap();
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
    const Document *document = mWorkspace.document();
    if (!document)
        return;
    if (!mToken)
        beginWhereTheMapIs();
    // waiting() is emitted at the end of the step and then stitches the map.
    mStepping = true;
    setRunning(true, false);
    mWorker->runSteps(1);
}

void SolverController::restart()
{
    const Document *document = mWorkspace.document();
    if (!document)
        return;
    begin(document->solveSettings().start);
    mStepping = false;
    setRunning(true, false);
    mWorker->run();
}

void SolverController::discard()
{
    if (!mToken)
        return;
    mWorker->pause();
    mToken.reset();
    mResult.reset();
    mPacker.reset();
    mWhenPaused.clear();
    mStatus = {};
    mTrace.clear();
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
    const auto snapshot = std::make_shared<const Snapshot>(makeSnapshot(document, start));
    mToken = snapshot->token;
    mResult.reset();
    mBeforePulls.reset();
    mPacker.reset();
    mStatus = {};
    mTrace.clear();
    mTraceStride = 1;
    mWorker->setMode(mMode, mMaxDistortion);
    // Places the map at the centre of the unit square.
    const Vec2 centre = Vec2::Constant(0.5 / document.uvScale());
    mWorker->start(snapshot, centre, warm);
    Q_EMIT statusChanged();
}

void SolverController::setRunning(bool running, bool pausing)
{
    if (running == mRunning && pausing == mPausing)
        return;
    mRunning = running;
    mPausing = pausing;
    if (!mRunning && !mPulls.empty()) {
        mPulls.clear();
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

void SolverController::sendSnapshot(const std::shared_ptr<const live::SolveResult> &back)
{
    if (!mToken || !mWorkspace.hasMapOf(*mToken))
        return;
    Snapshot snapshot = makeSnapshot(*mWorkspace.document());
    mToken = snapshot.token;
    if (!mPulls.empty()) {
        std::vector<Pin> &pins = snapshot.editSteering().pins;
        for (Pin pull : mPulls) {
            pull.target /= mWorkspace.document()->uvScale();
            pins.push_back(pull);
        }
    }
    mWorker->update(std::make_shared<const Snapshot>(std::move(snapshot)), !mPulls.empty(), back);
}

void SolverController::takeResult()
{
    const std::shared_ptr<const live::SolveResult> result = mWorker->takeResult();
    if (!result || !mToken || !result->token.sameMap(*mToken))
        return;
    mResult = result;
    mStatus = result->status;
    addToTrace(result->trace);
    showResult();
    Q_EMIT statusChanged();
}

void SolverController::showResult()
{
    if (!mResult || !(mRunning || mPausing))
        return;
    const Document &document = *mWorkspace.document();
    UvMatrix uv = document.uvScale() * mResult->soupUv;
    if (mLivePacking)
        mPacker.arrange(document.state().scene.mesh, document.constraints(), document.packingSettings(),
                        mResult->separation, uv);
    mShownMap.showLive(std::move(uv), mResult->separation);
}

void SolverController::setLivePacking(bool pack)
{
    if (pack == mLivePacking)
        return;
    mLivePacking = pack;
    mPacker.reset();
    showResult();
    Q_EMIT stateChanged();
}

void SolverController::addToTrace(const std::vector<live::TracePoint> &points)
{
    for (const live::TracePoint &point : points) {
        if (point.iteration % mTraceStride == 0)
            mTrace.push_back(point);
    }
    while (mTrace.size() > mostTracePoints) {
        mTraceStride *= 2;
        std::erase_if(mTrace, [this](const live::TracePoint &p) { return p.iteration % mTraceStride != 0; });
    }
}

//! The solve stopped by itself: a single step is done, the budget is reached, or, with manual settings, the
//! map has converged. With manual settings the run stays active and waits for edits.
void SolverController::workerWaits()
{
    if (!mWorker->takeRest())
        return; // it was started again meanwhile
    takeResult();
    if (mRunning && mPulls.empty() &&
        !(mStatus.converged && mMode == homotopy::SolveMode::Manual && !mStepping))
        pause();
}

void SolverController::takePausedMap()
{
    const std::optional<live::PausedMap> paused = mWorker->takePausedMap();
    if (!paused || !mPausing || !mToken || !paused->token.sameMap(*mToken))
        return;
    takeResult();
    Document &document = *mWorkspace.document();
    // Pushing does not invalidate the state of the worker: it belongs to the document's new map now.
    mToken.reset();
    pushCommand(std::make_unique<SetUvs>(document, UvEdit::Solve, paused->uv));
    mToken = document.token();
    mWorker->setToken(*mToken);
    mShownMap.showDocument();
    setRunning(false, false);
    for (const auto &then : std::exchange(mWhenPaused, {}))
        then();
}

void SolverController::workerFailed()
{
    const std::optional<QString> message = mWorker->takeFailure();
    if (!message)
        return; // it was started again meanwhile
    discard();
    Q_EMIT failed(*message);
}

} // namespace autocuts
