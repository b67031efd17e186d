#include "cli/mapmaking.h"

#include "cli/batchpacking.h"
#include "cli/batchscope.h"
#include "model/plain/udimtiles.h"
#include "solver/preference/meshsymmetry.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/lightmapjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/tilepacking.h"
#include "solver/unwrap/unwrap.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

void setUv(Scene &scene, const UvMatrix &uv)
{
    if (scene.uvSets.empty())
        scene.uvSets.push_back({QStringLiteral("UVMap"), {}});
    scene.uvSets.front().uv = uv;
}

//! The tiles in which the islands of a job stay.
QString tilesInWords(const std::vector<int> &tiles)
{
    QStringList numbers;
    for (const int tile : tiles)
        numbers << QString::number(tile);
    return numbers.join(QStringLiteral(", "));
}

//! Says of a map of a stopped job whether it was straightened. \param straight see unwrap::UnwrapResult
void sayStraight(const std::optional<bool> &straight, MadeMap &outcome)
{
    if (straight)
        outcome.warnings << QLatin1String(*straight ? "stopped early: this map is straightened"
                                                    : "stopped early: this map is not, or not wholly, "
                                                      "straightened");
}

//! What the model was taken for.
QString recognised(double hardShare)
{
    const int percent = static_cast<int>(std::lround(100 * hardShare));
    if (percent == 0 || percent == 100)
        return QStringLiteral("recognised as %1 (--for says otherwise)")
            .arg(QLatin1String(percent == 0 ? "organic" : "hard surface"));
    return QStringLiteral("recognised %1 % of the surface as hard surface, the rest as organic (--for says "
                          "otherwise)")
        .arg(percent);
}

//! Says how symmetric the seams are, and what of the mesh has no mirror image.
void saySymmetry(double share, const MeshData &mesh, MadeMap &outcome)
{
    outcome.notes << QStringLiteral("symmetric part of the seams: %1 %").arg(100 * share, 0, 'f', 1);
    const auto symmetry = preference::findSymmetry(mesh);
    if (symmetry && symmetry->matchedArea < 0.999)
        outcome.warnings << QStringLiteral("%1 % of the surface have no mirror image: their cuts are free")
                                .arg(100 * (1 - symmetry->matchedArea), 0, 'f', 1);
}

} // namespace

Result<MadeMap> MapMaking::unwrap(Scene &scene) const
{
    const Result<Snapshot> snapshot = snapshotOf(scene);
    if (!snapshot)
        return snapshot.error();
    const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshot.value(), mOptions.unwrap, mJob);
    MadeMap outcome;
    if (result.nothingFree) {
        outcome.warnings << nothingFree();
        return outcome;
    }
    if (mOptions.unwrap.pack && !result.packed)
        return noRoomError(mOptions);
    setUv(scene, result.uv);
    outcome.flags = result.flags;
    if (const Result<Done> packed = packIntoTiles(snapshot.value(), scene, outcome); !packed)
        return packed.error();
    if (result.onlyPatches)
        outcome.warnings << QLatin1String(result.stopped
                                              ? "stopped before a map with few seams was found: this one is "
                                                "made of many flat patches"
                                              : "the mesh is too irregular for a map with few seams: this "
                                                "one is made of many flat patches");
    outcome.warnings << unmetText(result.unmet);
    if (result.stopped)
        sayStraight(result.straight, outcome);
    if (result.nothingGained)
        outcome.notes << QStringLiteral("no better map was found: it stays as it was");
    sayGivenSeams(snapshot.value(), outcome);
    outcome.iterations = result.iterations;
    outcome.hardShare = result.hardShare;
    if (mOptions.settings.surface == SurfaceKind::Auto)
        outcome.notes << recognised(result.hardShare);
    outcome.lambda = result.lambda;
    outcome.delta = result.delta;
    if (result.upright)
        outcome.notes << QStringLiteral("the islands stand upright (--world-up - lets them turn)");
    if (result.symmetry && mOptions.settings.symmetry == SymmetryMode::Auto)
        outcome.notes << QStringLiteral(
            "recognised as symmetric: both sides have the same seams (--no-symmetry "
            "says otherwise)");
    else if (result.symmetry == 0.0)
        outcome.warnings << QStringLiteral("the mesh is not symmetric: nor are the cuts");
    else if (result.symmetry)
        saySymmetry(*result.symmetry, *scene.mesh, outcome);
    if (result.symmetryMissed)
        outcome.warnings << QStringLiteral("no symmetric cuts met the bound: the cuts are free");
    if (!result.withinBound)
        sayBoundMissed(result.distortion, outcome);
    return outcome;
}

