// The C interface of the library: checks what comes in, calls the jobs of the engine, keeps what comes out.
#include <autocuts/autocuts.h>

#include "model/plain/chart.h"
#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/packing/packmap.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/separatejob.h"
#include "solver/unwrap/tilepacking.h"
#include "solver/unwrap/unwrap.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

using namespace autocuts;

struct autocuts_map
{
    std::shared_ptr<const MeshData> mesh;
    UvMatrix uv; //!< texture space
    PackingSettings packing;
    std::vector<double> given; //!< u, v of each corner, as in files
    std::vector<std::int32_t> islands;
    std::vector<std::uint8_t> seams;
    std::size_t islandCount = 0;
    bool stopped = false;
};

namespace {

//! Ends a call with a status and the texts for the caller.
struct Failure
{
    autocuts_status status;
    std::string message, remedy;
};

Failure badInput(const std::string &message, const std::string &remedy = {})
{
    return {AUTOCUTS_BAD_INPUT, message, remedy};
}

void copyText(const std::string &text, char *out, std::size_t room)
{
    const std::size_t length = text.copy(out, room - 1);
    out[length] = 0;
}

//! What a call works on.
struct Job
{
    Snapshot snapshot;
    packing::PackOptions packing;
    unwrap::UnwrapOptions options;
    double density = 0; //!< texels per unit; 0: the islands fill one tile
    std::atomic<bool> stop = false;
    JobContext context;
};

std::vector<int> faceStarts(const autocuts_mesh &mesh)
{
    constexpr std::size_t most = std::numeric_limits<int>::max();
    std::vector<int> starts{0};
    starts.reserve(mesh.face_count + 1);
    std::size_t corner = 0;
    for (std::size_t face = 0; face < mesh.face_count; ++face) {
        const std::uint32_t size = mesh.face_sizes ? mesh.face_sizes[face] : 3;
        if (size < 3)
            throw badInput("face " + std::to_string(face) + " has fewer than three corners", "Leave it out");
        corner += size;
        if (corner > most)
            throw badInput("the mesh has more than 2^31 corners", "Divide it");
        starts.push_back(static_cast<int>(corner));
    }
    return starts;
}

std::shared_ptr<const MeshData> meshOf(const autocuts_mesh &mesh)
{
    if (mesh.vertex_count > std::size_t(std::numeric_limits<int>::max()))
        throw badInput("the mesh has more than 2^31 vertices", "Divide it");
    if ((!mesh.positions && mesh.vertex_count > 0) || (!mesh.indices && mesh.face_count > 0))
        throw badInput("the arrays of the mesh are missing");
    if (mesh.face_count == 0)
        throw badInput("the mesh has no faces");
    PositionMatrix positions(static_cast<Eigen::Index>(mesh.vertex_count), 3);
    for (std::size_t v = 0; v < mesh.vertex_count; ++v) {
        for (int k = 0; k < 3; ++k) {
            const double value = mesh.positions[3 * v + std::size_t(k)];
            if (!(std::abs(value) <= 1e150))
                throw badInput("the position of vertex " + std::to_string(v) +
                                   " is not a number that can be used",
                               "Leave out the faces at it");
            positions(static_cast<Eigen::Index>(v), k) = value;
        }
    }
    std::vector<int> starts = faceStarts(mesh);
    std::vector<int> corners;
    corners.reserve(std::size_t(starts.back()));
    for (std::size_t c = 0; c < std::size_t(starts.back()); ++c) {
        if (mesh.indices[c] >= mesh.vertex_count)
            throw badInput("index " + std::to_string(c) + " is " + std::to_string(mesh.indices[c]) +
                           ", out of range: there are " + std::to_string(mesh.vertex_count) + " vertices");
        corners.push_back(static_cast<int>(mesh.indices[c]));
    }
    std::vector<int> objects(mesh.face_count, 0);
    for (std::size_t face = 0; mesh.face_objects && face < mesh.face_count; ++face) {
        objects[face] = mesh.face_objects[face];
        if (objects[face] < 0)
            throw badInput("the object of face " + std::to_string(face) + " is below 0");
    }
    return MeshData::build(std::move(positions), std::move(starts), std::move(corners), std::move(objects));
}

PackingSettings packingOf(const autocuts_options &options)
{
    PackingSettings packing;
    if (options.texture_width < 1 || options.texture_height < 1 ||
        std::max(options.texture_width, options.texture_height) > PackingSettings::maxTextureSize)
        throw badInput("the size of the texture is out of range", "Use 1 to 65536 texels");
    packing.setTexture(options.texture_width, options.texture_height);
    if (!(options.margin >= 0) || !std::isfinite(options.margin) || !std::isfinite(options.border))
        throw badInput("the margin is not a number that can be used", "Use 0 texels or more");
    packing.margin = options.margin;
    packing.border = options.border;
    switch (options.rotation) {
    case AUTOCUTS_ROTATION_NONE:
        packing.rotation = PackRotation::None;
        break;
    case AUTOCUTS_ROTATION_QUARTER:
        packing.rotation = PackRotation::Quarter;
        break;
    case AUTOCUTS_ROTATION_ANY:
        packing.rotation = PackRotation::Free;
        break;
    default:
        throw badInput("there is no such rotation");
    }
    packing.keepScale = options.keep_scale != 0;
    if (!(options.pack_effort > 0 && options.pack_effort <= PackingSettings::maxEffort))
        throw badInput("the effort of packing is out of range", "Use up to 3600 seconds");
    packing.effort = options.pack_effort;
    return packing;
}

SolveSettings settingsOf(const autocuts_options &options)
{
    SolveSettings settings;
    if (!(options.max_distortion > 4 && options.max_distortion <= SolveSettings::maxBound))
        throw badInput("the bound on the distortion is not above 4", "4.1 is usual");
    settings.maxDistortion = options.max_distortion;
    if (options.surface < AUTOCUTS_SURFACE_AUTO || options.surface > AUTOCUTS_SURFACE_HARD)
        throw badInput("there is no such kind of surface");
    settings.surface = static_cast<SurfaceKind>(options.surface);
    settings.symmetry = options.symmetry != 0;
    settings.align = options.align != 0 ? CreaseMode::On : CreaseMode::Off;
    return settings;
}

//! Takes the map that is there, in texture space.
void takeUvs(const autocuts_mesh &mesh, Job &job)
{
    const MeshData &data = *job.snapshot.mesh;
    UvMatrix uv(data.cornerCount(), 2);
    for (Eigen::Index c = 0; c < uv.rows(); ++c)
        uv.row(c) << mesh.uvs[2 * c], mesh.uvs[2 * c + 1] * job.snapshot.tileHeight;
    job.snapshot.uvScale = layoutScale(data, uv);
    job.snapshot.uv = std::make_shared<const UvMatrix>(std::move(uv));
    if (!mesh.locked_faces)
        return;
    std::vector<IslandFlags> &flags = job.snapshot.editSteering().faceFlags;
    flags.resize(mesh.face_count);
    for (std::size_t face = 0; face < mesh.face_count; ++face)
        flags[face].locked = mesh.locked_faces[face] != 0;
}

//! Takes the edges that must, or must not, be seams.
void takeEdges(const autocuts_mesh &mesh, Job &job)
{
    const MeshData &data = *job.snapshot.mesh;
    const int corners = data.cornerCount();
    for (int c = 0; c < corners; ++c) {
        if (mesh.edges[c] > AUTOCUTS_EDGE_JOINED)
            throw badInput("the edge of corner " + std::to_string(c) + " is neither free, a seam nor joined");
    }
    std::vector<int> next(static_cast<std::size_t>(corners));
    for (int face = 0; face < data.faceCount(); ++face) {
        const int first = data.faceStart[std::size_t(face)], end = data.faceStart[std::size_t(face) + 1];
        for (int c = first; c < end; ++c)
            next[std::size_t(c)] = c + 1 < end ? c + 1 : first;
    }
    const auto cornerOf = [&](int soupCorner) {
        return data.triangles[std::size_t(soupCorner / 3)][std::size_t(soupCorner % 3)];
    };
    std::vector<PairState> &states = job.snapshot.editSteering().pairState;
    states.assign(std::size_t(data.cornerPairCount()), PairState::Free);
    for (std::size_t e = 0; e < data.edgePairs.size(); ++e) {
        const EdgePair &pair = data.edgePairs[e];
        bool seam = false, joined = false;
        for (std::size_t which = 0; which < 2 && !pair.diagonal; ++which) {
            const int a = cornerOf(pair.corner[0][which]), b = cornerOf(pair.corner[1][which]);
            const std::uint8_t wish = mesh.edges[next[std::size_t(a)] == b ? a : b];
            seam = seam || wish == AUTOCUTS_EDGE_SEAM;
            joined = joined || wish == AUTOCUTS_EDGE_JOINED;
        }
        if (seam || joined)
            states[2 * e] = states[2 * e + 1] = seam ? PairState::Cut : PairState::Joined;
    }
}

//! \param needsMap the call works on the map that is there
void fill(const autocuts_mesh *mesh, const autocuts_options *options, bool needsMap, Job &job)
{
    if (!mesh)
        throw badInput("there is no mesh");
    autocuts_options own;
    autocuts_options_init(&own);
    if (options)
        std::memcpy(&own, options, std::min(options->size, sizeof own));
    if (own.threads < 1)
        throw badInput("the number of threads is below 1");
    if (own.quality < AUTOCUTS_DRAFT || own.quality > AUTOCUTS_BEST)
        throw badInput("there is no such quality");
    job.snapshot.mesh = meshOf(*mesh);
    job.snapshot.settings = settingsOf(own);
    job.packing = packing::tileOptions(packingOf(own));
    job.snapshot.tileHeight = job.packing.tileHeight();
    if (mesh->uvs)
        takeUvs(*mesh, job);
    else if (needsMap)
        throw badInput("the mesh has no UVs");
    if (mesh->edges)
        takeEdges(*mesh, job);
    if (!(own.density >= 0) || !std::isfinite(own.density))
        throw badInput("the density is not a number that can be used", "Use 0 or more texels per unit");
    job.density = own.density;
    if (!(job.snapshot.mesh->area > 0))
        throw badInput("all faces are without area, there is nothing to map",
                       "Check the scale and the vertices of the mesh");
    job.options.quality = static_cast<unwrap::UnwrapQuality>(own.quality);
    job.options.maxDistortion = own.max_distortion;
    job.options.packing = job.packing;
    JobContext::Sink sink;
    if (own.progress)
        sink = [&job, progress = own.progress, user = own.user](const JobProgress &now) {
            if (progress(now.fraction, user) != 0)
                job.stop = true;
        };
    job.context = JobContext(&job.stop, own.threads, std::move(sink));
}

//! Per corner: the side that starts there is a seam or a border.
std::vector<std::uint8_t> seamsOf(const MeshData &mesh, const UvMatrix &uv)
{
    const UvTopology topology = findUvTopology(mesh, uv);
    // The sides by the UV vertices at their ends: stitched sides have the same.
    std::vector<std::pair<std::pair<int, int>, int>> sides;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int first = mesh.faceStart[std::size_t(face)], end = mesh.faceStart[std::size_t(face) + 1];
        for (int c = first; c < end; ++c) {
            const int from = topology.cornerRoot[std::size_t(c)];
            const int to = topology.cornerRoot[std::size_t(c + 1 < end ? c + 1 : first)];
            if (topology.faceHasUv[std::size_t(face)])
                sides.push_back({std::minmax(from, to), c});
        }
    }
    std::ranges::sort(sides);
    std::vector<std::uint8_t> seams(std::size_t(mesh.cornerCount()), 1);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        if (sides[i].first == sides[i - 1].first)
            seams[std::size_t(sides[i].second)] = seams[std::size_t(sides[i - 1].second)] = 0;
    }
    return seams;
}

