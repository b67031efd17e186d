#include "solver/unwrap/unwrap.h"

#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/packing/islandgeometry.h"
#include "solver/preference/seampreference.h"
#include "solver/search/seamoptimizer.h"
#include "solver/unwrap/candidates.h"
#include "solver/unwrap/coarsetofine.h"
#include "solver/unwrap/soupchains.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace autocuts::unwrap {

namespace {

//! Smaller meshes get another effort. Chosen by hand, not measured.
constexpr double fullEffortTriangles = 2000;

//! True when the seam search can do the job. It supports cuts, joins, weights and the symmetric Dirichlet
//! energy. Pins, rectangles, other energies and a given lambda need the soup.
bool canSearch(const Snapshot &snapshot, const UnwrapOptions &options)
{
    return !options.lambda && !snapshot.placesIslands() &&
           snapshot.settings.energy == DistortionEnergy::SymmetricDirichlet;
}

//! Effort on a mesh of fullEffortTriangles or more. The rounds were chosen by hand; no comparison with
//! other plans is on record. Measured for the whole unwrap in draft, standard and best: seams are 1.10, .794
//! and .771 times as long as those of OptCuts on 14 meshes used in development (in 1/61, 1/5.4 and 1/1.9 of
//! its CPU time), and 1.13, .854 and .834 times as long on 18 other meshes.
search::OptimizeEffort fullEffort(UnwrapQuality quality)
{
    switch (quality) {
    case UnwrapQuality::Draft:
        return {1, {{0, 1}, {25, 1}}, 0, 0.5, 16};
    case UnwrapQuality::Standard:
        return {10, {{80, 5}, {200, 2}, {1300, 1}}, 10};
    case UnwrapQuality::Best:
        return {24, {{100, 12}, {300, 6}, {800, 3}, {2000, 1}}, 10};
    }
    throw std::invalid_argument("unwrap: unknown quality");
}

//! Effort on a mesh of this size. On small meshes fewer moves suffice and more starts help more. A draft has
//! one start; below 2,000 triangles that left the result to chance, so that it gets several there. The least
//! share of 0.4 was chosen by hand.
search::OptimizeEffort effortFor(UnwrapQuality quality, int triangles)
{
    search::OptimizeEffort effort = fullEffort(quality);
    const double share = std::clamp(std::sqrt(triangles / fullEffortTriangles), 0.4, 1.0);
    if (quality == UnwrapQuality::Draft)
        effort.seeds = static_cast<int>(std::lround(1 / (share * share)));
    if (quality != UnwrapQuality::Standard)
        return effort;
    const auto more = [share](int count) { return static_cast<int>(std::lround(count / share)); };
    effort.seeds = more(effort.seeds);
    for (search::OptimizeEffort::Round &round : effort.rounds) {
        round.moves = static_cast<int>(share * round.moves);
        round.survivors = more(round.survivors);
    }
    return effort;
}

//! True when the surface has several connected components or borders, or handles. Its first cuts are not few,
//! so that the search also starts from a map of the soup.
bool isComplicated(const MeshData &mesh)
{
    const CutMesh whole(mesh, CutFlags(mesh.edgePairs.size(), false));
    const int loops = static_cast<int>(whole.boundaryLoops().size());
    const int edges = static_cast<int>(mesh.edgePairs.size() + mesh.boundarySides.size());
    const int euler = whole.uvVertexCount - edges + mesh.triangleCount();
    return whole.chartCount > 1 || loops > 1 || euler + loops < 2;
}

//! Finds the best map of one unwrap, by the seam search and by the soup.
class MapFinder
{
public:
    //! \param snapshot with the preferences in its weights
    MapFinder(std::shared_ptr<const Soup> soup, const Snapshot &snapshot, const UnwrapOptions &options,
              const JobContext &job)
        : mSoup(std::move(soup)), mSnapshot(snapshot), mOptions(options), mJob(job), mRanking(options, job)
    {}

    Ranking &ranking() { return mRanking; }
    int iterations() const { return mIterations; }