Result<MadeMap> MapMaking::pack(Scene &scene) const
{
    if (!scene.hasUv())
        return noUvs();
    const Result<Snapshot> snapshot = snapshotOf(scene);
    if (!snapshot)
        return snapshot.error();
    MadeMap outcome;
    if (const Result<Done> packed = packIslands(snapshot.value(), scene, outcome); !packed)
        return packed.error();
    return outcome;
}

Result<Done> MapMaking::packIntoTiles(const Snapshot &snapshot, Scene &scene, MadeMap &made) const
{
    return mOptions.per || mOptions.density > 0 ? packIslands(snapshot, scene, made) : Result<Done>(Done{});
}

Result<Done> MapMaking::packIslands(const Snapshot &snapshot, Scene &scene, MadeMap &made) const
{
    UvMatrix uv = scene.uvSets.front().uv;
    const MeshData &mesh = *scene.mesh;
    Result<unwrap::PackJob> pack = batchPacking(mOptions, mFiles, snapshot);
    if (!pack)
        return pack.error();
    if (!made.flags.empty())
        pack->faceFlags = made.flags;
    pack->options.keepStraight = true;
    ChartMap charts = findCharts(mesh, uv);
    if (const JobScope *scope = snapshot.scope.get()) {
        if (!scope->attached)
            charts = chartsAlong(*scope, charts);
        if (!holdsWholeChart(*scope, charts))
            return noWholeChart();
    }
    if (mOptions.density > 0 || mOptions.fillTiles)
        return distribute(charts, pack.value(), scene, made);
    if (mOptions.per) {
        charts = dividedByObjects(std::move(charts), sceneGroups(scene, *mOptions.per));
        Result<std::vector<int>> tiles = batchTiles(mOptions, scene, charts);
        if (!tiles)
            return tiles.error();
        pack->tiles = std::move(tiles).value();
    }
    const JobContext job = mJob.part(0, 1, JobStage::Packing);
    if (!unwrap::packCharts(mesh, charts, pack.value(), uv, job))
        return noRoomError(mOptions);
    if (const std::vector<int> kept = usedTiles(pack->tiles); !mOptions.per && kept.size() > 1)
        made.notes << QStringLiteral("islands stay in their tiles: %1 (--tiles one packs them into one)")
                          .arg(tilesInWords(kept));
    setUv(scene, uv);
    return Done{};
}

Result<Done> MapMaking::distribute(const ChartMap &charts, const unwrap::PackJob &pack, Scene &scene,
                                   MadeMap &made) const
{
    using Outcome = unwrap::TilePackingResult::Outcome;
    const UvMatrix &uv = scene.uvSets.front().uv;
    unwrap::TilePacking tiles;
    tiles.firstTile = mOptions.unwrap.packing.udimTile;
    if (mOptions.fillTiles)
        tiles = unwrap::fillingTiles(*scene.mesh, charts, pack, uv);
    if (mOptions.density > 0)
        tiles.density = mOptions.density;
    const JobContext job = mJob.part(0, 1, JobStage::Packing);
    const unwrap::TilePackingResult packed = unwrap::packOverTiles(*scene.mesh, charts, pack, tiles, uv, job);
    switch (packed.outcome) {
    case Outcome::Done:
        break;
    case Outcome::TooMany:
        return Error{QStringLiteral("the islands need more UDIM tiles than there are"), mOptions.input, 0,
                     QStringLiteral("Use a smaller --density or a larger --texture-size")};
    case Outcome::Stopped:
    case Outcome::NoRoom:
        return noRoomError(mOptions);
    }
    made.notes << QStringLiteral("islands packed: %1, into the tiles %2")
                      .arg(packed.packed)
                      .arg(tilesInWords(packed.tiles));
    if (packed.tooLarge > 0)
        made.warnings << QStringLiteral(
                             "islands larger than a tile at this density, and made smaller to fit: %1")
                             .arg(packed.tooLarge);
    setUv(scene, packed.uv);
    return Done{};
}

