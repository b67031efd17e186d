#include "views/control/jobs/mapcontroller.h"

#include "commands/edittextures.h"
#include "commands/edituvsets.h"
#include "commands/newmap.h"
#include "model/document/makesnapshot.h"
#include "model/pictures/texturefiles.h"
#include "solver/overlap/overlapseparation.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/mapjobs/mapjobs.h"
#include "views/control/mapjobs/transferjobs.h"
#include "views/control/session/workspace.h"

#include <QScopedValueRollback>

#include <utility>

namespace autocuts {

namespace {

//! Milliseconds without an edit after which a job begins again. Chosen by hand.
constexpr int editDelay = 300;

//! The input of a job that may change only these faces.
MapInput limited(MapInput input, JobReach reach, const QList<int> &faces)
{
    if (reach == JobReach::All)
        return input;
    input.snapshot.scope =
        scopeOf(input.mesh(), faces, reach != JobReach::SelectionFree, reach != JobReach::Shown);
    return input;
}

//! Says that hidden faces were left alone.
MapJobResult ofReach(MapJobResult result, JobReach reach)
{
    if (reach != JobReach::Shown)
        return result;
    result.edit = result.edit == UvEdit::UnwrapSelection ? UvEdit::Unwrap : UvEdit::Finish;
    if (!result.message.isEmpty())
        result.message = MapController::tr("%1. Hidden faces stay as they were").arg(result.message);
    return result;
}

} // namespace

MapController::MapController(Workspace &workspace, SolverController &solver, ShownMap &shownMap,
                             QObject *parent)
    : QObject(parent), mWorkspace(workspace), mSolver(solver), mPreview(workspace, shownMap),
      mMeasuring(workspace)
{
    mRestartSoon.setSingleShot(true);
    mRestartSoon.setInterval(editDelay);
    connect(&mRestartSoon, &QTimer::timeout, this, &MapController::takeUpEdits);
    connect(&mJobs, &JobRunner::busyChanged, this, [this] {
        // Its map stays in the views until the first one of the new beginning.
        if (!mJobs.isBusy() && !mRestarts)
            mPreview.end();
    });
    const auto tell = [this](const QString &message) { Q_EMIT failed(message); };
    connect(&mJobs, &JobRunner::failed, this, tell);
    connect(&mMeasuring, &MapMeasuring::failed, this, tell);
    connect(&mMeasuring, &MapMeasuring::changed, this, &MapController::figuresChanged);
    connect(&workspace, &Workspace::documentReplaced, this, [this] {
        mRestart = nullptr;
        mOnSuccess = nullptr;
        mReachOfHidden.reset();
        mJobs.abandon();
        mHardShare.reset();
        mPrices.reset();
        Q_EMIT pricesChanged();
    });
    connect(&workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (mRestart && mJobs.isBusy())
            mRestartSoon.start();
        endUselessJob();
        if (mMeasuring.dependOn(event))
            Q_EMIT pricesChanged();
    });
}

//! \pre no solve runs, so that its result is the one from which the map was made
MapInput MapController::input() const
{
    const Document &document = *mWorkspace.document();
    MapInput input;
    input.snapshot = makeSnapshot(document);
    input.uv = document.uv();
    input.uvScale = document.uvScale();
    input.packing = document.packingSettings();
    input.sessionPath = mWorkspace.sessionPath();
    input.marks = document.marks();
    input.constraints = document.constraints();
    input.selectedFaces = document.selection().faces;
    const QList<int> &edges = document.selection().edges;
    input.selectedEdges.assign(edges.begin(), edges.end());
    input.live.result = mSolver.liveView() == LiveView::Soup ? mSolver.soup() : nullptr;
    input.live.hasMoreToDo = input.live.result && mSolver.mode() == homotopy::SolveMode::Budget &&
                             !input.live.result->status.converged;
    return input;
}

void MapController::startJob(const QString &title, Work work, bool replacesMap)
{
    if (!mWorkspace.document() || mJobs.isBusy())
        return;
    mRestart = nullptr;
    mOnSuccess = nullptr;
    mSolver.whenPaused([this, title, replacesMap, work = std::move(work)] {
        if (!mWorkspace.document() || mJobs.isBusy())
            return;
        const auto given = std::make_shared<const MapInput>(input());
        mInputToken = given->snapshot.token;
        mReplacesMap = replacesMap;
        mJobs.start(
            title,
            [given, work](JobControl &control) {
                MapJobResult result = work(*given, control);
                result.token = given->snapshot.token;
                return result;
            },
            [this](const MapJobResult &result) { applyResult(result); });
    });
}

//! Returns false when that changes nothing.
bool MapController::pushMap(const MapJobResult &result)
{
    Document &document = *mWorkspace.document();
    if (result.seams)
        return pushCommand(EditMapSeams::make(document, result.seams->edit, result.uv, result.seams->edges));
    return pushCommand(newMapCommand(document, result.edit, result.uv, result.count, result.flags));
}

