#include "solver/search/seamtrial.h"

#include "model/plain/unionfind.h"
#include "solver/base/alignedborder.h"
#include "solver/base/constant.h"
#include "solver/base/cornerat.h"
#include "solver/base/rigidfit.h"
#include "solver/base/springladder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace autocuts::search {

namespace {

constexpr double impossible = -std::numeric_limits<double>::infinity();
// Numbers in this file without another source were chosen by hand.

//! Least Jacobian determinant from which a stitched patch is minimised.
AUTOCUTS_CONSTANT(double, smallestStart, 0.02);
//! Springs that close a gap: first stiffness, and levels of ten times the stiffness each.
AUTOCUTS_CONSTANT(double, firstSpring, 0.3);
AUTOCUTS_CONSTANT(int, springLevels, 5);
AUTOCUTS_CONSTANT(int, stepsPerSpring, 3);
AUTOCUTS_CONSTANT(int, guardedSteps, 10); // Newton steps with contacts barred
constexpr int pinPatch = 60;              // triangles that move when a corner is put on its pin
//! Triangles of a chart from which its Newton steps take so long that a map between them is worth having.
constexpr int slowChart = 2000;
//! Opened edges from which a change is looked at as one that may part an island. One or two are tried too
//! often.
constexpr int partingEdges = 3;
//! Number of chart relaxations that bar contacts from the start after one whose free result overlapped.
constexpr int stayGuarded = 3;

} // namespace

SeamTrial::SeamTrial(CutState &state)
    : mState(state), mPatch(state.graph), mX(state.x), mSettled(state.graph->triangleCount(), -1)
{}

bool SeamTrial::mayChange(const SeamChange &change) const
{
    const auto &rule = mState.graph->rule;
    for (const int e : change.open) {
        if (mState.cut[e] || rule[e] == SeamGraph::Rule::NeverCut)
            return false;
    }
    for (const int e : change.close) {
        if (!mState.cut[e] || rule[e] == SeamGraph::Rule::AlwaysCut)
            return false;
    }
    return true;
}

void SeamTrial::setFlags(CutState &state, const std::vector<int> &edges, bool cut)
{
    for (const int e : edges)
        state.setCut(e, cut);
}

//! Closes cut edges next to the change that touch neither another cut edge nor a border: the triangles on
//! their two sides share both UV vertices, so that they open nothing. \pre the flags of the change are set
void SeamTrial::closeLoneEdges(SeamChange &change)
{
    const SeamGraph &graph = *mState.graph;
    const std::size_t given = change.close.size();
    for (std::size_t i = 0; i < given; ++i) {
        for (const int v : graph.ends[change.close[i]]) {
            for (const int e : graph.edgesAt(v)) {
                if (!mState.cut[e] || graph.rule[e] == SeamGraph::Rule::AlwaysCut)
                    continue;
                const auto [a, b] = graph.ends[e];
                if (graph.border[a] || graph.border[b] || mState.cutsAt[a] != 1 || mState.cutsAt[b] != 1)
                    continue;
                mState.setCut(e, false);
                if (std::erase(change.open, e) == 0)
                    change.close.push_back(e);
            }
        }
    }
}

//! What a change can save at most by straighter borders, in cost: as much as it moves, and all where an
//! island may fall into two that are turned by themselves.
double SeamTrial::hopeOf(const SeamChange &change, bool parts) const
{
    if (mState.crooked == 0)
        return 0;
    if (parts || static_cast<int>(change.open.size()) >= partingEdges)
        return mState.crooked;
    double moved = 0;
    for (const std::vector<int> *edges : {&change.open, &change.close}) {
        for (const int e : *edges)
            moved += mState.graph->length[e];
    }
    return 2 * alignmentCost * moved;
}

