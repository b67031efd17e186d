#include "views/control/mapjobs/mapjobs.h"

#include "jobs/jobtexts.h"
#include "model/plain/uvlayout.h"
#include "solver/live/worker.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/metrics/uvoverlaps.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/packing/islandgeometry.h"
#include "solver/packing/packmap.h"
#include "solver/preference/meshsymmetry.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/lightmapjob.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/tilepacking.h"
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

QString noRoom(const PackingSettings &packing)
{
    return packing.keepScale
               ? JobTexts::tr("The islands do not fit at their size: switch off \"Keep each island's scale\" "
                              "or use a "
                              "smaller margin")
               : JobTexts::tr("There is no room for the margins: use a smaller margin or a larger texture");
}

QString nothingFree()
{
    return JobTexts::tr(
        "Nothing may change: all islands are locked, pinned, stacked or grouped, or outside the scope");
}

QString aboveBound(double distortion, double bound)
{
    return JobTexts::tr("The distortion of %1 is above the bound of %2: allow more, or remove joins")
        .arg(fixedText(distortion, 4))
        .arg(bound, 0, 'f', 4);
}

//! Says what the map does not obey, and what to select.
void showUnmet(const MapInput &input, const unwrap::UnmetSteering &unmet, MapJobResult &result)
{
    result.problem = unmetText(input.snapshot, unmet, result.problemItems);
}

