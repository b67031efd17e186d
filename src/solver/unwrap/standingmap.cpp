#include "solver/unwrap/standingmap.h"

#include "model/plain/uvseams.h"
#include "solver/definite/definitemap.h"
#include "solver/definite/relaxing.h"
#include "solver/metrics/uvmetrics.h"
#include "solver/preference/meshsymmetry.h"
#include "solver/straight/straightening.h"
#include "solver/unwrap/packjob.h"

#include <algorithm>
#include <cmath>

namespace autocuts::unwrap {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Rigid regions of two maps are equally flat where their stretch, with its stiffness of 100, differs by less
//! than this share, or by less than this much: a mean distortion of .001, which nobody sees.
constexpr double sameFlatness = 0.01, unseenBend = 0.1;
//! The gain in mean distortion that counts: what an edit changes near it is little of the whole.
constexpr double leastGain = 1e-5;
//! Share of what the seams cost that other seams have to save, or a whole layout changes for seams that
//! nobody sees to be shorter.
constexpr double leastSaving = 0.003;
//! The pull of soft pins that counts as less: by a share of the whole, and by a pin of weight 1 that comes
//! nearer than this to its place, solver units.
constexpr double lessPull = 0.01, seenDistance = 1e-3;
constexpr double moreAligned = 0.01; // share of the borders that counts

bool hasClosedCuts(const Snapshot &part)
{
    const std::vector<PairState> &states = part.steering->pairState;
    if (states.empty())
        return false;
    const std::vector<bool> open = openCornerPairs(*part.mesh, *part.uv);
    for (std::size_t p = 0; p < states.size(); p += 2) {
        const bool isCut = states[p] == PairState::Cut || states[p + 1] == PairState::Cut;
        if (isCut && !open[p] && !open[p + 1])
            return true;
    }
    return false;
}

//! What the worth of a map does not measure.
bool asksForMore(const Snapshot &snapshot, const FreePart &part)
{
    const auto plan = straight::StraightPlan::of(part.snapshot());
    return snapshot.settings.energy != DistortionEnergy::SymmetricDirichlet || plan.mirror ||
           plan.up != WorldUp::Off;
}

//! True when every cut edge that has a mirror image is cut there as well.
bool isSymmetric(const MeshData &mesh, const CutFlags &cut)
{
    const std::optional<preference::MeshSymmetry> symmetry = preference::findSymmetry(mesh);
    for (std::size_t e = 0; symmetry && e < cut.size(); ++e) {
        const int mirror = symmetry->mirrorEdge[e];
        if (cut[e] && mirror >= 0 && !cut[mirror])
            return false;
    }
    return true;
}

//! True when islands are in their rectangles and tiles, overlap nothing, and have no reason to grow.
bool liesInPlace(const Snapshot &snapshot, const packing::PackOptions &packing, const JobContext &job)
{
    const MeshData &mesh = *snapshot.mesh;
    const PackJob pack = steeredPackJob(snapshot, packing);
    if (onlyRectangles(pack)) // they are as large as these allow
        return false;
    const std::vector<bool> misplaced =
        misplacedFaces(mesh, findCharts(mesh, *snapshot.uv), pack, *snapshot.uv, job.quiet());
    return std::ranges::find(misplaced, true) == misplaced.end();
}

} // namespace

std::optional<Candidate> worthOf(const FreePart &part, const std::shared_ptr<const Soup> &soup,
                                 const Snapshot &problem, const UvMatrix &uv)
{
    const CutFlags none(soup->mesh->edgePairs.size(), false);
    std::optional<SeamedMap> map = seamedMapOf(*soup, part.partUv(uv) / problem.uvScale, none);
    if (!map || definite::coversItself(*soup, *map))
        return std::nullopt;
    definite::equalizeDensity(*soup, problem, *map);
    Candidate candidate;
    candidate.map = std::move(*map);
    candidate.measure(*soup, problem);
    return candidate;
}

std::optional<StandingMap> standingMap(const Snapshot &snapshot, const FreePart &part,
                                       const std::shared_ptr<const Soup> &soup, const Snapshot &problem,
                                       const packing::PackOptions &packing, const JobContext &job)
{
    if (!snapshot.uv || asksForMore(snapshot, part) || hasClosedCuts(part.snapshot()))
        return std::nullopt;
    std::optional<Candidate> worth = worthOf(part, soup, problem, *snapshot.uv);
    if (!worth ||
        (snapshot.settings.symmetry == SymmetryMode::On && !isSymmetric(*soup->mesh, worth->map.cut)))
        return std::nullopt;
    const bool inPlace = liesInPlace(snapshot, packing, job);
    // Wishes are measured where a map lies.
    const bool hasWishes = !std::ranges::all_of(snapshot.steering->pins, &Pin::hard) ||
                           !straight::StraightPlan::of(part.snapshot()).isEmpty();
    if (job.stopped() || (hasWishes && !inPlace))
        return std::nullopt;
    return StandingMap{std::move(*worth), inPlace, Wishes::of(snapshot, *snapshot.uv)};
}

Wishes Wishes::of(const Snapshot &snapshot, const UvMatrix &uv)
{
    const MeshData &mesh = *snapshot.mesh;
    Wishes wishes;
    for (const Pin &pin : snapshot.steering->pins) {
        const Vec2 place = Vec2(uv.row(mesh.cornerOfSoup(pin.soupCorner))) / snapshot.uvScale;
        if (!pin.hard)
            wishes.pull += pin.weight * (place - pin.target).squaredNorm();
    }
    if (straight::StraightPlan::of(snapshot).aligns())
        wishes.aligned = metrics::measureShapes(mesh, uv, snapshot.tileHeight).axisAlignedShare;
    return wishes;
}

bool Wishes::isBetterThan(const Wishes &other) const
{
    return other.pull - pull > std::max(lessPull * other.pull, seenDistance * seenDistance) ||
           aligned > other.aligned + moreAligned;
}

bool beats(Candidate map, Candidate standing, double maxDistortion)
{
    // Rigid regions that are as flat in both do not decide.
    if (std::abs(map.bounded - standing.bounded) <=
        std::max(sameFlatness * (standing.bounded - 4), unseenBend)) {
        map.bounded = map.distortion;
        standing.bounded = standing.distortion;
    }
    UnwrapOptions options;
    options.maxDistortion = maxDistortion;
    const JobContext job;
    const Ranking ranking(options, job);
    const bool stretchesLess = !ranking.better(standing, map) && map.bounded < standing.bounded - leastGain;
    map.seamCost += leastSaving * standing.seamCost;
    return stretchesLess || ranking.better(map, standing);
}

bool beats(const SeamedMap &map, const Soup &soup, const Snapshot &problem, const Candidate &standing,
           double maxDistortion)
{
    Candidate candidate;
    candidate.map = map;
    candidate.measure(soup, problem);
    return beats(std::move(candidate), standing, maxDistortion);
}

} // namespace autocuts::unwrap
