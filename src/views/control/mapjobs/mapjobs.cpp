#include "views/control/mapjobs/mapjobs.h"

#include "jobs/jobtexts.h"
#include "jobs/packmap.h"
#include "solver/live/worker.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/metrics/uvoverlaps.h"
#include "solver/packing/islandgeometry.h"
#include "solver/packing/packmap.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/lightmapjob.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/unwrap.h"
#include "views/ui/numbertext.h"

#include <QCoreApplication>
#include <QThread>

#include <algorithm>
#include <iterator>
#include <limits>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The text about the current stage; empty when it is the same as the job's title.
//! \param bound on the distortion
QString stageText(const JobProgress &progress, double bound)
{
    if (progress.stage == JobStage::SolvingToTheEnd)
        return JobTexts::tr("solving to the end");
    if (progress.stage == JobStage::Refining)
        return JobTexts::tr("fitting the map to the fine mesh");
    if (progress.stage == JobStage::Packing)
        return JobTexts::tr("packing");
    if (!(progress.seamLength > 0))
        return {};
    const QString seams = QString::number(progress.seamLength, 'f', 2);
    const QString distortion = QString::number(progress.distortion, 'f', 3);
    return progress.distortion > bound
               ? JobTexts::tr("adding cuts until the stretch is allowed, D %1 so far").arg(distortion)
               : JobTexts::tr("shortening seams, %1 so far, D %2").arg(seams, distortion);
}

//! Adds what the user should know. \param done what was done, a sentence without a full stop; may be empty
void tell(const Snapshot &snapshot, const jobs::MapRemarks &remarks, const QString &done,
          MapJobResult &result)
{
    QStringList sentences = jobs::textsOf(remarks.notes);
    if (!done.isEmpty())
        sentences.prepend(done);
    result.message = sentences.join(u". "_s);
    if (remarks.problems.empty())
        return;
    result.problem = (sentences + jobs::textsOf(remarks.problems)).join(u". "_s);
    result.problemItems = itemsOf(snapshot, remarks.problems);
}

} // namespace

JobContext contextOf(JobControl &control, double bound)
{
    return {&control.stop(), QThread::idealThreadCount(),
            [&control, bound, shown = QString(), furthest = 0.0](const JobProgress &progress) mutable {
                furthest = std::max(furthest, progress.fraction);
                control.setProgress(furthest);
                if (const QString text = stageText(progress, bound); text != shown)
                    control.setStage(shown = text);
            }};
}

std::shared_ptr<const JobScope> scopeOf(const MeshData &mesh, const QList<int> &faces, bool attached,
                                        bool chosen)
{
    JobScope scope{std::vector<bool>(mesh.faceCount(), false), attached, chosen};
    for (const int face : faces)
        scope.faces[face] = true;
    return std::make_shared<const JobScope>(std::move(scope));
}

Selection itemsOf(const Snapshot &snapshot, const jobs::Remarks &remarks)
{
    using Kind = jobs::Remark::Kind;
    Selection selection;
    for (const jobs::Remark &remark : remarks) {
        const QList<int> items(remark.items.begin(), remark.items.end());
        if (remark.kind == Kind::UnmetPins) {
            selection.mode = SelectionMode::Vertices;
            selection.corners = items;
        } else if (remark.kind == Kind::UnmetRectangles) {
            selection.mode = SelectionMode::Faces;
            for (const int i : items) {
                for (const int corner : snapshot.steering->rectangles[i].soupCorners)
                    selection.faces << snapshot.mesh->triangleFace[corner / 3];
            }
        } else if (!items.isEmpty()) {
            selection.mode = SelectionMode::Edges;
            selection.edges = items;
        }
        if (!items.isEmpty())
            break; // the most important ones
    }
    selection.normalize(*snapshot.mesh);
    return selection;
}