//! Says it where faces that have to stay lie on others: no job takes them apart.
void sayHeldOverlaps(const MapInput &input, MapJobResult &result)
{
    const Steering &steering = *input.snapshot.steering;
    const bool stacks =
        std::ranges::any_of(steering.faceFlags, [](const IslandFlags &f) { return f.stack != 0; });
    const bool holds =
        std::ranges::any_of(steering.pins, &Pin::hard) ||
        std::ranges::any_of(steering.faceFlags, [](const IslandFlags &f) { return f.locked != 0; });
    if (!result.problem.isEmpty() || result.uv.rows() == 0 || stacks || !holds ||
        overlap::findOverlaps(soupUv(input.mesh(), result.uv)).pairs.empty())
        return;
    result.problem =
        JobTexts::tr("%1. Pins or locks hold faces on each other: remove some of them").arg(result.message);
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

QString unmetText(const Snapshot &snapshot, const unwrap::UnmetSteering &unmet, Selection &selection)
{
    QStringList items;
    if (!unmet.rectangles.empty()) {
        items << JobTexts::tr("rectangles: %1").arg(unmet.rectangles.size());
        selection.mode = SelectionMode::Faces;
        for (const int i : unmet.rectangles) {
            for (const int corner : snapshot.steering->rectangles[i].soupCorners)
                selection.faces << snapshot.mesh->triangleFace[corner / 3];
        }
    }
    if (!unmet.missingSeams.empty()) {
        items << JobTexts::tr("seams that are not given and were needed: %1").arg(unmet.missingSeams.size());
        selection.mode = SelectionMode::Edges;
        selection.edges = QList<int>(unmet.missingSeams.begin(), unmet.missingSeams.end());
    }
    if (!unmet.joins.empty()) {
        items << JobTexts::tr("joined edges: %1").arg(unmet.joins.size());
        selection.mode = SelectionMode::Edges;
        selection.edges = QList<int>(unmet.joins.begin(), unmet.joins.end());
    }
    if (!unmet.pins.empty()) {
        items << JobTexts::tr("hard pins: %1").arg(unmet.pins.size());
        selection.mode = SelectionMode::Vertices;
        selection.corners = QList<int>(unmet.pins.begin(), unmet.pins.end());
    }
    if (!unmet.bent.empty()) {
        items << JobTexts::tr("edges kept straight, which are bent: %1").arg(unmet.bent.size());
        selection.mode = SelectionMode::Edges;
        selection.edges = QList<int>(unmet.bent.begin(), unmet.bent.end());
    }
    selection.normalize(*snapshot.mesh);
    return JobTexts::tr(
               "Not obeyed, because something else contradicts it or it would turn triangles over: %1")
        .arg(items.join(u", "_s));
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

//! Says of a map of a stopped job whether it was straightened. \param straight see unwrap::UnwrapResult
void sayStraight(bool stopped, const std::optional<bool> &straight, MapJobResult &result)
{
    if (!stopped || !straight || result.message.isEmpty())
        return;
    result.message += *straight
                          ? JobTexts::tr(". Stopped early: this map is straightened")
                          : JobTexts::tr(". Stopped early: this map is not, or not wholly, straightened");
}

QString asymmetryText(double mirrored)
{
    constexpr double nearlyAll = 0.999;
    if (mirrored == 0)
        return JobTexts::tr("The mesh is not symmetric: nor are the cuts");
    return mirrored >= nearlyAll
               ? QString()
               : JobTexts::tr("%1 % of the surface have no mirror image: their cuts are free")
                     .arg(100 * (1 - mirrored), 0, 'f', 1);
}

//! Says how symmetric the seams are, and what has no mirror image.
//! \param asked by the user; otherwise only where the seams are symmetric
void saySymmetry(const unwrap::UnwrapResult &made, const MeshData &mesh, bool asked, MapJobResult &result)
{
    const auto symmetry = preference::findSymmetry(mesh);
    if (symmetry)
        result.message += JobTexts::tr(", %1 % of the seams symmetric").arg(100 * *made.symmetry, 0, 'f', 1);
    if (!asked)
        return;
    if (made.symmetryMissed) {
        result.problem =
            result.message + u". "_s + JobTexts::tr("No symmetric cuts met the bound: the cuts are free");
        return;
    }
    if (const QString text = asymmetryText(symmetry ? symmetry->matchedArea : 0); !text.isEmpty())
        result.problem = result.message + u". "_s + text;
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
    if (made.nothingFree) {
        result.problem = nothingFree();
        return result;
    }
    const bool hadMap = input.snapshot.uv != nullptr;
    if (made.stopped && (made.onlyPatches || (hadMap && !made.withinBound))) {
        result.problem = hadMap ? JobTexts::tr("Unwrapping was cancelled: the map stays as it was")
                                : JobTexts::tr("Unwrapping was cancelled before there was a map");
        return result;
    }
    result.uv = made.uv;
    result.flags = made.flags;
    if (input.snapshot.settings.surface == SurfaceKind::Auto)
        result.hardShare = made.hardShare;
    const double distortion =
        metrics::measureShapes(input.mesh(), made.uv, input.snapshot.tileHeight).tileDirichlet;
    result.message =
        made.nothingGained ? JobTexts::tr("Unwrapped: no better map was found, it stays as it was")
        : made.stopped     ? JobTexts::tr("Unwrapping ended early, with the best map so far: distortion %1")
                             .arg(fixedText(distortion, 4))
                       : JobTexts::tr("Unwrapped: distortion %1").arg(fixedText(distortion, 4));
    if (made.upright)
        result.message += JobTexts::tr(", islands upright");
    sayStraight(made.stopped, made.straight, result);
    if (!made.packed)
        result.problem = noRoom(input.packing);
    else if (made.madeSmaller)
        result.problem =
            JobTexts::tr("%1. There is no room for the islands at their scale: all of a tile are smaller now")
                .arg(result.message);
    else if (!made.unmet.empty())
        showUnmet(input, made.unmet, result);
    else if (!made.withinBound)
        result.problem = aboveBound(distortion, options.maxDistortion);
    else if (made.symmetry)
        saySymmetry(made, input.mesh(), input.snapshot.settings.symmetry == SymmetryMode::On, result);
    sayHeldOverlaps(input, result);
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
    if (made.nothingFree) {
        result.problem = nothingFree();
        return result;
    }
    result.uv = made.uv;
    if (made.uv.rows() == 0)
        result.problem = JobTexts::tr("Finishing was cancelled: the map stays as it was");
    else if (made.noRoom)
        result.problem = noRoom(input.packing);
    else if (!made.unmet.empty())
        showUnmet(input, made.unmet, result);
    else if (made.heldTogether)
        result.problem =
            JobTexts::tr("The map still covers itself: joined edges hold it together there. Clear "
                         "some joins and finish again");
    else if (!made.withinBound && input.snapshot.settings.seams != SeamMode::Only)
        result.problem = aboveBound(made.distortion, finish.maxDistortion);
    else if (made.nothingGained)
        result.message = JobTexts::tr("Finished: no better map was found, it stays as it was");
    else
        result.message = JobTexts::tr("Finished: distortion %1").arg(fixedText(made.distortion, 4));
    if (!result.message.isEmpty() && made.madeSmaller)
        result.problem =
            JobTexts::tr("%1. There is no room for the islands at their scale: all of a tile are smaller now")
                .arg(result.message);
    else if (!result.message.isEmpty() && made.notReplaced > 0)
        result.message = JobTexts::tr("%1. Islands that stay as they were, because there is no room for "
                                      "better ones: %2")
                             .arg(result.message)
                             .arg(made.notReplaced);
    sayStraight(control.stop(), made.straight, result);
    sayHeldOverlaps(input, result);
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

namespace {

//! Packs over tiles, by density or into those in use.
MapJobResult distribute(const MapInput &input, const ChartMap &charts, const unwrap::PackJob &pack,
                        const PackTarget &target, JobControl &control)
{
    using Outcome = unwrap::TilePackingResult::Outcome;
    unwrap::TilePacking tiles;
    tiles.firstTile = input.packing.udimTile;
    if (target.fillTiles)
        tiles = unwrap::fillingTiles(input.mesh(), charts, pack, input.uv);
    if (target.density > 0)
        tiles.density = target.density;
    unwrap::TilePackingResult packed =
        unwrap::packOverTiles(input.mesh(), charts, pack, tiles, input.uv, contextOf(control));
    MapJobResult result;
    switch (packed.outcome) {
    case Outcome::Done:
        break;
    case Outcome::Stopped:
        result.problem = JobTexts::tr("Packing was cancelled: the map stays as it was");
        return result;
    case Outcome::NoRoom:
        result.problem = noRoom(input.packing);
        return result;
    case Outcome::TooMany:
        result.problem = JobTexts::tr("The islands need more UDIM tiles than there are: choose a lower "
                                      "density or a larger texture");
        return result;
    }
    QStringList numbers;
    for (const int tile : packed.tiles)
        numbers << QString::number(tile);
    result.uv = std::move(packed.uv);
    result.message =
        JobTexts::tr("Islands packed: %1, into the tiles %2").arg(packed.packed).arg(numbers.join(u", "_s));
    if (packed.tooLarge > 0)
        result.problem = JobTexts::tr("%1. Larger than a tile at this density, and made smaller to fit: %2")
                             .arg(result.message)
                             .arg(packed.tooLarge);
    return result;
}

} // namespace

MapJobResult packJob(const MapInput &input, const PackTarget &target, JobControl &control)
{
    const MeshData &mesh = input.mesh();
    const ChartMap charts = dividedByObjects(findCharts(mesh, input.uv), target.groups);
    unwrap::PackJob pack = unwrap::steeredPackJob(input.snapshot, packing::tileOptions(input.packing));
    pack.options.keepStraight = true;
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
    if (target.density > 0 || target.fillTiles)
        return distribute(input, charts, pack, target, control);
    if (target.box)
        pack.packInto(*target.box);
    if (!target.groups.empty()) {
        pack.tiles = tilesOfGroups(target.groups, charts, input.packing.udimTile);
        if (pack.tiles.empty()) {
            result.problem = JobTexts::tr("There are more of them than UDIM tiles");
            return result;
        }
    }
    UvMatrix uv = input.uv;
    if (unwrap::packCharts(mesh, charts, pack, uv, contextOf(control))) {
        result.uv = std::move(uv);
        result.message = JobTexts::tr("Islands packed: %1").arg(count);
    } else {
        result.problem = control.stop() ? JobTexts::tr("Packing was cancelled: the map stays as it was")
                         : target.box
                             ? JobTexts::tr("There is no room in the rectangle: draw a larger one or use "
                                            "a smaller margin")
                             : noRoom(input.packing);
    }
    return result;
}

namespace {

MapJobResult separated(const MapInput &input, const unwrap::SeparateResult &made)
{
    using Outcome = unwrap::SeparateResult::Outcome;
    MapJobResult result;
    result.edit = UvEdit::Separate;
    switch (made.outcome) {
    case Outcome::Done:
        result.uv = made.uv;
        result.message = JobTexts::tr("Separated, edges cut: %1").arg(made.newSeams);
        if (made.unresolvedPairs > 0)
            result.problem =
                JobTexts::tr("Overlaps inside single polygons or across joined edges, which stay whole: %1")
                    .arg(made.unresolvedPairs);
        sayHeldOverlaps(input, result);
        break;
    case Outcome::NoOverlaps:
        result.message = JobTexts::tr("There are no overlaps: the map stays as it is");
        break;
    case Outcome::Stopped:
        result.problem = JobTexts::tr("Separating was cancelled: the map stays as it was");
        break;
    case Outcome::NoRoom:
        result.problem = noRoom(input.packing);
        break;
    case Outcome::NothingFree:
        result.problem = nothingFree();
        break;
    }
    return result;
}

} // namespace

MapJobResult separateJob(const MapInput &input, overlap::SeparationMethod method, JobControl &control)
{
    const unwrap::PackJob pack = unwrap::steeredPackJob(input.snapshot, packing::tileOptions(input.packing));
    // With "keep scale" in the settings the islands keep their sizes.
    return separated(input, unwrap::separateMap(input.snapshot, pack, contextOf(control), method));
}

MapJobResult lightmapJob(const MapInput &input, JobControl &control)
{
    packing::PackOptions options = packing::tileOptions(input.packing);
    options.keepScale = false;
    const unwrap::SeparateResult made = unwrap::makeLightmap(input.snapshot, options, contextOf(control));
    MapJobResult result = separated(input, made);
    if (made.outcome == unwrap::SeparateResult::Outcome::Done)
        result.message = JobTexts::tr("Map for lightmaps, edges cut: %1").arg(made.newSeams);
    return result;
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