autocuts_map *mapOf(const Job &job, UvMatrix uv, bool stopped)
{
    auto map = std::make_unique<autocuts_map>();
    map->mesh = job.snapshot.mesh;
    map->uv = std::move(uv);
    map->packing = job.packing;
    map->stopped = stopped;
    for (Eigen::Index c = 0; c < map->uv.rows(); ++c) {
        map->given.push_back(map->uv(c, 0));
        map->given.push_back(map->uv(c, 1) / job.snapshot.tileHeight);
    }
    const ChartMap charts = findCharts(*map->mesh, map->uv);
    map->islands.assign(charts.faceChart.begin(), charts.faceChart.end());
    map->islandCount = std::size_t(charts.count);
    map->seams = seamsOf(*map->mesh, map->uv);
    return map.release();
}

Failure noRoom()
{
    return {AUTOCUTS_NO_ROOM, "there is no room for the margins between the islands",
            "Use a smaller margin or a larger texture"};
}

//! Packs the islands of a map at the wanted density, over tiles.
UvMatrix atDensity(const Job &job, const UvMatrix &uv)
{
    using Outcome = unwrap::TilePackingResult::Outcome;
    unwrap::TilePacking tiles;
    tiles.density = job.density;
    const MeshData &mesh = *job.snapshot.mesh;
    unwrap::TilePackingResult packed =
        unwrap::packOverTiles(mesh, findCharts(mesh, uv), unwrap::steeredPackJob(job.snapshot, job.packing),
                              tiles, uv, job.context.unstoppable());
    if (packed.outcome == Outcome::TooMany)
        throw Failure{AUTOCUTS_NO_ROOM, "the islands need more UDIM tiles than there are",
                      "Use a lower density or a larger texture"};
    if (packed.outcome != Outcome::Done)
        throw noRoom();
    return std::move(packed.uv);
}