Result<MadeMap> MapMaking::separate(Scene &scene) const
{
    if (!scene.hasUv())
        return noUvs();
    const Result<Snapshot> snapshot = snapshotOf(scene);
    if (!snapshot)
        return snapshot.error();
    const Result<unwrap::PackJob> pack = batchPacking(mOptions, mFiles, snapshot.value());
    if (!pack)
        return pack.error();
    if (snapshot->scope &&
        !holdsWholeChart(*snapshot->scope, findCharts(*scene.mesh, scene.uvSets.front().uv)))
        return noWholeChart();
    const unwrap::SeparateResult made =
        unwrap::separateMap(snapshot.value(), pack.value(), mJob, mOptions.separation);
    Result<MadeMap> outcome = separated(scene, made);
    using Separation = unwrap::SeparateResult::Outcome;
    if (outcome && (made.outcome == Separation::Done || made.outcome == Separation::NoOverlaps)) {
        if (const Result<Done> packed = packIntoTiles(snapshot.value(), scene, outcome.value()); !packed)
            return packed.error();
    }
    return outcome;
}

Result<MadeMap> MapMaking::lightmap(Scene &scene) const
{
    if (!scene.hasUv())
        return noUvs();
    const Result<Snapshot> snapshot = snapshotOf(scene);
    if (!snapshot)
        return snapshot.error();
    return separated(scene, unwrap::makeLightmap(snapshot.value(), mOptions.unwrap.packing, mJob));
}

Result<MadeMap> MapMaking::separated(Scene &scene, const unwrap::SeparateResult &made) const
{
    using Separation = unwrap::SeparateResult::Outcome;
    MadeMap outcome;
    switch (made.outcome) {
    case Separation::Done:
        setUv(scene, made.uv);
        outcome.notes << QStringLiteral("edges cut to take overlaps apart: %1").arg(made.newSeams);
        if (made.unresolvedPairs > 0)
            outcome.warnings << QStringLiteral("overlaps inside single polygons or across joined edges, "
                                               "which stay whole: %1")
                                    .arg(made.unresolvedPairs);
        break;
    case Separation::NoOverlaps:
        outcome.notes << QStringLiteral("there are no overlaps: the map stays as it is");
        break;
    case Separation::Stopped:
        outcome.warnings << QStringLiteral("stopped before the overlaps were taken apart");
        break;
    case Separation::NoRoom:
        return noRoomError(mOptions);
    case Separation::NothingFree:
        outcome.warnings << nothingFree();
        break;
    }
    return outcome;
}

Result<MadeMap> MapMaking::finish(Scene &scene) const
{
    if (!scene.hasUv())
        return noUvs();
    const Result<Snapshot> snapshot = snapshotOf(scene);
    if (!snapshot)
        return snapshot.error();
    unwrap::FinishInput finish;
    finish.snapshot = snapshot.value();
    finish.maxDistortion = mOptions.unwrap.maxDistortion;
    finish.packing = mOptions.unwrap.packing;
    const unwrap::FinishResult made = unwrap::finishMap(finish, mJob);
    MadeMap outcome;
    if (made.uv.rows() == 0) {
        outcome.warnings << QStringLiteral("stopped before there was a finished map");
        return outcome;
    }
    if (made.noRoom)
        return noRoomError(mOptions);
    setUv(scene, made.uv);
    if (const Result<Done> packed = packIntoTiles(snapshot.value(), scene, outcome); !packed)
        return packed.error();
    if (made.madeSmaller)
        outcome.warnings << QStringLiteral("there is no room for the islands at their scale: all of a tile "
                                           "are smaller now");
    if (made.nothingGained)
        outcome.notes << QStringLiteral("no better map was found: it stays as it was");
    if (made.notReplaced > 0)
        outcome.notes << QStringLiteral("islands that stay as they were, because there is no room for better "
                                        "ones: %1")
                             .arg(made.notReplaced);
    if (made.nothingFree)
        outcome.warnings << nothingFree();
    else if (!made.withinBound)
        sayBoundMissed(made.distortion, outcome);
    outcome.warnings << unmetText(made.unmet);
    if (mJob.stopped())
        sayStraight(made.straight, outcome);
    sayGivenSeams(snapshot.value(), outcome);
    if (made.heldTogether)
        outcome.warnings << QStringLiteral("the map still covers itself: joined edges hold it together");
    return outcome;
}

