// The functions that make a map: each calls the job of the engine that the command line calls.
#include "api/failure.h"
#include "api/mapoutput.h"
#include "api/meshinput.h"
#include "model/plain/chart.h"
#include "model/transfer/uvtransfer.h"
#include "solver/unwrap/aligning.h"
#include "solver/unwrap/alikestacks.h"
#include "solver/unwrap/finishjob.h"
#include "solver/unwrap/lightmapjob.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/tilepacking.h"
#include "solver/unwrap/unwrap.h"

using namespace autocuts;
using namespace autocuts::api;

namespace {

using MadeMap = std::unique_ptr<autocuts_map>;

//! A call that makes a map. \param make gets the job and returns the map
template <class Make>
autocuts_status making(const autocuts_mesh *mesh, const autocuts_options *options, autocuts_map **map,
                       autocuts_error *error, MapNeed need, Make make)
{
    if (map)
        *map = nullptr;
    return guarded(error, [&] {
        if (!map)
            throw badInput("there is no place for the map");
        Job job;
        fill(mesh, options, need, job);
        MadeMap made = make(job);
        made->outcome.stopped = made->outcome.stopped || job.stop;
        *map = made.release();
    });
}

MadeMap resultOf(const Job &job, UvMatrix uv)
{
    return mapOf(job.snapshot, job.options.packing, std::move(uv));
}

unwrap::PackJob packJobOf(const Job &job)
{
    unwrap::PackJob pack = unwrap::steeredPackJob(job.snapshot, job.options.packing);
    pack.hurry = unwrap::PackHurry::WhenStopped;
    return pack;
}

//! Packs the islands of a map at the density that is asked for, over tiles.
UvMatrix atDensity(const Job &job, const unwrap::PackJob &pack, UvMatrix uv)
{
    using Outcome = unwrap::TilePackingResult::Outcome;
    if (job.density == 0)
        return uv;
    unwrap::TilePacking tiles;
    tiles.density = job.density;
    const MeshData &mesh = *job.snapshot.mesh;
    unwrap::TilePackingResult packed =
        unwrap::packOverTiles(mesh, findCharts(mesh, uv), pack, tiles, uv, job.context.unstoppable());
    if (packed.outcome == Outcome::TooMany)
        throw Failure{AUTOCUTS_NO_ROOM, "the islands need more UDIM tiles than there are",
                      "Use a lower density or a larger texture"};
    if (packed.outcome != Outcome::Done)
        throw noRoom();
    return std::move(packed.uv);
}

MadeMap mapOfUnwrap(const Job &job, unwrap::UnwrapResult made)
{
    MadeMap map = resultOf(job, std::move(made.uv));
    map->outcome.stopped = made.stopped;
    map->outcome.within_bound = made.withinBound;
    map->outcome.hard_share = made.hardShare;
    setUnmet(made.unmet, map->outcome);
    return map;
}

MadeMap unwrapped(Job &job)
{
    if (job.better)
        job.options.better = [&job](const unwrap::UnwrapResult &made) {
            job.better(mapOfUnwrap(job, made).release());
        };
    unwrap::UnwrapResult made = unwrap::unwrapMesh(job.snapshot, job.options, job.context);
    if (!made.packed && !made.nothingFree)
        throw noRoom();
    if (!made.nothingFree) {
        unwrap::PackJob pack = unwrap::steeredPackJob(job.snapshot, job.options.packing);
        if (!made.flags.empty())
            pack.faceFlags = made.flags;
        made.uv = atDensity(job, pack, std::move(made.uv));
    }
    return mapOfUnwrap(job, std::move(made));
}

MadeMap finished(Job &job)
{
    unwrap::FinishInput input;
    input.snapshot = job.snapshot;
    input.maxDistortion = job.options.maxDistortion;
    input.packing = job.options.packing;
    unwrap::FinishResult made = unwrap::finishMap(input, job.context);
    if (made.uv.rows() == 0)
        throw Failure{AUTOCUTS_STOPPED, "stopped before there was a finished map"};
    if (made.noRoom)
        throw noRoom();
    MadeMap map = resultOf(job, atDensity(job, packJobOf(job), std::move(made.uv)));
    map->outcome.within_bound = made.nothingFree || made.withinBound;
    setUnmet(made.unmet, map->outcome);
    return map;
}

MadeMap packed(Job &job)
{
    UvMatrix uv = *job.snapshot.uv;
    const MeshData &mesh = *job.snapshot.mesh;
    const ChartMap charts = findCharts(mesh, uv);
    unwrap::PackJob pack = packJobOf(job);
    if (job.snapshot.settings.alike == AlikeMode::Stack)
        unwrap::stackAlike(mesh, charts, pack, uv);
    pack.options.keepStraight = true;
    if (job.density > 0)
        return resultOf(job, atDensity(job, pack, std::move(uv)));
    if (!unwrap::packCharts(mesh, charts, pack, uv, job.context))
        throw noRoom();
    return resultOf(job, std::move(uv));
}

MadeMap separated(Job &job, const unwrap::SeparateResult &made)
{
    using Outcome = unwrap::SeparateResult::Outcome;
    if (made.outcome == Outcome::NoRoom)
        throw noRoom();
    if (made.outcome == Outcome::Stopped)
        throw Failure{AUTOCUTS_STOPPED, "stopped before the overlaps were taken apart"};
    const UvMatrix &uv = made.outcome == Outcome::Done ? made.uv : *job.snapshot.uv;
    return resultOf(job, atDensity(job, packJobOf(job), uv));
}

MadeMap aligned(Job &job)
{
    job.snapshot.scope = std::make_shared<const JobScope>(
        JobScope{std::vector<bool>(std::size_t(job.snapshot.mesh->faceCount()), true)});
    const unwrap::AlignResult made =
        unwrap::alignIslands({job.snapshot, job.options.maxDistortion, job.options.packing}, job.context);
    if (made.flipped)
        throw badInput("triangles of the map are flipped", "Finish the map first");
    if (made.noRoom)
        throw noRoom();
    return resultOf(job, made.uv.rows() > 0 ? made.uv : *job.snapshot.uv);
}

MadeMap transferred(const autocuts_mesh *source, autocuts_match match, Job &job,
                    autocuts_transferred *figures)
{
    using Status = transfer::UvTransfer::Status;
    if (!source || !source->uvs)
        throw badInput("there is no source with UVs");
    if (match < AUTOCUTS_MATCH_AUTO || match > AUTOCUTS_MATCH_POSITION)
        throw badInput("there is no such way to match faces");
    Snapshot from;
    from.mesh = meshOf(*source);
    from.tileHeight = job.snapshot.tileHeight;
    autocuts_mesh given{};
    given.uvs = source->uvs;
    takeWishes(given, from);
    const MeshData &mesh = *job.snapshot.mesh;
    transfer::TransferControl control;
    control.stopped = [&job] { return job.stop.load(); };
    control.progress = [&job](double fraction) { job.context.report(fraction); };
    transfer::Placement placement;
    transfer::UvTransfer made = transfer::transferAnywhere(
        {*from.mesh, *from.uv, mesh, static_cast<transfer::UvMatch>(match)}, control, placement);
    switch (made.status) {
    case Status::Done:
        break;
    case Status::Stopped:
        throw Failure{AUTOCUTS_STOPPED, "stopped before the UVs were transferred"};
    case Status::NoUvs:
        throw badInput("no triangle of the source has UVs");
    case Status::OtherPolygons:
        throw badInput("the polygons are not the same", "Match by position");
    case Status::Apart:
        throw badInput("the meshes do not lie in one place",
                       "Move them to the same place, in the same units");
    }
    const UvMatrix *before = job.snapshot.uv.get();
    for (Eigen::Index c = 0; before && c < made.uv.rows(); ++c) {
        if (!made.uv.row(c).allFinite())
            made.uv.row(c) = before->row(c);
    }
    if (figures)
        *figures = {made.figures.faces, made.figures.copied, made.figures.placed, made.figures.meanDistance,
                    placement.scale};
    return resultOf(job, std::move(made.uv));
}

} // namespace