void MapController::applyResult(const MapJobResult &result)
{
    if (result.hardShare)
        mHardShare = result.hardShare;
    if (result.prices) {
        mPrices = result.prices;
        mPricesToken = result.token;
        Q_EMIT pricesChanged();
    }
    QString hint;
    if (result.uv.rows() > 0) {
        if (!mWorkspace.hasMapOf(result.token)) {
            Q_EMIT failed(tr("The map was edited meanwhile: the result was not used"));
            return;
        }
        const bool hadMap = hasUvs(*mWorkspace.document());
        const bool changed = pushMap(result);
        // Materials show their textures with the first UV set: those stay right while another one changes.
        if (changed && hadMap && mWorkspace.document()->activeUvSet() == 0 &&
            hasTextures(mWorkspace.document()->state()))
            hint =
                tr(". The textures fit the map before: UV > Carry textures over... makes them new for this "
                   "one");
        if (!changed && result.seams) {
            Q_EMIT done(tr("Nothing to do: the edges are cut already"));
            return;
        }
    }
    const std::function<void()> then = std::exchange(mOnSuccess, nullptr);
    if (result.textures && !pushTextures(result))
        return;
    if (!result.problem.isEmpty())
        Q_EMIT failed(result.problem + hint, result.problemItems);
    else
        Q_EMIT done(result.message + hint);
    if (then && result.uv.rows() > 0)
        then();
}

//! Returns false, and says why, when they do not belong to the document any more.
bool MapController::pushTextures(const MapJobResult &result)
{
    Document &document = *mWorkspace.document();
    if (!mWorkspace.hasMapOf(result.token) || document.state().textureSets != result.textures->before) {
        Q_EMIT failed(
            tr("The map or its textures were edited meanwhile: the new pictures are written, but not "
               "shown"));
        return false;
    }
    const bool baked = result.textures->baked;
    pushCommand(
        std::make_unique<EditTextures>(document, result.textures->sets,
                                       baked ? EditTextures::Origin::Baked : EditTextures::Origin::Carried));
    if (baked)
        Q_EMIT picturesBaked();
    return true;
}

//! The reach of a job, after a question where that is everything and faces are hidden. Nothing when the job
//! is not wanted.
std::optional<JobReach> MapController::asked(JobReach reach)
{
    const Document *document = mWorkspace.document();
    if (!document || mJobs.isBusy())
        return std::nullopt;
    const qsizetype hidden = document->state().hiddenFaces.size();
    if (hidden == 0)
        mReachOfHidden.reset();
    if (reach != JobReach::All || hidden == 0)
        return reach;
    if (hidden == document->mesh().faceCount()) {
        Q_EMIT failed(tr("All faces are hidden: show those whose map is to change"));
        return std::nullopt;
    }
    if (!mAskHidden)
        return reach;
    if (!mReachOfHidden)
        mReachOfHidden = mAskHidden(hidden);
    return mWorkspace.document() == document ? mReachOfHidden : std::nullopt; // while the question was open
}

//! The faces that a job may change; none where that is everything.
QList<int> MapController::facesOf(JobReach reach) const
{
    const Document &document = *mWorkspace.document();
    if (reach == JobReach::SelectionAttached || reach == JobReach::SelectionFree)
        return document.selection().faces;
    QList<int> shown;
    if (reach == JobReach::Shown) {
        for (int face = 0; face < document.mesh().faceCount(); ++face) {
            if (!document.hidden()[face])
                shown << face;
        }
    }
    return shown;
}

void MapController::unwrap(unwrap::UnwrapQuality quality, JobReach wanted)
{
    if (const std::optional<JobReach> reach = asked(wanted))
        beginUnwrap(quality, *reach, facesOf(*reach));
}

//! \param faces what it may change, unless that is everything
void MapController::beginUnwrap(unwrap::UnwrapQuality quality, JobReach reach, const QList<int> &faces)
{
    startJob(
        tr("Unwrapping"),
        [=, better = mPreview.begin()](const MapInput &input, JobControl &control) {
            return ofReach(unwrapJob(limited(input, reach, faces), quality, better, control), reach);
        },
        true);
    mRestart = [this, quality, reach, faces] { beginUnwrap(quality, reach, faces); };
}

//! Where the map was edited, by undo for example, a job's map or light would not be used in the end.
void MapController::endUselessJob()
{
    if (!mReplacesMap || !mJobs.isBusy() || mWorkspace.hasMapOf(mInputToken))
        return;
    mRestart = nullptr;
    mOnSuccess = nullptr;
    const QString title = mJobs.title();
    mJobs.abandon();
    // Later: what was said of the map before ends with this edit.
    QMetaObject::invokeMethod(
        this, [this, title] { Q_EMIT failed(tr("%1 was ended: the map was edited meanwhile").arg(title)); },
        Qt::QueuedConnection);
}