    //! \param symmetry null: cuts need not be symmetric
    std::optional<Candidate> find(const preference::MeshSymmetry *symmetry)
    {
        if (!canSearch(mSnapshot, mOptions))
            return bySoup(mOptions.quality);
        std::optional<Candidate> best;
        if (symmetry)
            best = bySearch({}, symmetry);
        if (best && (best->distortion <= mOptions.maxDistortion || mJob.stopped()))
            return best;
        // Only the soup can start from existing UVs.
        if (mSnapshot.settings.start == StartMode::ExistingUv || isComplicated(*mSnapshot.mesh))
            best = bySoup(UnwrapQuality::Draft);
        keepBetter(best, bySearch(best, nullptr));
        if (!best || (!mJob.stopped() && best->distortion > mOptions.maxDistortion))
            keepBetter(best, bySoup(mOptions.quality));
        return best;
    }

private:
    //! The best map of the seam search. \param other a further map to start from
    std::optional<Candidate> bySearch(const std::optional<Candidate> &other,
                                      const preference::MeshSymmetry *symmetry)
    {
        search::OptimizeOptions search;
        search.maxDistortion = mOptions.maxDistortion;
        search.allowOverlaps = mOptions.allowOverlaps;
        search.effort = effortFor(mOptions.quality, mSnapshot.mesh->triangleCount());
        if (other)
            search.given.push_back(other->map);
        search.seed = mSnapshot.settings.seed;
        search.job = mJob;
        search.start = [&](int steps) { mRanking.setTotal(steps); };
        search.progress = [&](int steps, double distortion, double seamLength) {
            mRanking.found(distortion, seamLength);
            mRanking.stepDone(steps);
        };
        std::optional<search::OptimizedMap> found =
            search::optimizeSeams(search::SeamGraph::build(mSoup, mSnapshot, symmetry), search);
        if (!found)
            return std::nullopt;
        Candidate candidate;
        candidate.map = std::move(found->map);
        definite::equalizeDensity(*mSoup, candidate.map);
        if (!mOptions.allowOverlaps && definite::coversItself(*mSoup, candidate.map))
            return std::nullopt;
        candidate.measure(*mSoup, mSnapshot);
        candidate.lambda = found->mu / (1 + found->mu);
        mIterations += found->iterations;
        return candidate;
    }

    std::optional<Candidate> bySoup(UnwrapQuality quality)
    {
        UnwrapOptions how = mOptions;
        how.quality = quality;
        return bestOfSoupChains(mSnapshot, how, mRanking, mJob, mIterations);
    }

    void keepBetter(std::optional<Candidate> &best, std::optional<Candidate> found) const
    {
        if (!best || (found && mRanking.better(*found, *best)))
            best = std::move(found);
    }

