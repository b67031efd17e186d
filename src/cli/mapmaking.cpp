#include "cli/mapmaking.h"

#include "cli/batchpacking.h"
#include "cli/batchscope.h"
#include "jobs/packmap.h"
#include "model/plain/udimtiles.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/lightmapjob.h"
#include "solver/unwrap/separatejob.h"
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

//! The text of a remark with what the command line adds to it.
QString lineOf(const jobs::Remark &remark, const CliOptions &options)
{
    using Kind = jobs::Remark::Kind;
    QString text = jobs::textOf(remark);
    if (remark.kind == Kind::Upright)
        return text + QStringLiteral(" (--world-up - lets them turn)");
    if (remark.kind == Kind::SymmetricSeams && options.settings.symmetry == SymmetryMode::Auto)
        return text + QStringLiteral(" (--no-symmetry leaves the cuts free)");
    if (remark.kind == Kind::IslandsPacked || remark.items.empty())
        return text;
    return text + QStringLiteral(" (%1 %2)")
                      .arg(QLatin1String(remark.kind == Kind::UnmetPins         ? "corners"
                                         : remark.kind == Kind::UnmetRectangles ? "rectangles"
                                                                                : "edges"),
                           jobs::inWords(remark.items));
}

} // namespace

Result<MadeMap> MapMaking::unwrap(Scene &scene) const
{
    const Result<Snapshot> snapshot = snapshotOf(scene);
    if (!snapshot)
        return snapshot.error();
    const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshot.value(), mOptions.unwrap, mJob);
    MadeMap outcome;
    say(jobs::remarksOn(snapshot.value(), mOptions.unwrap, result), outcome);
    if (result.nothingFree)
        return outcome;
    if (mOptions.unwrap.pack && !result.packed)
        return noRoomError(mOptions);
    setUv(scene, result.uv);
    outcome.flags = result.flags;
    if (const Result<Done> packed = packIntoTiles(snapshot.value(), scene, outcome); !packed)
        return packed.error();
    sayGivenSeams(snapshot.value(), outcome);
    outcome.iterations = result.iterations;
    outcome.hardShare = result.hardShare;
    if (mOptions.settings.surface == SurfaceKind::Auto)
        outcome.notes << recognised(result.hardShare);
    outcome.lambda = result.lambda;
    outcome.delta = result.delta;
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
    const MeshData &mesh = *scene.mesh;
    Result<unwrap::PackJob> pack = batchPacking(mOptions, mFiles, snapshot);
    if (!pack)
        return pack.error();
    if (!made.flags.empty())
        pack->faceFlags = made.flags;
    ChartMap charts = findCharts(mesh, scene.uvSets.front().uv);
    if (const JobScope *scope = snapshot.scope.get()) {
        if (!scope->attached)
            charts = chartsAlong(*scope, charts);
        if (!holdsWholeChart(*scope, charts))
            return noWholeChart();
    }
    jobs::PackChoice choice;
    choice.density = mOptions.density;
    choice.fillTiles = mOptions.fillTiles;
    choice.firstTile = mOptions.unwrap.packing.udimTile;
    if (mOptions.per && choice.density == 0 && !choice.fillTiles)
        choice.groups = sceneGroups(scene, *mOptions.per);
    const std::vector<int> kept = usedTiles(pack->tiles);
    const jobs::PackedMap packed = jobs::packMap(mesh, std::move(charts), std::move(pack).value(), choice,
                                                 scene.uvSets.front().uv, mJob.part(0, 1, JobStage::Packing));
    if (packed.uv.rows() == 0)
        return errorOf(packed.remarks.problems.front().kind);
    say(packed.remarks, made);
    if (kept.size() > 1 && choice.density == 0 && !choice.fillTiles && !mOptions.per)
        made.notes << QStringLiteral("islands stay in their tiles: %1 (--tiles one packs them into one)")
                          .arg(jobs::inWords(kept));
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
    Result<MadeMap> outcome = separated(snapshot.value(), scene, made);
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
    return separated(snapshot.value(), scene,
                     unwrap::makeLightmap(snapshot.value(), mOptions.unwrap.packing, mJob));
}

Result<MadeMap> MapMaking::separated(const Snapshot &snapshot, Scene &scene,
                                     const unwrap::SeparateResult &made) const
{
    using Separation = unwrap::SeparateResult::Outcome;
    if (made.outcome == Separation::NoRoom)
        return noRoomError(mOptions);
    MadeMap outcome;
    say(jobs::remarksOn(snapshot, mOptions.unwrap.packing.keepScale, made), outcome);
    if (made.outcome == Separation::Done)
        setUv(scene, made.uv);
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
    say(jobs::remarksOn(finish, made, mJob.stopped()), outcome);
    if (made.uv.rows() == 0)
        return outcome;
    if (made.noRoom)
        return noRoomError(mOptions);
    setUv(scene, made.uv);
    if (const Result<Done> packed = packIntoTiles(snapshot.value(), scene, outcome); !packed)
        return packed.error();
    sayGivenSeams(snapshot.value(), outcome);
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

void MapMaking::say(const jobs::MapRemarks &remarks, MadeMap &made) const
{
    for (const jobs::Remark &note : remarks.notes)
        made.notes << lineOf(note, mOptions);
    for (const jobs::Remark &problem : remarks.problems) {
        made.warnings << lineOf(problem, mOptions);
        made.boundMissed = made.boundMissed || problem.kind == jobs::Remark::Kind::AboveBound;
    }
}

Error MapMaking::errorOf(jobs::Remark::Kind problem) const
{
    switch (problem) {
    case jobs::Remark::Kind::TooManyTiles:
        return {QStringLiteral("the islands need more UDIM tiles than there are"), mOptions.input, 0,
                QStringLiteral("Use a smaller --density or a larger --texture-size")};
    case jobs::Remark::Kind::TooManyGroups:
        return {QStringLiteral("there are more objects or materials than UDIM tiles"), mOptions.input, 0,
                QStringLiteral("Pack the file in parts, with --only")};
    case jobs::Remark::Kind::MapCancelled:
        return {QStringLiteral("stopped before the islands were packed"), mOptions.input, 0,
                QStringLiteral("Give it a longer --time-limit")};
    default:
        return noRoomError(mOptions);
    }
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
