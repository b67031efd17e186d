#include "views/control/mapjobs.h"

#include "model/document/rigidpieces.h"
#include "model/plain/uvlayout.h"
#include "solver/definite/refinedmap.h"
#include "solver/homotopy/liveschedule.h"
#include "solver/live/worker.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/overlap/uvseparation.h"
#include "solver/packing/islandgeometry.h"
#include "solver/packing/packmap.h"
#include "solver/preference/seampreference.h"
#include "views/control/mapcontroller.h"

#include <QThread>

#include <algorithm>

namespace autocuts {

namespace {

//! Corners of a finished map that are no farther apart than this belong together, squared solver units.
constexpr double touchingDelta = 1e-9;
//! A live solve often takes about so many steps.
constexpr double usualSteps = 1000;

QString translated(const char *text)
{
    return MapController::tr(text);
}

packing::PackOptions packOptions(const PackingSettings &packing)
{
    packing::PackOptions options = packing::tileOptions(packing);
    options.threads = QThread::idealThreadCount();
    return options;
}

//! Packs the charts; the locked ones, and when only some are to be packed the others, stay where they are.
//! Returns false when there is no room.
bool packInto(UvMatrix &uv, const MeshData &mesh, const ChartMap &charts, const IslandMarks &marks,
              const std::vector<bool> &movable, const packing::PackOptions &settings, JobControl &control)
{
    const RigidPieces rigid = rigidPieces(charts, marks, movable);
    return packing::packMap(mesh, rigid.pieces, rigid.locked, settings, uv, &control.stop(),
                            [&](double fraction) { control.setProgress(fraction); })
        .complete;
}

int packedCharts(const ChartMap &charts, const std::vector<bool> &movable)
{
    std::vector<bool> packed(charts.count);
    for (std::size_t f = 0; f < movable.size(); ++f) {
        if (charts.faceChart[f] >= 0 && movable[f])
            packed[charts.faceChart[f]] = true;
    }
    return static_cast<int>(std::count(packed.begin(), packed.end(), true));
}

//! True when all islands lie in the unit square and none over another.
bool lieFree(const MeshData &mesh, const UvMatrix &uv, JobControl &control)
{
    overlap::OverlapOptions options;
    options.maxPairs = 1;
    options.cancel = &control.stop();
    return uv.minCoeff() >= 0 && uv.maxCoeff() <= 1 &&
           overlap::findOverlaps(soupUv(mesh, uv), options).pairs.empty();
}

QString noRoom(const PackingSettings &packing)
{
    return packing.keepScale
               ? translated("The islands do not fit at their size: switch off \"Keep scale\" or use a "
                            "smaller margin")
               : translated("There is no room for the margins: use a smaller margin or a larger texture");
}

} // namespace

MapJobResult unwrapJob(const MapInput &input, unwrap::UnwrapQuality quality, double maxDistortion,
                       JobControl &control)
{
    unwrap::UnwrapOptions options;
    options.quality = quality;
    options.maxDistortion = maxDistortion;
    options.packing = packOptions(input.packing);
    options.packing.keepScale = false;
    options.threads = QThread::idealThreadCount();
    const unwrap::UnwrapResult made =
        unwrap::unwrapMesh(input.snapshot, options, &control.stop(), [&](const unwrap::UnwrapProgress &progress) {
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
}

MapJobResult finishJob(const MapInput &input, double maxDistortion, JobControl &control)
{
    const LiveSolve &live = input.live;
    Snapshot snapshot = input.snapshot;
    if (!live.result) {
        snapshot.settings.start = StartMode::ExistingUv;
        snapshot.startUv = std::make_shared<const UvMatrix>(soupUv(input.mesh(), input.uv) / input.uvScale);
        snapshot.settings.delta = touchingDelta;
    } else {
        snapshot.settings.lambda = live.result->status.lambda;
        snapshot.settings.delta = live.result->status.delta;
    }
    const int threads = QThread::idealThreadCount();
    homotopy::Solver solver;
    solver.setThreads(threads);
    solver.load(preference::SeamPreference().applied(snapshot, threads));
    if (live.result) {
        const double *first = live.result->soupUv.data();
        solver.setCoordinates({first, first + live.result->soupUv.size()});
    }
    double begun = 0;
    if (live.hasMoreToDo) {
        control.setStage(translated("solving to the end"));
        int steps = 0;
        homotopy::runToTheEnd(solver, maxDistortion, &control.stop(), [&] {
            ++steps;
            begun = 0.5 * steps / (steps + usualSteps); // their number is not known
            control.setProgress(begun);
        });
        control.setStage({});
    }
    definite::RefinedMapOptions options;
    options.maxDistortion = maxDistortion;
    options.threads = threads;
    MapJobResult result;
    result.edit = UvEdit::Finish;
    const std::optional<SeamedMap> map =
        definite::makeRefinedMap(solver, options, &control.stop(), [&](double fraction) {
            control.setProgress(begun + (1 - begun) * fraction);
        });
    if (!map) {
        result.problem = translated("Finishing was cancelled: the map stays as it was");
        return result;
    }
    result.uv = input.uvScale * cornerUv(solver.soup(), *map);
    result.message = translated("Finished: distortion %1").arg(map->distortion(solver.soup()), 0, 'f', 4);
    // Islands that grew or were cut off may lie over others. Pins and rectangles say where islands belong.
    const MeshData &mesh = input.mesh();
    if (!snapshot.placesIslands() && !lieFree(mesh, result.uv, control)) {
        const std::vector<bool> all(mesh.faceCount(), true);
        if (!packInto(result.uv, mesh, findCharts(mesh, result.uv), IslandMarks::none(mesh), all,
                      packOptions(input.packing), control) &&
            !control.stop())
            result.problem = noRoom(input.packing);
    }
    const auto &states = snapshot.steering->pairState;
    const bool joins = std::find(states.begin(), states.end(), PairState::Joined) != states.end();
    if (joins && result.problem.isEmpty() && !overlap::findOverlaps(soupUv(mesh, result.uv)).pairs.empty())
        result.problem = translated("The map still covers itself: joined edges hold it together there. Clear "
                                    "some joins and finish again");
    return result;
}

MapJobResult packJob(const MapInput &input, const PackTarget &target, JobControl &control)
{
    const MeshData &mesh = input.mesh();
    const ChartMap charts = findCharts(mesh, input.uv);
    std::vector<bool> movable(mesh.faceCount(), target.all);
    for (int face : target.faces.isEmpty() ? input.selectedFaces : target.faces)
        movable[face] = true;
    if (std::find(movable.begin(), movable.end(), true) == movable.end()) {
        MapJobResult result;
        result.problem = translated("Select the islands to pack first");
        return result;
    }
    packing::PackOptions settings = packOptions(input.packing);
    if (target.box) {
        settings.lower = target.box->min();
        settings.upper = target.box->max();
    }
    MapJobResult result;
    result.uv = input.uv;
    if (packInto(result.uv, mesh, charts, input.marks, movable, settings, control)) {
        result.message = translated("Islands packed: %1").arg(packedCharts(charts, movable));
    } else {
        result.uv.resize(0, 2);
        result.problem = control.stop() ? translated("Packing was cancelled: the map stays as it was")
                         : target.box
                             ? translated("There is no room in the rectangle: draw a larger one or use "
                                          "a smaller margin")
                             : noRoom(input.packing);
    }
    return result;
}

MapJobResult separateJob(const MapInput &input, JobControl &control)
{
    const MeshData &mesh = input.mesh();
    const overlap::Separated separated = overlap::separateUv(input.snapshot, input.uv, &control.stop());
    MapJobResult result;
    result.edit = UvEdit::Separate;
    if (!separated.complete) {
        result.problem = translated("Separating was cancelled: the map stays as it was");
        return result;
    }
    result.uv = input.uv;
    const std::vector<bool> all(mesh.faceCount(), true);
    if (!packInto(result.uv, mesh, separated.charts, input.marks, all, packOptions(input.packing), control)) {
        result.uv.resize(0, 2);
        result.problem = noRoom(input.packing);
        return result;
    }
    result.message = translated("Separated, edges cut: %1").arg(separated.newSeams);
    if (separated.unresolvedPairs > 0)
        result.problem =
            translated("Overlaps inside single polygons or across joined edges, which stay whole: %1")
                .arg(separated.unresolvedPairs);
    return result;
}

MapJobResult equalizeJob(const MapInput &input)
{
    const MeshData &mesh = input.mesh();
    const ChartMap charts = findCharts(mesh, input.uv);
    const auto faces = charts.faces();
    std::vector<bool> locked(charts.count);
    for (int c = 0; c < charts.count; ++c)
        locked[c] = input.marks.flagsOf(faces[c]).locked != 0;
    MapJobResult result;
    result.edit = UvEdit::Scale;
    result.uv = input.uv;
    packing::equalizeTexelDensity(mesh, charts, result.uv, locked);
    result.message = translated("All islands have the same texel density");
    return result;
}

} // namespace autocuts