//! Begins the job again with the document as it is now, also when it has just ended.
void MapController::takeUpEdits()
{
    const Document *document = mWorkspace.document();
    if (!mRestart || !document)
        return;
    const StateToken now = document->token();
    if (now.topology != mInputToken.topology || (mJobs.isBusy() && now.uv != mInputToken.uv) ||
        (now.steering == mInputToken.steering && now.layout == mInputToken.layout))
        return;
    const QScopedValueRollback again(mRestarts, true);
    mJobs.abandon();
    std::exchange(mRestart, nullptr)();
}

void MapController::cancel()
{
    mRestart = nullptr;
    mOnSuccess = nullptr;
    mJobs.cancel();
}

void MapController::finish(JobReach wanted)
{
    const std::optional<JobReach> reach = asked(wanted);
    if (!reach)
        return;
    startJob(
        tr("Finishing"),
        [reach = *reach, faces = facesOf(*reach)](const MapInput &input, JobControl &control) {
            return ofReach(finishJob(limited(input, reach, faces), control), reach);
        },
        true);
}

void MapController::pack(PackScope scope)
{
    startPacking({scope == PackScope::All, {}, {}});
}

void MapController::packEach(SceneKind kind)
{
    const Document *document = mWorkspace.document();
    if (!document)
        return;
    if (kind == SceneKind::Tags && document->marks().tags.empty()) {
        Q_EMIT failed(tr("No island has a tag: Select > Tags of islands gives one"));
        return;
    }
    const QList<int> faces = document->selection().faces;
    PackTarget target{faces.isEmpty(), faces, {}};
    target.choice.groups = kind == SceneKind::Tags
                               ? tagGroups(document->marks(), document->mesh().faceCount())
                               : sceneGroups(document->state().scene, kind);
    startPacking(target);
}

void MapController::packAtDensity(double density)
{
    const Document *document = mWorkspace.document();
    if (!document)
        return;
    const QList<int> faces = document->selection().faces;
    PackTarget target{faces.isEmpty(), faces, {}};
    target.choice.density = density;
    startPacking(target);
}

void MapController::fillTiles()
{
    PackTarget target{false, {}, {}};
    target.choice.fillTiles = true;
    startPacking(target);
}

void MapController::packInto(const Eigen::AlignedBox2d &box, const QList<int> &faces)
{
    startPacking({false, faces, box});
}

void MapController::startPacking(const PackTarget &target)
{
    startJob(tr("Packing"), [target](const MapInput &input, JobControl &control) {
        return packJob(input, target, control);
    });
}

void MapController::separateOverlaps()
{
    startJob(tr("Separating overlaps"), [](const MapInput &input, JobControl &control) {
        return separateJob(input, overlap::SeparationMethod::MinCut, control);
    });
}

void MapController::separateGreedily()
{
    startJob(tr("Separating overlaps"), [](const MapInput &input, JobControl &control) {
        return separateJob(input, overlap::SeparationMethod::Greedy, control);
    });
}

void MapController::addLightmapSet(const std::function<void()> &then)
{
    mSolver.whenPaused([this, then] {
        Document *document = mWorkspace.document();
        if (!document || mJobs.isBusy())
            return;
        const bool hasMap = hasUvs(*document);
        pushCommand(
            std::make_unique<AddUvSet>(*document, tr("Lightmap"), hasMap ? document->activeUvSet() : -1));
        if (hasMap)
            startJob(tr("Making a map for lightmaps"), lightmapJob);
        else
            unwrap(mQuality);
        mOnSuccess = then;
    });
}

void MapController::transferUvs(const jobs::TransferChoice &choice)
{
    const Document *document = mWorkspace.document();
    if (!document)
        return;
    startJob(tr("Transferring UVs"),
             [choice, sets = document->uvSets()](const MapInput &input, JobControl &control) {
                 return transferUvsJob(input, choice, sets, control);
             });
}

void MapController::equalizeDensity()
{
    startJob(tr("Equalising texel density"), equalizeJob);
}

void MapController::relaxSelection()
{
    startJob(tr("Relaxing"), relaxJob);
}

void MapController::straightenSelection()
{
    startJob(tr("Straightening"), straightenJob);
}

void MapController::alignToAxes(const QList<int> &faces)
{
    startJob(tr("Aligning to the axes"),
             [faces](const MapInput &input, JobControl &control) { return alignJob(input, faces, control); });
}

void MapController::gridSelection()
{
    startJob(tr("Straightening to a grid"), gridJob);
}

void MapController::priceSeams()
{
    startJob(tr("Pricing seams"), priceJob);
}

const unwrap::SeamPrices *MapController::seamPrices() const
{
    return mPrices && mWorkspace.hasMapOf(mPricesToken) ? &*mPrices : nullptr;
}

void MapController::rip(const QList<int> &edges)
{
    startJob(tr("Ripping"),
             [edges](const MapInput &input, JobControl &control) { return ripJob(input, edges, control); });
}

void MapController::stitch(const QList<int> &edges)
{
    startJob(tr("Stitching"), [edges](const MapInput &input, JobControl &control) {
        return stitchJob(input, edges, control);
    });
}

} // namespace autocuts