    const std::shared_ptr<const Soup> mSoup;
    const Snapshot &mSnapshot;
    const UnwrapOptions &mOptions;
    const JobContext &mJob;
    Ranking mRanking;
    int mIterations = 0;
};

//! Moves and scales the map into the unit square.
void fitUnitSquare(UvMatrix &uv)
{
    const Eigen::RowVector2d low = uv.colwise().minCoeff();
    const Eigen::RowVector2d high = uv.colwise().maxCoeff();
    const double side = (high - low).maxCoeff();
    uv.rowwise() -= low;
    if (side > 0)
        uv /= side;
}

//! Packs the islands of a map. Sets result.uv and result.packed.
void place(const Soup &soup, const SeamedMap &map, const UnwrapOptions &options, const JobContext &job,
           Ranking &ranking, UnwrapResult &result)
{
    result.uv = cornerUv(soup, map);
    if (!options.pack) {
        fitUnitSquare(result.uv);
        return;
    }
    const MeshData &mesh = *soup.mesh;
    const ChartMap charts = chartsOf(mesh, CutMesh(mesh, map.cut));
    const std::vector<packing::PackIsland> islands = packing::makePackIslands(mesh, result.uv, charts);
    packing::PackOptions settings = options.packing;
    if (options.quality == UnwrapQuality::Draft)
        settings.effort = std::min(settings.effort, packing::hurriedEffort);
    const auto pack = [&](const JobContext &packJob) {
        const JobContext::Sink report = [&](const JobProgress &done) {
            ranking.packing(Ranking::optimizingShare + (1 - Ranking::optimizingShare) * done.fraction);
        };
        return packing::packIslands(islands, settings, packJob.watchedBy(report));
    };
    packing::PackResult packed;
    if (!job.stopped())
        packed = pack(job);
    if (!packed.complete) {
        // Stopped before the first layout, or no room found: one quick attempt that cannot be stopped.
        settings.effort = std::min(settings.effort, packing::hurriedEffort);
        packed = pack(job.unstoppable());
    }
    result.packed = packed.complete;
    if (packed.complete)
        packing::applyPlacements(packed, mesh, charts, result.uv);
    else
        fitUnitSquare(result.uv);
}

void checkOptions(const UnwrapOptions &options)
{
    if (!(options.maxDistortion > 4))
        throw std::invalid_argument("unwrap: the distortion bound must be above 4, the value of an isometry");
    if (options.lambda && !(*options.lambda >= 0 && *options.lambda <= 1))
        throw std::invalid_argument("unwrap: lambda must be between 0 and 1");
}

//! Unwraps a large mesh by way of a coarser one; nothing when the mesh is not suited or that fails.
std::optional<UnwrapResult> unwrapLarge(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                                        const UnwrapOptions &options, const JobContext &job)
{
    if (!suitsCoarseToFine(snapshot))
        return std::nullopt;
    const std::optional<CarriedMap> carried = mapByCoarse(
        soup, snapshot, options,
        [&](const Snapshot &coarse, const UnwrapOptions &coarseOptions) {
            return unwrapMesh(coarse, coarseOptions, job);
        },
        job);
    if (!carried)
        return std::nullopt;
    UnwrapResult result;
    result.iterations = carried->iterations;
    if (snapshot.settings.symmetry)
        result.symmetry = 0;
    result.cut = carried->map.cut;
    result.distortion = carried->map.distortion(*soup);
    result.seamLength = carried->map.seamLength(*soup);
    result.lambda = carried->lambda;
    result.delta = carried->delta;
    result.withinBound = options.lambda || result.distortion <= options.maxDistortion;
    Ranking ranking(options, job);
    place(*soup, carried->map, options, job, ranking, result);
    result.stopped = job.stopped();
    return result;
}

} // namespace

UnwrapResult unwrapMesh(const Snapshot &given, const UnwrapOptions &options, const JobContext &job)
{
    checkOptions(options);
    const std::shared_ptr<const Soup> soup = Soup::build(given.mesh);
    Snapshot snapshot = given;
    // Decided on the mesh itself: a coarser version has sharper edges, which would look like creases.
    snapshot.settings.creases = preference::decided(snapshot.settings.creases, *snapshot.mesh);
    std::optional<preference::MeshSymmetry> symmetry;
    if (snapshot.settings.symmetry && canSearch(snapshot, options))
        symmetry = preference::findSymmetry(*snapshot.mesh);
    // Not for symmetric cuts: the coarse mesh would not be symmetric.
    if (!symmetry) {
        if (std::optional<UnwrapResult> large = unwrapLarge(soup, snapshot, options, job))
            return std::move(*large);
    }
    snapshot = preference::SeamPreference().applied(snapshot, job.threads());
    MapFinder finder(soup, snapshot, options, job);
    const std::optional<Candidate> best = finder.find(symmetry ? &*symmetry : nullptr);
    UnwrapResult result;
    result.iterations = finder.iterations();
    result.cut = best->map.cut;
    if (snapshot.settings.symmetry)
        result.symmetry = symmetry ? preference::symmetricShare(*snapshot.mesh, *symmetry, result.cut) : 0;
    result.distortion = best->distortion;
    result.seamLength = best->seamLength;
    result.lambda = best->lambda;
    result.delta = best->delta;
    result.withinBound = options.lambda || best->distortion <= options.maxDistortion;
    place(*soup, best->map, options, job, finder.ranking(), result);
    result.stopped = job.stopped();
    return result;
}

} // namespace autocuts::unwrap
