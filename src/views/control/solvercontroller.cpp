#include "views/control/solvercontroller.h"

#include "commands/changesettings.h"
#include "commands/newmap.h"
#include "model/document/makesnapshot.h"
#include "model/plain/uvlayout.h"
#include "solver/packing/packmap.h"
#include "views/control/mapjobs.h"
#include "views/control/shownmap.h"
#include "views/control/workspace.h"

#include <cmath>
#include <limits>

namespace autocuts {

namespace {

//! Largest number of points in the graph. When there are more, every other one is dropped. Chosen by hand.
constexpr std::size_t mostTracePoints = 4000;

double areaOf(const UvMatrix &soup)
{
    double area = 0;
    for (Eigen::Index c = 0; c + 2 < soup.rows(); c += 3)
        area += cross2(Vec2(soup.row(c)), Vec2(soup.row(c + 1)), Vec2(soup.row(c + 2)));
    return std::abs(area);
}

//! Moves and scales a ghost over the shown map.
void fitOver(const UvMatrix &shown, UvMatrix &ghost)
{
    const double area = areaOf(ghost);
    if (!(area > 0) || !shown.allFinite() || !ghost.allFinite())
        return;
    const double scale = std::sqrt(areaOf(shown) / area);
    const Eigen::RowVector2d from = ghost.colwise().mean(), to = shown.colwise().mean();
    ghost = (scale * (ghost.rowwise() - from)).rowwise() + to;
}

} // namespace

SolverController::SolverController(Workspace &workspace, ShownMap &shownMap, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mShownMap(shownMap), mWorker(new live::SolveWorker),
      mKeeper(new live::MapKeeper)
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
    connect(&mPacker, &LivePacker::arranged, this, &SolverController::showResult);
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
    const live::SolveStatus before = mStatus;
    mMode = mode;
    mWorker->setMode(mMode, mMaxDistortion);
    if (mMode == homotopy::SolveMode::Manual && mSoupRan && before.iteration > 0) {
        SolveSettings settings = mWorkspace.document()->solveSettings();
        settings.lambda = before.lambda;
        settings.delta = before.delta;
        pushCommand(std::make_unique<ChangeSettings>(*mWorkspace.document(), settings));
    }
    mSendSoon.start();
    // By hand, the soup is steered, over the map that a pause puts into the document.
    mGhost = mMode == homotopy::SolveMode::Manual;
    setLiveView(mGhost ? LiveView::Soup : LiveView::Map);
    Q_EMIT stateChanged();
}

void SolverController::setMaxDistortion(double bound)
{
    if (bound == mMaxDistortion || !(bound > 4))
        return;
    mMaxDistortion = bound;
    mWorker->setMode(mMode, mMaxDistortion);
    mSendSoon.start();
    Q_EMIT stateChanged();
}

void SolverController::setLiveView(LiveView view)
{
    if (view == mView)
        return;
    mView = view;
    runSoup();
    showResult();
    Q_EMIT stateChanged();
    Q_EMIT statusChanged();
}

void SolverController::setGhost(bool ghost)
{
    if (ghost == mGhost)
        return;
    mGhost = ghost;
    runSoup();
    showResult();
    Q_EMIT stateChanged();
}

live::SolveStatus SolverController::status() const
{
    if (mView == LiveView::Soup || !mMap)
        return mStatus;
    live::SolveStatus status;
    const SolveSettings settings = mWorkspace.document()->solveSettings();
    status.iteration = static_cast<int>(mMapTrace.size());
    status.distortion = mMap->distortion;
    status.separation = status.seamLength = mMap->seamLength;
    status.islands = mMap->islands;
    status.lambda = mSoupRan ? mStatus.lambda : settings.lambda;
    status.delta = mSoupRan ? mStatus.delta : settings.delta;
    status.energy = (1 - status.lambda) * status.distortion + status.lambda * status.separation;
    status.converged = mMapRests;
    return status;
}

const std::vector<live::TracePoint> &SolverController::trace() const
{
    return mView == LiveView::Soup || !mMap ? mTrace : mMapTrace;
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
    if (mPulls.empty()) {
        mBeforePulls = mResult;
        mMapBeforePulls = mMap;
    }
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
    sendSnapshot(true);
}

void SolverController::run()
{
    const Document *document = mWorkspace.document();
    if (!document || mRunning)
        return;
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
    if (seesSoup()) {
        mSoupRan = true;
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
    endPause();
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
    // waiting() is emitted at the end of the step.
    setLiveView(LiveView::Soup);
    mStepping = mSoupRan = true;
    setRunning(true, false);
    mKeeper->run();
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
    mKeeper->run();
    runSoup();
}

void SolverController::discard()
{
    if (!mToken)
        return;
    mWorker->pause();
    mKeeper->pause();
    mToken.reset();
    mResult.reset();
    mMap.reset();
    mPacker.reset();
    mWhenPaused.clear();
    mStatus = {};
    mTrace.clear();
    mMapTrace.clear();
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
    mMap.reset();
    mBeforePulls.reset();
    mMapBeforePulls.reset();
    mPacker.reset();
    mStatus = {};
    mTrace.clear();
    mMapTrace.clear();
    mTraceStride = 1;
    mSoupRan = mMapRests = false;
    mWorker->setMode(mMode, mMaxDistortion);
    // Places the map at the centre of the unit square.
    const Vec2 centre = Vec2::Constant(0.5 / document.uvScale());
    mWorker->start(snapshot, centre, warm);
    mKeeper->start(snapshot, mapOptions());
    Q_EMIT statusChanged();
}

unwrap::LiveMapOptions SolverController::mapOptions() const
{
    const Document &document = *mWorkspace.document();
    unwrap::LiveMapOptions options;
    options.maxDistortion = mMaxDistortion;
    options.packing = packing::tileOptions(document.packingSettings());
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

void SolverController::takeMap()
{
    const std::shared_ptr<const unwrap::LiveMapResult> map = mKeeper->takeMap();
    if (!map || !mToken || !map->token.sameMap(*mToken))
        return;
    mMap = map;
    mMapTrace.push_back({static_cast<int>(mMapTrace.size()) + 1, static_cast<float>(map->distortion),
                         static_cast<float>(map->seamLength), std::numeric_limits<float>::quiet_NaN()});
    showResult();
    Q_EMIT statusChanged();
    if (mPausing)
        endPause();
}

//! Shows the definite map or the soup, and the other one as a ghost.
void SolverController::showResult()
{
    if (!(mRunning || mPausing))
        return;
    const Document &document = *mWorkspace.document();
    const MeshData &mesh = document.mesh();
    UvMatrix soup, map;
    if (mResult && mSoupRan && seesSoup())
        soup = document.uvScale() * mResult->soupUv;
    if (mMap && (mView == LiveView::Map || mGhost))
        map = soupUv(mesh, mMap->uv);
    // Without a map before, both begin where they like.
    if (!hasUvs(document) && map.rows() > 0 && soup.rows() > 0)
        mView == LiveView::Map ? fitOver(map, soup) : fitOver(soup, map);
    if (mView == LiveView::Map && map.rows() > 0) {
        std::vector<float> apart(mesh.cornerPairCount());
        for (std::size_t p = 0; p < apart.size(); ++p)
            apart[p] = mMap->cut[p / 2] ? 1.f : 0.f;
        mShownMap.showMap(std::move(map), std::move(apart), std::move(soup));
    } else if (mView == LiveView::Soup && soup.rows() > 0) {
        if (mLivePacking)
            mPacker.arrange(document.state().scene.mesh, document.constraints(), document.packingSettings(),
                            mResult->separation, soup);
        mShownMap.showSoup(std::move(soup), mResult->separation, std::move(map));
    }
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
    if (mRunning && mPulls.empty() && mMode == homotopy::SolveMode::Budget && !mStepping)
        pause();
    else
        endPause(true);
}

//! Puts the map into the document, as soon as there is one that obeys the steering.
//! \param withAnyMap do not wait for one
void SolverController::endPause(bool withAnyMap)
{
    const bool obeys = mMap && mToken && mMap->token.steering == mToken->steering;
    if (!mPausing || !(obeys || withAnyMap))
        return;
    mKeeper->pause();
    if (mMap) {
        Document &document = *mWorkspace.document();
        // Pushing does not invalidate the state of the solver: it belongs to the document's new map now.
        mToken.reset();
        pushCommand(newMapCommand(document, UvEdit::Solve, mMap->uv));
        mToken = document.token();
        mWorker->setToken(*mToken);
        mKeeper->setToken(*mToken);
    }
    mShownMap.showDocument();
    setRunning(false, false);
    if (mMap)
        tellProblems();
    for (const auto &then : std::exchange(mWhenPaused, {}))
        then();
}

//! Says what the map in the document does not obey.
void SolverController::tellProblems()
{
    if (!mMap->unmet.empty()) {
        Selection items;
        const QString text = unmetText(makeSnapshot(*mWorkspace.document()), mMap->unmet, items);
        Q_EMIT foundProblems(text, items);
    } else if (!mMap->withinBound) {
        Q_EMIT foundProblems(tr("The distortion of %1 is above the bound of %2: let the solver run on, allow "
                                "more, or remove joins")
                                 .arg(mMap->distortion, 0, 'f', 4)
                                 .arg(mMaxDistortion, 0, 'f', 4),
                             {});
    }
}

void SolverController::fail(const std::optional<QString> &message)
{
    if (!message)
        return; // it was started again meanwhile
    discard();
    Q_EMIT failed(*message);
}

} // namespace autocuts