//! Runs a call so that nothing is thrown at the caller.
template <class Work>
autocuts_status guarded(autocuts_error *error, Work work)
{
    Failure failure{AUTOCUTS_OK, {}, {}};
    try {
        work();
    } catch (const Failure &known) {
        failure = known;
    } catch (const std::bad_alloc &) {
        failure = {AUTOCUTS_NO_MEMORY, "not enough memory", "Use a smaller mesh"};
    } catch (const std::invalid_argument &bad) {
        failure = badInput(bad.what());
    } catch (const std::exception &fault) {
        failure = {AUTOCUTS_FAILED, fault.what(), {}};
    }
    if (error) {
        copyText(failure.message, error->message, sizeof error->message);
        copyText(failure.remedy, error->remedy, sizeof error->remedy);
    }
    return failure.status;
}

//! A call that makes a map. \param make gets the job and returns the map
template <class Make>
autocuts_status making(const autocuts_mesh *mesh, const autocuts_options *options, autocuts_map **map,
                       autocuts_error *error, bool needsMap, Make make)
{
    if (map)
        *map = nullptr;
    return guarded(error, [&] {
        if (!map)
            throw badInput("there is no place for the map");
        Job job;
        fill(mesh, options, needsMap, job);
        *map = make(job);
    });
}

} // namespace