std::vector<int> SeamTrial::seedsOf(const SeamChange &change) const
{
    const MeshData &mesh = *mState.graph->soup->mesh;
    std::vector<int> seeds;
    for (const std::vector<int> *edges : {&change.close, &change.open}) {
        for (const int e : *edges)
            seeds.insert(seeds.end(), mesh.edgePairs[e].triangle.begin(), mesh.edgePairs[e].triangle.end());
    }
    return seeds;
}

bool SeamTrial::attempt(const SeamChange &asked, const TrialTerms &terms, CutState *before,
                        KeptChange *instead)
{
    mLastGain = impossible;
    if (!mayChange(asked))
        return false;
    SeamChange change = asked;
    const int oldSmallParts = mState.smallParts;
    const double oldCost = mState.cost, oldLength = mState.length;
    mTopologyChanged = false;
    mOldAreas = mState.chartArea;
    // What straighter borders may save is known at the end only.
    const double crooked = mState.crooked;
    const double hope = std::min(crooked, hopeOf(change, terms.parts));
    setFlags(change.open, true);
    setFlags(change.close, false);
    closeLoneEdges(change);
    double costGain = 0;
    for (const int e : change.close)
        costGain += mState.graph->cost[e];
    for (const int e : change.open)
        costGain -= mState.graph->cost[e];
    mPatch.select(mState, seedsOf(change), terms.patchSize);
    double energyBefore = 0;
    for (const int t : mPatch.triangles())
        energyBefore += mState.triangleEnergy[t];

    bool accepted = false;
    if (change.close.empty() ? mPatch.join(mState, mState.x) : closeGaps(change.close)) {
        const double after = solve(change, terms, energyBefore, costGain + hope);
        mLastGain = energyBefore - after + terms.mu * costGain;
        const bool fits = !mState.graph->hasPlainEnergy() || after <= energyBefore ||
                          mState.energy + after - energyBefore <= terms.ceiling;
        accepted = fits && mLastGain + terms.mu * hope > terms.minGain;
    }
    if (accepted && before) {
        *before = mState;
        setFlags(*before, change.open, false);
        setFlags(*before, change.close, true);
    }
    accepted = accepted && (change.open.empty() || keepsCharts(change, oldSmallParts));
    if (accepted) {
        keep();
        if (mTopologyChanged)
            mState.updateCrooked();
        else
            mTopology.update(mState, change.open, change.close);
        mTopologyChanged = true;
        mLastGain += terms.mu * (crooked - mState.crooked);
        const bool fits =
            mState.graph->hasPlainEnergy() || mState.distortion <= std::max(terms.ceiling, mOldDistortion);
        if (!fits || !(mLastGain > terms.minGain) ||
            (terms.guarded && !mState.isFreeOfOverlaps({mPatch.triangles()}))) {
            undo();
            accepted = false;
        }
    }
    const bool wouldKeep = accepted;
    if (accepted && instead) {
        *instead = changeMade(change);
        undo();
        accepted = false;
    }
    if (accepted) {
        if (mTopology.hasSplit()) {
            mState.spreadCharts();
            mX = mState.x;
        }
    } else {
        setFlags(change.open, false);
        setFlags(change.close, true);
        if (mTopologyChanged) {
            mTopology.update(mState, change.close, change.open);
            mState.chartArea = mOldAreas; // without rounding errors
            mState.smallParts = oldSmallParts;
        }
        mState.cost = oldCost;
        mState.length = oldLength;
        mState.crooked = crooked;
    }
    for (const int t : mPatch.triangles())
        std::copy_n(&mState.x[6 * static_cast<std::size_t>(t)], 6, &mX[6 * static_cast<std::size_t>(t)]);
    return wouldKeep;
}

//! \pre the state is as after the change, but for the room between its charts
KeptChange SeamTrial::changeMade(const SeamChange &change) const
{
    KeptChange made;
    made.change = change;
    made.triangles = mPatch.triangles();
    made.energy = mState.energy;
    made.distortion = mState.distortion;
    made.cost = mState.cost;
    made.crooked = mState.crooked;
    made.length = mState.length;
    for (const int t : made.triangles) {
        const auto first = mState.x.begin() + 6 * static_cast<std::ptrdiff_t>(t);
        made.x.insert(made.x.end(), first, first + 6);
        made.triangleEnergy.push_back(mState.triangleEnergy[t]);
    }
    return made;
}