void tellNewOverlaps(const MapInput &input, const JobControl &control, MapJobResult &result)
{
    metrics::UvOverlapOptions options;
    options.faceFlags = input.marks.faceFlags;
    options.job = &control.stop();
    const auto pairsOf = [&](const UvMatrix &uv) {
        std::vector<std::pair<int, int>> pairs;
        for (const overlap::OverlapPair &pair : metrics::findUvOverlaps(input.mesh(), uv, options).pairs)
            pairs.emplace_back(pair.first, pair.second);
        return pairs;
    };
    const auto after = pairsOf(result.uv);
    if (after.empty())
        return;
    std::vector<std::pair<int, int>> added;
    const auto before = pairsOf(input.uv);
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(added));
    if (added.empty() || control.stop())
        return;
    for (const auto &[first, second] : added)
        result.problemItems.faces << input.mesh().triangleFace[first] << input.mesh().triangleFace[second];
    result.problemItems.mode = SelectionMode::Faces;
    result.problemItems.normalize(input.mesh());
    result.problem =
        JobTexts::tr("%1. Now faces overlap that did not before: %2. Pack (P), separate (O) or undo")
            .arg(result.message)
            .arg(result.problemItems.faces.size());
}

MapJobResult unwrapJob(const MapInput &input, unwrap::UnwrapQuality quality,
                       std::function<void(const unwrap::UnwrapResult &)> better, JobControl &control)
{
    unwrap::UnwrapOptions options;
    options.quality = quality;
    options.better = std::move(better);
    options.maxDistortion = input.snapshot.settings.maxDistortion;
    options.packing = packing::tileOptions(input.packing);
    const unwrap::UnwrapResult made =
        unwrap::unwrapMesh(input.snapshot, options, contextOf(control, options.maxDistortion));
    MapJobResult result;
    result.edit = input.snapshot.scope ? UvEdit::UnwrapSelection : UvEdit::Unwrap;
    const bool hadMap = input.snapshot.uv != nullptr;
    if (made.stopped && !made.nothingFree && (made.onlyPatches || (hadMap && !made.withinBound))) {
        result.problem = hadMap ? JobTexts::tr("Unwrapping was cancelled: the map stays as it was")
                                : JobTexts::tr("Unwrapping was cancelled before there was a map");
        return result;
    }
    QString done;
    if (!made.nothingFree) {
        result.uv = made.uv;
        result.flags = made.flags;
        if (input.snapshot.settings.surface == SurfaceKind::Auto)
            result.hardShare = made.hardShare;
    }
    if (!made.nothingFree && !made.nothingGained) {
        const double distortion =
            metrics::measureShapes(input.mesh(), made.uv, input.snapshot.tileHeight).tileDirichlet;
        done = (made.stopped ? JobTexts::tr("Unwrapping ended early, with the best map so far: distortion %1")
                             : JobTexts::tr("Unwrapped: distortion %1"))
                   .arg(fixedText(distortion, 4));
    }
    tell(input.snapshot, jobs::remarksOn(input.snapshot, options, made), done, result);
    return result;
}

MapJobResult finishJob(const MapInput &input, JobControl &control)
{
    unwrap::FinishInput finish;
    finish.snapshot = input.snapshot;
    if (const live::SolveResult *live = input.live.result.get()) {
        const double *first = live->soupUv.data();
        finish.live = {{first, first + live->soupUv.size()},
                       live->status.lambda,
                       live->status.delta,
                       input.live.hasMoreToDo};
    }
    MapJobResult result;
    if (!finish.live && !finish.snapshot.uv) {
        result.problem = JobTexts::tr("There is no map yet: unwrap first");
        return result;
    }
    finish.maxDistortion = input.snapshot.settings.maxDistortion;
    finish.packing = packing::tileOptions(input.packing);
    const unwrap::FinishResult made = unwrap::finishMap(finish, contextOf(control, finish.maxDistortion));
    result.edit = input.snapshot.scope ? UvEdit::FinishSelection : UvEdit::Finish;
    QString done;
    if (!made.nothingFree)
        result.uv = made.uv;
    if (result.uv.rows() > 0 && !made.nothingGained)
        done = JobTexts::tr("Finished: distortion %1").arg(fixedText(made.distortion, 4));
    tell(input.snapshot, jobs::remarksOn(finish, made, control.stop()), done, result);
    return result;
}

