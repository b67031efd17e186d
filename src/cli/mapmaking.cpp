#include "cli/mapmaking.h"

#include "cli/batchpacking.h"
#include "cli/batchscope.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/unwrap.h"

#include <algorithm>

namespace autocuts {

namespace {

void setUv(Scene &scene, const UvMatrix &uv)
{
    if (scene.uvSets.empty())
        scene.uvSets.push_back({QStringLiteral("UVMap"), {}});
    scene.uvSets.front().uv = uv;
}

//! Joins the edges inside locked charts, so that they are not cut.
void holdTogether(const ChartMap &charts, const std::vector<IslandFlags> &flags, Snapshot &snapshot)
{
    const MeshData &mesh = *snapshot.mesh;
    std::vector<PairState> &states = snapshot.editSteering().pairState;
    states.resize(mesh.cornerPairCount(), PairState::Free);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        const int face = mesh.triangleFace[pair.triangle[0]];
        if (flags[face].locked == 0 || pair.diagonal ||
            charts.faceChart[face] != charts.faceChart[mesh.triangleFace[pair.triangle[1]]])
            continue;
        states[2 * e] = states[2 * e + 1] = PairState::Joined;
    }
}

} // namespace

Result<MadeMap> MapMaking::unwrap(Scene &scene) const
{
    const Result<Snapshot> snapshot = snapshotOf(scene);
    if (!snapshot)
        return snapshot.error();
    const unwrap::UnwrapResult result = unwrap::unwrapMesh(snapshot.value(), mOptions.unwrap, mJob);
    if (mOptions.unwrap.pack && !result.packed)
        return noRoomError(mOptions);
    setUv(scene, result.uv);
    MadeMap outcome;
    sayGivenSeams(snapshot.value(), outcome);
    outcome.iterations = result.iterations;
    outcome.lambda = result.lambda;
    outcome.delta = result.delta;
    if (result.symmetry == 0.0)
        outcome.warnings << QStringLiteral("the mesh is not symmetric: nor are the cuts");
    else if (result.symmetry)
        outcome.notes
            << QStringLiteral("symmetric part of the seams: %1 %").arg(100 * *result.symmetry, 0, 'f', 1);
    if (!result.withinBound)
        outcome.warnings << boundMissed(result.distortion);
    return outcome;
}

Result<MadeMap> MapMaking::pack(Scene &scene) const
{
    if (!scene.hasUv())
        return noUvs();
    UvMatrix uv = scene.uvSets.front().uv;
    const MeshData &mesh = *scene.mesh;
    Result<unwrap::PackJob> pack = batchPacking(mOptions, mFiles, mesh);
    if (!pack)
        return pack.error();
    const auto scope = batchScope(mOptions, scene);
    if (!scope)
        return scope.error();
    ChartMap charts = findCharts(mesh, uv);
    if (const JobScope *part = scope.value().get()) {
        if (!part->attached)
            charts = chartsAlong(*part, charts);
        if (const std::optional<Error> problem = limitPacking(*part, charts, pack.value()))
            return *problem;
    }
    const JobContext job = mJob.part(0, 1, JobStage::Packing);
    if (!unwrap::packCharts(mesh, charts, pack.value(), uv, job))
        return noRoomError(mOptions);
    setUv(scene, uv);
    return MadeMap{};
}

Result<MadeMap> MapMaking::separate(Scene &scene) const
{
    using Separation = unwrap::SeparateResult::Outcome;
    if (!scene.hasUv())
        return noUvs();
    Result<Snapshot> snapshot = snapshotOf(scene);
    if (!snapshot)
        return snapshot.error();
    Result<unwrap::PackJob> pack = batchPacking(mOptions, mFiles, *scene.mesh);
    if (!pack)
        return pack.error();
    if (const JobScope *part = snapshot->scope.get()) {
        const ChartMap charts = findCharts(*scene.mesh, scene.uvSets.front().uv);
        if (const std::optional<Error> problem = limitPacking(*part, charts, pack.value()))
            return *problem;
        holdTogether(charts, pack->faceFlags, snapshot.value());
    }
    const unwrap::SeparateResult made =
        unwrap::separateMap(snapshot.value(), scene.uvSets.front().uv, pack.value(), mJob);
    MadeMap outcome;
    switch (made.outcome) {
    case Separation::Done:
        setUv(scene, made.uv);
        outcome.notes << QStringLiteral("edges cut to take overlaps apart: %1").arg(made.newSeams);
        if (made.unresolvedPairs > 0)
            outcome.warnings << QStringLiteral("overlaps inside single polygons, across joined edges or "
                                               "outside of --only, which stay: %1")
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
    finish.uv = scene.uvSets.front().uv;
    finish.uvScale = mFiles.uvScale(scene);
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
    sayGivenSeams(snapshot.value(), outcome);
    if (made.heldTogether)
        outcome.warnings << QStringLiteral("the map still covers itself: joined edges hold it together");
    if (made.distortion > mOptions.unwrap.maxDistortion)
        outcome.warnings << boundMissed(made.distortion);
    return outcome;
}

Result<Snapshot> MapMaking::snapshotOf(const Scene &scene) const
{
    Result<Snapshot> snapshot = mFiles.snapshot(scene, mOptions.settings);
    if (!snapshot)
        return snapshot;
    const auto scope = batchScope(mOptions, scene);
    if (!scope)
        return scope.error();
    snapshot->scope = scope.value();
    return snapshot;
}

std::optional<Error> MapMaking::limitPacking(const JobScope &scope, const ChartMap &charts,
                                             unwrap::PackJob &pack) const
{
    if (lockOutside(scope, charts, pack.faceFlags))
        return {};
    return Error{QStringLiteral("no island lies as a whole in what --only names"), mOptions.input, 0,
                 QStringLiteral("Name more, or cut the islands with pack --border free")};
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
    if (count == 0)
        made.warnings << QStringLiteral("there are no given seams: --seams-from names where they come from");
}

QString MapMaking::boundMissed(double distortion) const
{
    return QStringLiteral("the distortion is %1, above the bound of %2")
        .arg(distortion, 0, 'g', 6)
        .arg(mOptions.unwrap.maxDistortion);
}

Error MapMaking::noUvs() const
{
    return {QStringLiteral("the file has no UVs"), mOptions.input, 0,
            QStringLiteral("Make them with autocuts-cli unwrap")};
}

} // namespace autocuts