void SeamTrial::adopt(const KeptChange &kept)
{
    setFlags(kept.change.open, true);
    setFlags(kept.change.close, false);
    for (std::size_t i = 0; i < kept.triangles.size(); ++i) {
        const std::size_t t = static_cast<std::size_t>(kept.triangles[i]);
        std::copy_n(&kept.x[6 * i], 6, &mState.x[6 * t]);
        std::copy_n(&kept.x[6 * i], 6, &mX[6 * t]);
        mState.triangleEnergy[t] = kept.triangleEnergy[i];
    }
    mTopology.update(mState, kept.change.open, kept.change.close);
    mState.energy = kept.energy;
    mState.distortion = kept.distortion;
    mState.cost = kept.cost;
    mState.crooked = kept.crooked;
    mState.length = kept.length;
    if (mTopology.hasSplit()) {
        mState.spreadCharts();
        mX = mState.x;
    }
}

void SeamTrial::cutApart(const std::vector<int> &edges)
{
    setFlags(edges, true);
    mTopology.update(mState, edges, {});
    mState.spreadCharts();
    mX = mState.x;
}

//! Writes the patch into the state and saves what undo() needs.
void SeamTrial::keep()
{
    mOldX.clear();
    mOldEnergy.clear();
    for (const int t : mPatch.triangles()) {
        const auto first = mState.x.begin() + 6 * static_cast<std::ptrdiff_t>(t);
        mOldX.insert(mOldX.end(), first, first + 6);
        mOldEnergy.push_back(mState.triangleEnergy[t]);
    }
    mOldSum = mState.energy;
    mOldDistortion = mState.distortion;
    mPatch.commit(mState);
}

//! Restores the coordinates and energies from before keep().
void SeamTrial::undo()
{
    for (std::size_t i = 0; i < mOldEnergy.size(); ++i) {
        const int t = mPatch.triangles()[i];
        std::copy_n(&mOldX[6 * i], 6, &mState.x[6 * static_cast<std::size_t>(t)]);
        mState.triangleEnergy[t] = mOldEnergy[i];
    }
    mState.energy = mOldSum;
    mState.distortion = mOldDistortion;
}

//! Minimises the energy of the joined patch. \returns its energy at the end; infinite when boundaries would
//! cross even at the start
double SeamTrial::solve(const SeamChange &change, const TrialTerms &terms, double before, double costGain)
{
    if (terms.guarded)
        mPatch.partSides(change.open);
    PatchLimits limits;
    limits.steps = terms.steps;
    limits.hopeless = before + terms.mu * costGain - terms.minGain;
    limits.tolerance = 1e-6;
    mPatch.minimize(limits);
    const double after = mPatch.energy();
    if (!(after < limits.hopeless) || !terms.guarded || !mPatch.crossesItself())
        return after;
    // Boundaries cross in the free result: start again with contacts barred.
    if (!mPatch.join(mState, mX))
        return std::numeric_limits<double>::infinity();
    mPatch.partSides(change.open);
    if (mPatch.crossesItself())
        return std::numeric_limits<double>::infinity();
    limits.guarded = true;
    limits.steps = guardedSteps;
    mPatch.minimize(limits);
    return mPatch.energy();
}

