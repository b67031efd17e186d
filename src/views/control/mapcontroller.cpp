#include "views/control/mapcontroller.h"

#include "commands/newmap.h"
#include "model/makesnapshot.h"
#include "model/unionfind.h"
#include "model/uvlayout.h"
#include "solver/finalmap.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/overlap/separatemap.h"
#include "solver/packing/islandgeometry.h"
#include "views/control/solvercontroller.h"
#include "views/control/workspace.h"

#include <QThread>

#include <algorithm>
#include <map>

namespace autocuts {

//! What a job gets to see.
struct MapController::Input
{
    Snapshot snapshot;
    UvMatrix uv; //!< per corner, texture space
    double uvScale = 1;
    PackingSettings packing;
    IslandMarks marks;
    QList<int> selectedFaces;
    std::uint64_t revision = 0; //!< Workspace::uvRevision()

    const MeshData &mesh() const { return *snapshot.mesh; }
};

//! What a job gives back.
struct MapJobResult
{
    UvEdit edit = UvEdit::Pack;
    UvMatrix uv;     //!< per corner, texture space; no rows: the map stays as it is
    QString message; //!< what was done
    QString problem; //!< what could not be done
};

namespace {

//! Milliseconds without an edit after which the map is measured.
constexpr int measureDelay = 250;
constexpr int maxListedOverlaps = 100'000;

QString translated(const char *text)
{
    return MapController::tr(text);
}

PackSettings packSettings(const PackingSettings &packing)
{
    PackSettings settings;
    const int tile = packing.udimTile - PackingSettings::firstTile;
    settings.lower = Vec2(tile % 10, tile / 10);
    settings.upper = settings.lower + Vec2::Ones();
    settings.textureSize = packing.textureSize;
    settings.margin = packing.margin;
    switch (packing.rotation) {
    case PackingSettings::Rotation::None:
        settings.rotation = PackRotation::None;
        break;
    case PackingSettings::Rotation::Quarter:
        settings.rotation = PackRotation::Quarter;
        break;
    case PackingSettings::Rotation::Free:
        settings.rotation = PackRotation::Free;
        break;
    }
    settings.keepScale = packing.keepScale;
    settings.threads = QThread::idealThreadCount();
    return settings;
}

//! The charts with those of one stack or one group made into one piece, which stays rigid.
ChartMap rigidPieces(const ChartMap &charts, const IslandMarks &marks)
{
    const auto faces = charts.faces();
    UnionFind pieces(charts.count);
    std::map<int, int> firstOfStack, firstOfGroup;
    for (int c = 0; c < charts.count; ++c) {
        const IslandFlags flags = marks.flagsOf(faces[c]);
        if (flags.stack != 0)
            pieces.unite(c, firstOfStack.try_emplace(flags.stack, c).first->second);
        if (flags.group != 0)
            pieces.unite(c, firstOfGroup.try_emplace(flags.group, c).first->second);
    }
    const auto [label, count] = pieces.labels();
    ChartMap result = charts;
    result.count = count;
    for (int &chart : result.faceChart)
        chart = chart < 0 ? chart : label[chart];
    return result;
}

//! Packs the charts; the locked ones, and when only some are to be packed the others, stay where they are.
//! Returns false when there is no room.
bool packInto(UvMatrix &uv, const MeshData &mesh, const ChartMap &charts, const IslandMarks &marks,
              const std::vector<bool> &movable, const PackingSettings &packing, JobControl &control)
{
    const ChartMap pieces = rigidPieces(charts, marks);
    std::vector<bool> locked(pieces.count, true);
    const auto faces = pieces.faces();
    for (int p = 0; p < pieces.count; ++p) {
        const auto moves = [&](int face) { return movable[face]; };
        locked[p] =
            marks.flagsOf(faces[p]).locked != 0 || !std::any_of(faces[p].begin(), faces[p].end(), moves);
    }
    if (!packing.keepScale)
        equalizeTexelDensity(mesh, pieces, uv, locked);
    const PackResult packed =
        packIslands(makePackIslands(mesh, uv, pieces, locked), packSettings(packing), &control.stop(),
                    [&](double fraction) { control.setProgress(fraction); });
    if (packed.complete)
        applyPlacements(packed, mesh, pieces, uv, locked);
    return packed.complete;
}

QString noRoom(const PackingSettings &packing)
{
    return packing.keepScale
               ? translated("The islands do not fit at their size: switch off \"Keep scale\" or use a "
                            "smaller margin")
               : translated("There is no room for the margins: use a smaller margin or a larger texture");
}

MapFigures measured(const MeshData &mesh, const UvMatrix &uv, int textureSize, JobControl &control)
{
    MapFigures figures;
    UvMetricsOptions options;
    options.textureSize = textureSize;
    options.cancel = &control.stop();
    figures.metrics = measureUv(mesh, uv, options);
    if (figures.metrics.overlapPairs == 0)
        return figures;
    OverlapOptions overlapOptions;
    overlapOptions.cancel = &control.stop();
    overlapOptions.minAreaRatio = 1e-9; // as UvMetrics::overlapPairs
    overlapOptions.maxPairs = maxListedOverlaps;
    OverlapList overlaps = findOverlaps(soupUv(mesh, uv), overlapOptions);
    std::stable_sort(overlaps.pairs.begin(), overlaps.pairs.end(),
                     [](const OverlapPair &a, const OverlapPair &b) { return a.area > b.area; });
    for (const OverlapPair &pair : overlaps.pairs) {
        figures.overlapPairs.push_back({pair.first, pair.second});
        figures.overlapping.insert(figures.overlapping.end(), {pair.first, pair.second});
    }
    std::sort(figures.overlapping.begin(), figures.overlapping.end());
    const auto last = std::unique(figures.overlapping.begin(), figures.overlapping.end());
    figures.overlapping.erase(last, figures.overlapping.end());
    return figures;
}

} // namespace

MapController::MapController(Workspace &workspace, SolverController &solver, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mSolver(solver)
{
    connect(&mJobs, &JobRunner::failed, this, &MapController::failed);
    connect(&mMeasuring, &JobRunner::failed, this, &MapController::failed);
    mMeasureSoon.setSingleShot(true);
    mMeasureSoon.setInterval(measureDelay);
    connect(&mMeasureSoon, &QTimer::timeout, this, &MapController::measure);
    connect(&workspace, &Workspace::documentReplaced, this, [this] {
        mJobs.abandon();
        mMeasuring.abandon();
        mFigures.reset();
        mMeasureSoon.start();
        Q_EMIT figuresChanged();
    });
    connect(&workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        const bool textureSize =
            event.type == ChangeEvent::Type::PackingSettings &&
            (static_cast<const PackingSettingsEvent &>(event).properties & TextureSizeProperty);
        if (textureSize)
            mFiguresRevision = 0;
        if (textureSize || event.type == ChangeEvent::Type::Uv || event.type == ChangeEvent::Type::UvSet) {
            mMeasureSoon.start();
            Q_EMIT figuresChanged();
        }
    });
}

bool MapController::figuresAreFresh() const
{
    return mFigures && mFiguresRevision == mWorkspace.uvRevision();
}

MapController::Input MapController::input() const
{
    const Document &document = *mWorkspace.document();
    Input input;
    input.snapshot = makeSnapshot(document);
    input.uv = document.uv();
    input.uvScale = document.uvScale();
    input.packing = document.packingSettings();
    input.marks = document.marks();
    input.selectedFaces = document.selection().faces;
    input.revision = mWorkspace.uvRevision();
    return input;
}

void MapController::startJob(const QString &title,
                             std::function<MapJobResult(const Input &, JobControl &)> work)
{
    if (!mWorkspace.document() || mJobs.isBusy())
        return;
    mSolver.whenSettled([this, title, work = std::move(work)] {
        if (!mWorkspace.document() || mJobs.isBusy())
            return;
        const auto given = std::make_shared<const Input>(input());
        mJobs.start(
            title, [given, work](JobControl &control) { return work(*given, control); },
            [this, revision = given->revision](const MapJobResult &result) { finishJob(revision, result); });
    });
}

void MapController::finishJob(std::uint64_t revision, const MapJobResult &result)
{
    if (result.uv.rows() > 0) {
        if (revision != mWorkspace.uvRevision()) {
            Q_EMIT failed(tr("The map was edited meanwhile: the result was not used"));
            return;
        }
        pushCommand(newMapCommand(*mWorkspace.document(), result.edit, result.uv));
    }
    if (!result.problem.isEmpty())
        Q_EMIT failed(result.problem);
    else
        Q_EMIT done(result.message);
}

void MapController::unwrap(UnwrapQuality quality, double maxDistortion)
{
    startJob(tr("Unwrapping"), [quality, maxDistortion](const Input &input, JobControl &control) {
        UnwrapOptions options;
        options.quality = quality;
        options.maxDistortion = maxDistortion;
        options.packing = packSettings(input.packing);
        options.packing.keepScale = false;
        options.threads = QThread::idealThreadCount();
        const UnwrapResult made =
            autocuts::unwrap(input.snapshot, options, &control.stop(), [&](const UnwrapProgress &progress) {
                control.setProgress(progress.fraction);
                if (progress.seamLength > 0)
                    control.setStage(translated("best so far: seams %1, distortion %2")
                                         .arg(progress.seamLength, 0, 'f', 2)
                                         .arg(progress.distortion, 0, 'f', 3));
            });
        MapJobResult result;
        result.edit = UvEdit::Solve;
        result.uv = made.uv;
        result.message = translated("Unwrapped: distortion %1").arg(made.distortion, 0, 'f', 4);
        if (!made.packed)
            result.problem = noRoom(input.packing);
        else if (!made.withinBound)
            result.problem =
                translated("The distortion of %1 is above the bound of %2: allow more, or remove joins")
                    .arg(made.distortion, 0, 'f', 4)
                    .arg(maxDistortion, 0, 'f', 4);
        return result;
    });
}

void MapController::finish(double maxDistortion)
{
    // The solver's own state knows more than the map that was made from it.
    const std::shared_ptr<const SolveResult> live = mSolver.result();
    startJob(tr("Finishing"), [live, maxDistortion](const Input &input, JobControl &control) {
        Snapshot snapshot = input.snapshot;
        if (!live) {
            snapshot.settings.start = StartMode::ExistingUv;
            snapshot.startUv = soupUv(input.mesh(), input.uv) / input.uvScale;
        } else {
            snapshot.settings.lambda = live->status.lambda;
            snapshot.settings.delta = live->status.delta;
        }
        Solver solver;
        solver.load(snapshot);
        if (live) {
            const double *first = live->soupUv.data();
            solver.setCoordinates({first, first + live->soupUv.size()});
        }
        FinalMapOptions options;
        options.maxDistortion = maxDistortion;
        options.threads = QThread::idealThreadCount();
        MapJobResult result;
        result.edit = UvEdit::Finish;
        const std::optional<SeamedMap> map = makeFinalMap(
            solver, options, &control.stop(), [&](double fraction) { control.setProgress(fraction); });
        if (!map) {
            result.problem = translated("Finishing was cancelled: the map stays as it was");
            return result;
        }
        result.uv = input.uvScale * cornerUv(solver.soup(), *map);
        result.message = translated("Finished: distortion %1").arg(map->distortion(solver.soup()), 0, 'f', 4);
        return result;
    });
}

void MapController::pack(PackScope scope)
{
    startJob(tr("Packing"), [scope](const Input &input, JobControl &control) {
        const MeshData &mesh = input.mesh();
        const ChartMap charts = findCharts(mesh, input.uv);
        std::vector<bool> movable(mesh.faceCount(), scope == PackScope::All);
        for (int face : input.selectedFaces)
            movable[face] = true;
        MapJobResult result;
        result.uv = input.uv;
        if (packInto(result.uv, mesh, charts, input.marks, movable, input.packing, control)) {
            result.message = translated("Islands packed: %1").arg(charts.count);
        } else {
            result.uv.resize(0, 2);
            result.problem = control.stop() ? translated("Packing was cancelled: the map stays as it was")
                                            : noRoom(input.packing);
        }
        return result;
    });
}

void MapController::separateOverlaps()
{
    startJob(tr("Separating overlaps"), [](const Input &input, JobControl &control) {
        const MeshData &mesh = input.mesh();
        const Separated separated = separateMap(mesh, input.uv, &control.stop());
        MapJobResult result;
        result.edit = UvEdit::Separate;
        if (!separated.complete) {
            result.problem = translated("Separating was cancelled: the map stays as it was");
            return result;
        }
        result.uv = input.uv;
        const std::vector<bool> all(mesh.faceCount(), true);
        if (!packInto(result.uv, mesh, separated.charts, input.marks, all, input.packing, control)) {
            result.uv.resize(0, 2);
            result.problem = noRoom(input.packing);
            return result;
        }
        result.message = translated("Separated, edges cut: %1").arg(separated.newSeams);
        if (separated.unresolvedPairs > 0)
            result.problem = translated("Overlaps inside single polygons, which stay whole: %1")
                                 .arg(separated.unresolvedPairs);
        return result;
    });
}

void MapController::equalizeDensity()
{
    startJob(tr("Equalising texel density"), [](const Input &input, JobControl &) {
        const MeshData &mesh = input.mesh();
        const ChartMap charts = findCharts(mesh, input.uv);
        const auto faces = charts.faces();
        std::vector<bool> locked(charts.count);
        for (int c = 0; c < charts.count; ++c)
            locked[c] = input.marks.flagsOf(faces[c]).locked != 0;
        MapJobResult result;
        result.edit = UvEdit::Scale;
        result.uv = input.uv;
        equalizeTexelDensity(mesh, charts, result.uv, locked);
        result.message = translated("All islands have the same texel density");
        return result;
    });
}

void MapController::measure()
{
    const Document *document = mWorkspace.document();
    if (!document || figuresAreFresh())
        return;
    mMeasuring.abandon(); // it measures a map that is no more
    const auto mesh = document->state().scene.mesh;
    const int textureSize = document->packingSettings().textureSize;
    mMeasuring.start(
        tr("Measuring"),
        [mesh, uv = document->uv(), textureSize](JobControl &control) {
            return measured(*mesh, uv, textureSize, control);
        },
        [this, revision = mWorkspace.uvRevision()](MapFigures figures) {
            mFigures = std::move(figures);
            mFiguresRevision = revision;
            Q_EMIT figuresChanged();
        });
}

} // namespace autocuts