MapJobResult priceJob(const MapInput &input, JobControl &control)
{
    MapJobResult result;
    result.prices = unwrap::priceSeams(input.snapshot, contextOf(control));
    if (!result.prices->hasMap)
        result.problem =
            JobTexts::tr("Seams have no price on a map with turned-over triangles or open joins: "
                         "unwrap or finish it first");
    else
        result.message = JobTexts::tr("Seams priced: %1").arg(result.prices->seams.size());
    return result;
}

MapJobResult packJob(const MapInput &input, const PackTarget &target, JobControl &control)
{
    const MeshData &mesh = input.mesh();
    const ChartMap charts = dividedByObjects(findCharts(mesh, input.uv), target.choice.groups);
    unwrap::PackJob pack = unwrap::steeredPackJob(input.snapshot, packing::tileOptions(input.packing));
    pack.movable.assign(mesh.faceCount(), target.all);
    for (int face : target.faces.isEmpty() ? input.selectedFaces : target.faces)
        pack.movable[face] = true;
    MapJobResult result;
    if (std::find(pack.movable.begin(), pack.movable.end(), true) == pack.movable.end()) {
        result.problem = JobTexts::tr("Select the islands to pack first");
        return result;
    }
    const int count = unwrap::movingCharts(mesh, charts, pack);
    bool hasUvs = false;
    for (int face = 0; face < mesh.faceCount(); ++face)
        hasUvs = hasUvs || (pack.movable[face] && charts.faceChart[face] >= 0);
    if (count == 0 && hasUvs) {
        result.problem = JobTexts::tr("Nothing may move: the islands are locked or pinned");
        return result;
    }
    if (target.box)
        pack.packInto(*target.box);
    jobs::PackChoice choice = target.choice;
    choice.firstTile = input.packing.udimTile;
    jobs::PackedMap packed =
        jobs::packMap(mesh, charts, std::move(pack), choice, input.uv, contextOf(control));
    result.uv = std::move(packed.uv);
    tell(input.snapshot, packed.remarks, {}, result);
    if (target.box && result.uv.rows() == 0 && !control.stop())
        result.problem = JobTexts::tr("There is no room in the rectangle: draw a larger one or use a smaller "
                                      "margin");
    return result;
}

namespace {

MapJobResult separated(const MapInput &input, bool keepsScale, const unwrap::SeparateResult &made)
{
    MapJobResult result;
    result.edit = UvEdit::Separate;
    result.uv = made.outcome == unwrap::SeparateResult::Outcome::Done ? made.uv : UvMatrix();
    tell(input.snapshot, jobs::remarksOn(input.snapshot, keepsScale, made), {}, result);
    return result;
}

} // namespace

MapJobResult separateJob(const MapInput &input, overlap::SeparationMethod method, JobControl &control)
{
    const unwrap::PackJob pack = unwrap::steeredPackJob(input.snapshot, packing::tileOptions(input.packing));
    // With "keep scale" in the settings the islands keep their sizes.
    return separated(input, input.packing.keepScale,
                     unwrap::separateMap(input.snapshot, pack, contextOf(control), method));
}

MapJobResult lightmapJob(const MapInput &input, JobControl &control)
{
    packing::PackOptions options = packing::tileOptions(input.packing);
    options.keepScale = false;
    return separated(input, false, unwrap::makeLightmap(input.snapshot, options, contextOf(control)));
}

MapJobResult equalizeJob(const MapInput &input, JobControl &control)
{
    const MeshData &mesh = input.mesh();
    const ChartMap charts = findCharts(mesh, input.uv);
    const auto faces = charts.faces();
    std::vector<bool> locked(charts.count);
    for (int c = 0; c < charts.count; ++c)
        locked[c] = input.marks.flagsOf(faces[c]).locked != 0;
    for (const Pin &pin : input.snapshot.steering->pins) {
        const int chart = charts.faceChart[mesh.triangleFace[pin.soupCorner / 3]];
        if (chart >= 0)
            locked[chart] = true;
    }
    MapJobResult result;
    result.edit = UvEdit::Scale;
    result.uv = input.uv;
    packing::equalizeTexelDensity(mesh, charts, result.uv, locked);
    result.message = JobTexts::tr("All islands have the same texel density");
    tellNewOverlaps(input, control, result);
    return result;
}

} // namespace autocuts