Result<Snapshot> MapMaking::snapshotOf(const Scene &scene) const
{
    SolveSettings settings = mOptions.settings;
    if (mOptions.per == SceneKind::Materials && settings.seams == SeamMode::Free) {
        settings.seams = SeamMode::Keep;
        settings.givenSeams = {.cuts = false, .map = false, .materials = true};
    }
    Result<Snapshot> snapshot = mFiles.snapshot(scene, settings, mOptions.unwrap.packing.tileHeight());
    if (!snapshot)
        return snapshot;
    const auto scope = batchScope(mOptions, scene);
    if (!scope)
        return scope.error();
    snapshot->scope = scope.value();
    snapshot->keepTiles = !mOptions.oneTile && (snapshot->keepTiles || hasOwnTiles(snapshot.value()));
    return snapshot;
}

//! True when the map of a file lies in other tiles than the first one, and the job arranges it.
bool MapMaking::hasOwnTiles(const Snapshot &snapshot) const
{
    if (mOptions.command == CliOptions::Command::Unwrap || !snapshot.uv ||
        mOptions.unwrap.packing.udimTile != PackingSettings::firstTile)
        return false;
    const std::vector<int> tiles =
        usedTiles(udimTiles(*snapshot.mesh, *snapshot.uv, mOptions.unwrap.packing.tileHeight()));
    return !tiles.empty() && tiles != std::vector{PackingSettings::firstTile};
}

void MapMaking::sayGivenSeams(const Snapshot &snapshot, MadeMap &made) const
{
    if (snapshot.settings.seams == SeamMode::Free) {
        if (mOptions.given.contains(QStringLiteral("--seams-from")))
            made.warnings << QStringLiteral("--seams-from does nothing without --seams keep or only");
        return;
    }
    const std::vector<bool> &given = snapshot.steering->givenSeams;
    const auto count = std::count(given.begin(), given.end(), true);
    made.notes << QStringLiteral("given seams: %1").arg(count);
    if (count == 0 && mOptions.settings.seams != SeamMode::Free)
        made.warnings << QStringLiteral("there are no given seams: --seams-from names where they come from");
}

void MapMaking::sayBoundMissed(double distortion, MadeMap &made) const
{
    made.boundMissed = true;
    made.warnings << QStringLiteral("the distortion is %1, above the bound of %2")
                         .arg(distortion, 0, 'g', 6)
                         .arg(mOptions.unwrap.maxDistortion);
}

QString MapMaking::nothingFree() const
{
    return QStringLiteral(
        "the map stays as it is: locks, stacks, groups or the scope leave nothing to change");
}

QStringList MapMaking::unmetText(const unwrap::UnmetSteering &unmet) const
{
    const auto numbers = [](const std::vector<int> &items) {
        QStringList list;
        for (const int item : items)
            list << QString::number(item);
        return list.join(QStringLiteral(", "));
    };
    QStringList lines;
    if (!unmet.pins.empty())
        lines << QStringLiteral("hard pins that could not be reached, at the corners %1")
                     .arg(numbers(unmet.pins));
    if (!unmet.joins.empty())
        lines << QStringLiteral("joined edges that had to stay open: %1").arg(numbers(unmet.joins));
    if (!unmet.bent.empty())
        lines << QStringLiteral("edges kept straight that are bent: %1").arg(numbers(unmet.bent));
    if (!unmet.missingSeams.empty())
        lines << QStringLiteral("seams that are not given and were needed: the edges %1")
                     .arg(numbers(unmet.missingSeams));
    if (!unmet.rectangles.empty())
        lines << QStringLiteral("rectangles that islands reach out of: %1").arg(numbers(unmet.rectangles));
    return lines;
}

Error MapMaking::noWholeChart() const
{
    return {QStringLiteral("no island lies as a whole in what --only names"), mOptions.input, 0,
            QStringLiteral("Name more, or cut the islands with pack --border free")};
}

Error MapMaking::noUvs() const
{
    return {QStringLiteral("the file has no UVs"), mOptions.input, 0,
            QStringLiteral("Make them with autocuts-cli unwrap")};
}

} // namespace autocuts