//! Stitches edges: moves free components of the patch into place, then, where needed, pulls the two sides
//! together by springs. \pre the edges are flagged as not cut
//! \returns false when a triangle would come out flipped or nearly so; else the patch is joined at mX
bool SeamTrial::closeGaps(const std::vector<int> &close)
{
    setFlags(close, true);
    const bool apart = mPatch.join(mState, mState.x);
    if (apart)
        alignPieces(close);
    setFlags(close, false);
    if (!apart)
        return false;
    if (mPatch.join(mState, mX) && mPatch.smallestDeterminant() > smallestStart)
        return true;
    return climbSprings(firstSpring, springLevels, [&](double stiffness) {
        setFlags(close, true);
        mPatch.join(mState, mX);
        mPatch.addSprings(close);
        mPatch.setStiffness(stiffness);
        PatchLimits limits;
        limits.steps = stepsPerSpring;
        limits.tolerance = 1e-5;
        mPatch.minimize(limits);
        mPatch.store(mX);
        setFlags(close, false);
        return mPatch.join(mState, mX) && mPatch.smallestDeterminant() > smallestStart;
    });
}

//! Components connected to triangles outside the patch and those with anchors are settled; the largest one if
//! there are none.
SeamTrial::Pieces SeamTrial::findPieces() const
{
    const std::vector<int> &triangles = mPatch.triangles();
    const int count = static_cast<int>(triangles.size());
    UnionFind pieces(count);
    std::vector<char> heldAt(count, 0);
    for (int i = 0; i < count; ++i) {
        heldAt[i] = mState.isAnchored(triangles[i]);
        for (int k = 0; k < 3; ++k) {
            const int side = 3 * triangles[i] + k;
            if (mState.isCutSide(side))
                continue;
            const int other = mPatch.localOf(mState.graph->across[side] / 3);
            if (other < 0)
                heldAt[i] = 1;
            else
                pieces.unite(i, other);
        }
    }
    Pieces result;
    int pieceCount = 0;
    std::tie(result.piece, pieceCount) = pieces.labels();
    std::vector<char> &settled = result.settled;
    settled.assign(pieceCount, 0);
    std::vector<int> size(pieceCount, 0);
    for (int i = 0; i < count; ++i) {
        settled[result.piece[i]] |= heldAt[i];
        ++size[result.piece[i]];
    }
    if (std::find(settled.begin(), settled.end(), 1) == settled.end())
        settled[std::max_element(size.begin(), size.end()) - size.begin()] = 1;
    return result;
}

//! Moves every component that is not settled rigidly to the best fit of the edges to be stitched.
//! \pre the edges are flagged as cut
void SeamTrial::alignPieces(const std::vector<int> &close)
{
    const MeshData &mesh = *mState.graph->soup->mesh;
    const std::vector<int> &triangles = mPatch.triangles();
    auto [piece, settled] = findPieces();
    const int pieceCount = static_cast<int>(settled.size());
    for (bool again = true; again;) {
        again = false;
        for (int p = 0; p < pieceCount; ++p) {
            if (settled[p])
                continue;
            std::vector<PointMatch> matches;
            for (const int e : close) {
                const EdgePair &pair = mesh.edgePairs[e];
                for (int which = 0; which < 2; ++which) {
                    const int moving = mPatch.localOf(pair.triangle[which]);
                    const int fixed = mPatch.localOf(pair.triangle[1 - which]);
                    if (piece[moving] != p || !settled[piece[fixed]])
                        continue;
                    for (int end = 0; end < 2; ++end)
                        matches.push_back({cornerAt(mX, pair.corner[end][1 - which]),
                                           cornerAt(mX, pair.corner[end][which])});
                }
            }
            if (matches.empty())
                continue;
            const RigidMotion motion = fitRigid(matches);
            settled[p] = 1;
            again = true;
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                if (piece[i] != p)
                    continue;
                for (int c = 3 * triangles[i]; c < 3 * triangles[i] + 3; ++c)
                    cornerAt(mX, c) = motion(cornerAt(mX, c));
            }
        }
    }
}

//! False when opening edges has made further charts smaller than CutState::smallestChart().
bool SeamTrial::keepsCharts(const SeamChange &change, int oldSmallParts)
{
    mTopologyChanged = true;
    mTopology.update(mState, change.open, change.close);
    return mState.smallParts <= oldSmallParts;
}

double SeamTrial::relaxAll(int steps, bool guarded, const JobContext &job, const MapSink &between)
{
    return relaxCharts(std::vector<char>(mState.chartCount(), 1), steps, guarded, job, between);
}