autocuts_status autocuts_unwrap(const autocuts_mesh *mesh, const autocuts_options *options,
                                autocuts_map **map, autocuts_error *error)
{
    return making(mesh, options, map, error, MapNeed::None, unwrapped);
}

autocuts_status autocuts_finish(const autocuts_mesh *mesh, const autocuts_options *options,
                                autocuts_map **map, autocuts_error *error)
{
    return making(mesh, options, map, error, MapNeed::Needed, finished);
}

autocuts_status autocuts_pack(const autocuts_mesh *mesh, const autocuts_options *options, autocuts_map **map,
                              autocuts_error *error)
{
    return making(mesh, options, map, error, MapNeed::Needed, packed);
}

autocuts_status autocuts_separate(const autocuts_mesh *mesh, const autocuts_options *options,
                                  autocuts_map **map, autocuts_error *error)
{
    return making(mesh, options, map, error, MapNeed::Needed, [](Job &job) {
        return separated(job, unwrap::separateMap(job.snapshot, packJobOf(job), job.context));
    });
}

autocuts_status autocuts_align(const autocuts_mesh *mesh, const autocuts_options *options, autocuts_map **map,
                               autocuts_error *error)
{
    return making(mesh, options, map, error, MapNeed::Needed, aligned);
}

autocuts_status autocuts_lightmap(const autocuts_mesh *mesh, const autocuts_options *options,
                                  autocuts_map **map, autocuts_error *error)
{
    return making(mesh, options, map, error, MapNeed::Needed, [](Job &job) {
        return separated(job, unwrap::makeLightmap(job.snapshot, job.options.packing, job.context));
    });
}

autocuts_status autocuts_take(const autocuts_mesh *mesh, const autocuts_options *options, autocuts_map **map,
                              autocuts_error *error)
{
    return making(mesh, options, map, error, MapNeed::Needed,
                  [](Job &job) { return resultOf(job, *job.snapshot.uv); });
}

autocuts_status autocuts_transfer(const autocuts_mesh *source, const autocuts_mesh *mesh,
                                  autocuts_match match, const autocuts_options *options, autocuts_map **map,
                                  autocuts_transferred *figures, autocuts_error *error)
{
    return making(mesh, options, map, error, MapNeed::None,
                  [&](Job &job) { return transferred(source, match, job, figures); });
}
