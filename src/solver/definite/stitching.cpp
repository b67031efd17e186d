#include "solver/definite/stitching.h"

#include "solver/base/constant.h"
#include "solver/base/cornerat.h"
#include "solver/base/rigidfit.h"
#include "solver/base/springladder.h"
#include "solver/energy/constraintterms.h"
#include "solver/energy/distortion.h"
#include "solver/energy/separation.h"
#include "solver/newton/minimizer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace autocuts::definite {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Pairs with a smaller separation are stitched (paper, section 4: 0.5).
constexpr double stitchSeparation = 0.5;
//! Least UV area of a triangle after merging, as a share of its area at rest.
constexpr double smallestStitchedDeterminant = 1e-6;
//! With a delta far greater than any squared distance the separation is a plain spring.
constexpr double springDelta = 1e6;
AUTOCUTS_CONSTANT(double, firstSpring, 0.3);
constexpr int springLevels = 5; // stiffness 0.3, 3, ... 3000
AUTOCUTS_CONSTANT(int, stepsPerSpring, 4);
//! Least relative change of the energy.
constexpr double stall = 1e-7;
constexpr double isometry = 4;

//! The coordinates with the corners of each UV vertex at their mean.
std::vector<double> snapped(const CutMesh &state, const std::vector<double> &x)
{
    std::vector<Vec2> sum(state.uvVertexCount, Vec2::Zero());
    std::vector<int> count(state.uvVertexCount, 0);
    const int corners = static_cast<int>(state.uvVertex.size());
    for (int c = 0; c < corners; ++c) {
        sum[state.uvVertex[c]] += cornerAt(x, c);
        ++count[state.uvVertex[c]];
    }
    std::vector<double> result(x.size());
    for (int c = 0; c < corners; ++c) {
        const int v = state.uvVertex[c];
        cornerAt(result, c) = sum[v] / count[v];
    }
    return result;
}

std::vector<int> badTriangles(const Soup &soup, const std::vector<double> &x)
{
    std::vector<int> bad;
    for (int t = 0; t < soup.triangleCount(); ++t) {
        if (!(jacobianDeterminant(soup, x.data(), t) > smallestStitchedDeterminant))
            bad.push_back(t);
    }
    return bad;
}

bool isCut(const Snapshot &snapshot, std::size_t pair)
{
    return !snapshot.steering->pairState.empty() && snapshot.steering->pairState[pair] == PairState::Cut;
}

//! The terms that every stage has: distortion and pins (hard ones as stiff springs).
struct ShapeTerms
{
    std::unique_ptr<energy::DistortionTerm> distortion;
    energy::PinTerm pins;

    ShapeTerms(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot)
        : distortion(energy::makeDistortionTerm(soup, snapshot.settings.energy)),
          pins(stiffened(snapshot.steering->pins))
    {}

    std::vector<const energy::EnergyTerm *> all() const { return {distortion.get(), &pins}; }

private:
    static std::vector<Pin> stiffened(std::vector<Pin> pins)
    {
        for (Pin &pin : pins) {
            if (pin.hard)
                // Far stiffer than the distortion.
                pin.weight = 1e4;
        }
        return pins;
    }
};

//! Pulls the merged corners together with stiffer and stiffer springs until merging them flips nothing.
//! \return false when it still does at the end
bool pullTogether(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, const CutMesh &state,
                  std::vector<double> &x, std::vector<double> &snap, const JobContext &job)
{
    ShapeTerms shape(soup, snapshot);
    energy::SeparationTerm springs(soup);
    springs.setDelta(springDelta);
    std::vector<double> weights(soup->pairCorners.size(), 0.0);
    for (std::size_t p = 0; p < weights.size(); ++p) {
        if (state.uvVertex[soup->pairCorners[p][0]] == state.uvVertex[soup->pairCorners[p][1]])
            weights[p] = springDelta;
    }
    springs.setWeights(std::move(weights));
    newton::Minimizer minimizer(soup, newton::makeHubDirection(soup, {}));
    std::vector<const energy::EnergyTerm *> terms = shape.all();
    terms.push_back(&springs);
    return climbSprings(firstSpring, springLevels, [&](double stiffness) {
        springs.setFactor(stiffness);
        minimizer.setTerms(terms);
        for (int i = 0; i < stepsPerSpring && !job.stopped(); ++i)
            minimizer.step(x);
        snap = snapped(state, x);
        return badTriangles(*soup, snap).empty();
    });
}

//! Cuts the edges of the faces of the bad triangles and of `rings` rings of faces around them; edges that the
//! user joined only with `force`.
//! \return true when an edge was cut
bool release(const MeshData &mesh, const Snapshot &snapshot, const std::vector<int> &bad, int rings,
             bool force, CutFlags &cut)
{
    std::vector<bool> face(mesh.faceCount(), false);
    for (const int t : bad)
        face[mesh.triangleFace[t]] = true;
    for (int i = 0; i < rings; ++i) {
        const std::vector<bool> before = face;
        for (const EdgePair &pair : mesh.edgePairs) {
            const int a = mesh.triangleFace[pair.triangle[0]], b = mesh.triangleFace[pair.triangle[1]];
            if (before[a] || before[b])
                face[a] = face[b] = true;
        }
    }
    bool changed = false;
    for (std::size_t e = 0; e < cut.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (cut[e] || pair.diagonal || (!force && snapshot.isJoined(e)))
            continue;
        if (face[mesh.triangleFace[pair.triangle[0]]] || face[mesh.triangleFace[pair.triangle[1]]]) {
            cut[e] = true;
            changed = true;
        }
    }
    return changed;
}