double SeamTrial::relaxAnchored(int steps, bool guarded, const JobContext &job)
{
    std::vector<char> anchored(mState.chartCount(), 0);
    for (int t = 0; t < mState.graph->triangleCount(); ++t) {
        if (mState.isAnchored(t))
            anchored[mState.chart[t]] = 1;
    }
    return relaxCharts(anchored, steps, guarded, job);
}

double SeamTrial::relaxCharts(const std::vector<char> &which, int steps, bool guarded, const JobContext &job,
                              const MapSink &between)
{
    const double before = mState.energy;
    const std::vector<double> old = mState.x;
    std::vector<std::vector<int>> members(mState.chartCount());
    for (int t = 0; t < mState.graph->triangleCount(); ++t) {
        if (which[mState.chart[t]])
            members[mState.chart[t]].push_back(t);
    }
    std::erase_if(members, [](const std::vector<int> &triangles) { return triangles.empty(); });
    for (const std::vector<int> &triangles : members) {
        if (job.stopped())
            break;
        relaxChart(triangles, steps, guarded, job, between);
    }
    if (guarded && !mState.loopsAreInOrder())
        mState.x = old;
    mState.updateEnergy();
    mX = mState.x;
    return before - mState.energy;
}

bool SeamTrial::reachPin(int pin, bool guarded)
{
    const Anchor &anchor = mState.graph->anchors.all()[pin];
    const int seed = anchor.soupCorner / 3;
    mPatch.select(mState, {&seed, 1}, pinPatch);
    cornerAt(mX, anchor.soupCorner) = anchor.lower;
    mState.pinReached[pin] = 1;
    bool reached = mPatch.join(mState, mX) && mPatch.smallestDeterminant() > smallestStart;
    if (reached) {
        PatchLimits limits;
        limits.guarded = guarded;
        reached = !guarded || !mPatch.crossesItself();
        mPatch.minimize(limits);
    }
    if (reached) {
        keep();
        if (guarded && mState.boundariesOverlap({mPatch.triangles()})) {
            undo();
            reached = false;
        }
    }
    mState.pinReached[pin] = reached;
    mX = mState.x;
    return reached;
}

//! Relaxes one chart. Charts are relaxed one by one so that each has its own step length.
void SeamTrial::relaxChart(const std::vector<int> &triangles, int steps, bool guarded, const JobContext &job,
                           const MapSink &between)
{
    double energy = 0;
    for (const int t : triangles)
        energy += mState.triangleEnergy[t];
    // The same energy to the last bit: nothing has moved it since.
    double &settled = mSettled[triangles.front()];
    if (!mState.anchored && energy == settled)
        return;
    mPatch.select(mState, triangles, 0);
    mPatch.join(mState, mState.x);
    PatchLimits limits;
    limits.steps = steps;
    limits.job = job.quiet();
    // A chart relaxation that overlapped will probably do so again; contacts are barred for a while.
    limits.guarded = guarded && mGuardedFor > 0;
    if (between && static_cast<int>(triangles.size()) >= slowChart) {
        limits.stepped = [&] {
            CutState now = mState;
            mPatch.commit(now);
            if (!guarded || now.isFreeOfOverlaps({triangles, true}, job.quiet()))
                between(now);
        };
    }
    const int taken = mPatch.minimize(limits);
    if (limits.guarded) {
        --mGuardedFor;
    } else if (taken == 0 && steps > 0 && !job.stopped()) {
        settled = energy;
        return;
    } else if (guarded && mPatch.crossesItself()) {
        mGuardedFor = stayGuarded;
        mPatch.join(mState, mState.x);
        limits.guarded = true;
        mPatch.minimize(limits);
    }
    if (job.stopped())
        return;
    keep();
    if (guarded && mState.boundariesOverlap({triangles, true}, job.quiet()))
        undo();
}

} // namespace autocuts::search