const char *autocuts_version(void)
{
    return AUTOCUTS_VERSION;
}

void autocuts_options_init(autocuts_options *options)
{
    const SolveSettings settings;
    const PackingSettings packing;
    const unwrap::UnwrapOptions unwrap;
    *options = {};
    options->size = sizeof *options;
    options->quality = static_cast<int>(unwrap.quality);
    options->max_distortion = unwrap.maxDistortion;
    options->surface = static_cast<int>(settings.surface);
    options->texture_width = packing.textureSize;
    options->texture_height = packing.height();
    options->margin = packing.margin;
    options->border = packing.border;
    options->rotation = AUTOCUTS_ROTATION_ANY;
    options->pack_effort = packing.effort;
    options->threads = 1;
}

autocuts_status autocuts_unwrap(const autocuts_mesh *mesh, const autocuts_options *options,
                                autocuts_map **map, autocuts_error *error)
{
    return making(mesh, options, map, error, false, [](Job &job) {
        unwrap::UnwrapResult made = unwrap::unwrapMesh(job.snapshot, job.options, job.context);
        if (!made.packed && !made.nothingFree)
            throw noRoom();
        if (job.density > 0 && !made.nothingFree)
            made.uv = atDensity(job, made.uv);
        return mapOf(job, std::move(made.uv), made.stopped);
    });
}