//! Lays the polygons of the bad triangles out undistorted: each triangle at rest, turned to the one across a
//! diagonal. Frees them from pins, which may pull a polygon inside out.
//! \pre all edges of these polygons but their diagonals are cut
void layOut(const Soup &soup, const std::vector<int> &bad, Snapshot &snapshot, std::vector<double> &x)
{
    const MeshData &mesh = *soup.mesh;
    std::vector<bool> face(mesh.faceCount(), false), placed(mesh.triangleCount(), true);
    for (const int t : bad)
        face[mesh.triangleFace[t]] = true;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int own = mesh.triangleFace[t];
        for (int i = 0; i < 6 && face[own]; ++i)
            x[6 * static_cast<std::size_t>(t) + i] = soup.restShape[t][i];
        placed[t] = !face[own] || t == mesh.faceTriangle[own];
    }
    for (bool again = true; again;) {
        again = false;
        for (const EdgePair &pair : mesh.edgePairs) {
            const int fixed = placed[pair.triangle[0]] ? 0 : 1;
            const int moving = pair.triangle[1 - fixed];
            if (!pair.diagonal || placed[moving] || !placed[pair.triangle[fixed]])
                continue;
            std::vector<PointMatch> ends;
            for (const auto &corner : pair.corner)
                ends.push_back({cornerAt(x, corner[fixed]), cornerAt(x, corner[1 - fixed])});
            const RigidMotion motion = fitRigid(ends);
            for (int c = 3 * moving; c < 3 * moving + 3; ++c)
                cornerAt(x, c) = motion(cornerAt(x, c));
            placed[moving] = again = true;
        }
    }
    if (!snapshot.steering->pins.empty())
        std::erase_if(snapshot.editSteering().pins,
                      [&](const Pin &pin) { return face[mesh.triangleFace[pin.soupCorner / 3]]; });
}

//! True when a step gains less than these shares of the energy, or of what it is above that of an isometry.
bool hasSettled(const newton::Minimizer::Step &step, double stall, double leastGain)
{
    const double gain = step.before - step.after;
    return gain <= stall * std::abs(step.before) || gain <= leastGain * (step.before - isometry);
}

} // namespace

SeamedMap stitchTo(const std::shared_ptr<const Soup> &soup, const Snapshot &given, CutFlags cut,
                   const std::vector<double> &start, const JobContext &job)
{
    const MeshData &mesh = *soup->mesh;
    Snapshot snapshot = given;
    std::vector<double> x = start;
    for (int round = 0;; ++round) {
        const CutMesh state(mesh, cut);
        std::vector<double> snap = snapped(state, x);
        std::vector<int> bad = badTriangles(*soup, snap);
        if (bad.empty() || pullTogether(soup, snapshot, state, x, snap, job)) {
            SeamedMap map{std::move(cut), std::move(snap)};
            return map;
        }
        bad = badTriangles(*soup, snap);
        // Each round cuts more edges, and more rings after every four rounds. In the last resort a polygon is
        // a chart of its own and is laid out undistorted.
        const int rings = round / 4;
        if (!release(mesh, snapshot, bad, rings, false, cut) &&
            !release(mesh, snapshot, bad, rings, true, cut)) {
            layOut(*soup, bad, snapshot, x);
            // A guard against endless rounds.
            if (round > 50)
                throw std::runtime_error("a polygon cannot be laid flat");
        }
    }
}

SeamedMap stitchSoup(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot,
                     const std::vector<double> &x, const JobContext &job)
{
    const MeshData &mesh = *soup->mesh;
    energy::SeparationTerm separation(soup);
    separation.setDelta(snapshot.settings.delta);
    const auto merges = [&](std::size_t pair) {
        return !isCut(snapshot, pair) &&
               (snapshot.isJoined(pair / 2) ||
                separation.separation(x, static_cast<int>(pair)) < stitchSeparation);
    };
    CutFlags cut(mesh.edgePairs.size());
    for (std::size_t e = 0; e < cut.size(); ++e)
        cut[e] = !mesh.edgePairs[e].diagonal && !(merges(2 * e) && merges(2 * e + 1));
    dropClosedCuts(mesh, cut);
    return stitchTo(soup, snapshot, std::move(cut), x, job);
}

int relaxMap(const std::shared_ptr<const Soup> &soup, const Snapshot &snapshot, SeamedMap &map, int steps,
             const JobContext &job, const std::function<void(int)> &stepped, double leastGain)
{
    if (job.stopped())
        return 0;
    const CutMesh state(*soup->mesh, map.cut);
    const ShapeTerms shape(soup, snapshot);
    newton::Minimizer minimizer(soup,
                                newton::makeExactDirection(soup, {state.uvVertex, state.uvVertexCount}));
    minimizer.setTerms(shape.all());
    int done = 0;
    while (done < steps && !job.stopped()) {
        const newton::Minimizer::Step step = minimizer.step(map.x);
        job.addWork(soup->triangleCount());
        ++done;
        if (stepped)
            stepped(done);
        if (hasSettled(step, stall, leastGain))
            break;
    }
    return done;
}

} // namespace autocuts::definite