autocuts_status autocuts_pack(const autocuts_mesh *mesh, const autocuts_options *options, autocuts_map **map,
                              autocuts_error *error)
{
    return making(mesh, options, map, error, true, [](Job &job) {
        UvMatrix uv = *job.snapshot.uv;
        if (job.density > 0)
            return mapOf(job, atDensity(job, uv), job.stop);
        unwrap::PackJob pack = unwrap::steeredPackJob(job.snapshot, job.packing);
        pack.hurry = unwrap::PackHurry::WhenStopped;
        if (!unwrap::packCharts(*job.snapshot.mesh, findCharts(*job.snapshot.mesh, uv), pack, uv,
                                job.context))
            throw noRoom();
        return mapOf(job, std::move(uv), job.stop);
    });
}

autocuts_status autocuts_separate(const autocuts_mesh *mesh, const autocuts_options *options,
                                  autocuts_map **map, autocuts_error *error)
{
    return making(mesh, options, map, error, true, [](Job &job) {
        using Outcome = unwrap::SeparateResult::Outcome;
        unwrap::PackJob pack = unwrap::steeredPackJob(job.snapshot, job.packing);
        pack.hurry = unwrap::PackHurry::WhenStopped;
        unwrap::SeparateResult made = unwrap::separateMap(job.snapshot, pack, job.context);
        if (made.outcome == Outcome::NoRoom)
            throw noRoom();
        if (made.outcome == Outcome::Stopped)
            throw Failure{AUTOCUTS_STOPPED, "stopped before the overlaps were taken apart", {}};
        return mapOf(job, made.outcome == Outcome::Done ? made.uv : *job.snapshot.uv, job.stop);
    });
}

autocuts_status autocuts_take(const autocuts_mesh *mesh, const autocuts_options *options, autocuts_map **map,
                              autocuts_error *error)
{
    return making(mesh, options, map, error, true,
                  [](Job &job) { return mapOf(job, *job.snapshot.uv, false); });
}

void autocuts_map_free(autocuts_map *map)
{
    delete map;
}

size_t autocuts_map_corner_count(const autocuts_map *map)
{
    return map->given.size() / 2;
}

size_t autocuts_map_face_count(const autocuts_map *map)
{
    return map->islands.size();
}

size_t autocuts_map_island_count(const autocuts_map *map)
{
    return map->islandCount;
}

const double *autocuts_map_uvs(const autocuts_map *map)
{
    return map->given.data();
}

const int32_t *autocuts_map_islands(const autocuts_map *map)
{
    return map->islands.data();
}

const uint8_t *autocuts_map_seams(const autocuts_map *map)
{
    return map->seams.data();
}

int autocuts_map_stopped(const autocuts_map *map)
{
    return map->stopped;
}

autocuts_status autocuts_measure(const autocuts_map *map, autocuts_figures *figures, autocuts_error *error)
{
    return guarded(error, [&] {
        if (!map || !figures)
            throw badInput("there is no map, or no place for its figures");
        metrics::UvMetricsOptions options;
        options.textureSize = map->packing.textureSize;
        options.tileHeight = map->packing.tileHeight();
        const metrics::UvMetrics measured = metrics::measureUv(*map->mesh, map->uv, options);
        *figures = {measured.symDirichlet, measured.seamNorm, measured.packingUnit, measured.minGutterTexels,
                    measured.charts,       measured.flipped,  measured.overlapPairs};
    });
}
