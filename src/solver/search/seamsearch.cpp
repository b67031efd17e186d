#include "solver/search/seamsearch.h"

#include "solver/base/cutmesh.h"
#include "solver/search/anchoring.h"
#include "solver/search/seamnecks.h"

#include <algorithm>
#include <cmath>

namespace autocuts::search {

namespace {

// Numbers in this file without another source were chosen by hand.

AUTOCUTS_CONSTANT(int, zipLookAhead, 3);        // edges that are stitched in one trial, at most
AUTOCUTS_CONSTANT(int, disturbedTriangles, 60); // nearest to a change, whose vertices count as changed
//! A large move may first cost this share of mu * (cost of the edges that it opens and closes); it has to
//! gain after the polish.
AUTOCUTS_CONSTANT(double, promising, 0.6);
AUTOCUTS_CONSTANT(int, trianglesPerMovedEdge, 12); // in the patch of a large move

} // namespace

SeamSearch::SeamSearch(CutState &state, std::uint64_t seed, const SearchOptions &options)
    : mState(state), mOptions(options), mMu(options.mu), mRandom(seed), mTrial(state), mPaths(state),
      mChanged(state.graph->vertexCount, 1), mZipTried(state.cut.size(), 0), mSplitTried(state.cut.size(), 0)
{}

void SeamSearch::setMu(double mu)
{
    if (std::abs(std::log(mu / mMu)) > 0.1) {
        std::fill(mZipTried.begin(), mZipTried.end(), 0);
        std::fill(mSplitTried.begin(), mSplitTried.end(), 0);
    }
    mMu = mu;
}

bool SeamSearch::attempt(Move move, const SeamChange &asked, int size, int steps, double minGain,
                         CutState *before)
{
    ++counts[move].tried;
    const SeamChange change = withMirrorImages(asked);
    TrialTerms terms;
    terms.mu = mMu;
    terms.patchSize = mState.graph->isMirrored() ? 2 * size : size;
    terms.steps = steps;
    terms.minGain = minGain;
    terms.guarded = mOptions.guarded;
    terms.ceiling = mCeiling;
    terms.parts = move == Part;
    if (!mTrial.attempt(change, terms, before))
        return false;
    ++counts[move].kept;
    ++mClock;
    const std::vector<int> &triangles = mTrial.patch().triangles();
    const std::size_t disturbed =
        std::min(triangles.size(), disturbedTriangles + 4 * (change.open.size() + change.close.size()));
    for (std::size_t i = 0; i < disturbed; ++i) {
        for (int k = 0; k < 3; ++k)
            mChanged[mState.graph->vertex[3 * triangles[i] + k]] = mClock;
    }
    return true;
}

void SeamSearch::restore(const CutState &state)
{
    mState = state;
    mTrial.reset();
    touchAll();
}

//! Counts everything as changed.
void SeamSearch::touchAll()
{
    ++mClock;
    std::fill(mChanged.begin(), mChanged.end(), mClock);
}

void SeamSearch::anchor()
{
    if (mState.graph->anchors.empty())
        return;
    if (!mState.anchored) {
        placeAtAnchors(mState);
        restore(mState);
    }
    reachPins(mTrial, mOptions.guarded);
}

void SeamSearch::polish(int rounds)
{
    for (int round = 0; round < rounds && !stopped(); ++round) {
        int done = zipEnds();
        done += splitBoundary(120);
        done += zipEnds();
        if (done == 0)
            break;
    }
}

//! Stitches seams from their free ends, up to zipLookAhead edges at a time. \returns the number of changes
int SeamSearch::zipEnds()
{
    const SeamGraph &graph = *mState.graph;
    int zipped = 0;
    for (int v = 0; v < graph.vertexCount && !stopped(); ++v) {
        int tip = v;
        while (mState.cutsAt[tip] == 1 && !graph.border[tip]) {
            SeamChange change;
            int at = tip;
            bool done = false;
            bool fresh = false;
            while (static_cast<int>(change.close.size()) < zipLookAhead) {
                int next = -1, count = 0;
                for (const int e : graph.edgesAt(at)) {
                    if (mState.cut[e]) {
                        ++count;
                        if (change.close.empty() || e != change.close.back())
                            next = e;
                    }
                }
                if (next < 0 || count > 2 || graph.rule[next] == SeamGraph::Rule::AlwaysCut)
                    break;
                change.close.push_back(next);
                at = graph.farEnd(next, at);
                if (change.close.size() == 1) {
                    fresh = mZipTried[next] < std::max(mChanged[tip], mChanged[at]);
                    if (!fresh)
                        break;
                    mZipTried[next] = mClock;
                }
                double length = 0;
                for (const int e : change.close)
                    length += graph.cost[e];
                if (attempt(Zip, change, smallPatch, trialSteps, leastGain) ||
                    (mTrial.lastGain() > -0.4 * mMu * length &&
                     attempt(Zip, change, mediumPatch, trialSteps, leastGain))) {
                    done = true;
                    break;
                }
            }
            if (!done)
                break;
            ++zipped;
            tip = at;
        }
    }
    return zipped;
}

//! For every edge that leads from a boundary vertex inwards: the energy that opening it would gain by a
//! quadratic model of the two parts of the vertex, over mu times its cost. Best first.
std::vector<SeamSearch::Cut> SeamSearch::splitCandidates() const
{
    const SeamGraph &graph = *mState.graph;
    std::vector<Cut> result;
    struct Part
    {
        Vec2 gradient;
        double stiffness;
        int edge; //!< at the far side of these triangles, -1 at the boundary
    };
    std::vector<Part> fan;
    double gradient[6], h[21];
    for (const int start : mState.boundary) {
        fan.clear();
        int side = start;
        Vec2 sum = Vec2::Zero();
        double stiffness = 0;
        while (true) {
            const int t = side / 3, k = side % 3;
            mState.derivativesOf(t, &mState.x[6 * static_cast<std::size_t>(t)], gradient, h);
            static constexpr int first[3][2] = {{0, 2}, {5, 9}, {14, 20}};
            sum += Vec2(gradient[2 * k], gradient[2 * k + 1]);
            stiffness += 0.5 * (h[first[k][0]] + h[first[k][1]]);
            const int back = 3 * t + (k + 2) % 3;
            if (mState.isCutSide(back)) {
                fan.push_back({sum, stiffness, -1});
                break;
            }
            fan.push_back({sum, stiffness, graph.edgeOf[back]});
            side = graph.across[back];
        }
        const int v = graph.vertex[start];
        for (std::size_t i = 0; i + 1 < fan.size(); ++i) {
            const int e = fan[i].edge;
            if (graph.rule[e] == SeamGraph::Rule::NeverCut)
                continue;
            const double a = fan[i].stiffness, b = stiffness - a;
            const double gain = 0.5 * fan[i].gradient.squaredNorm() * (1 / a + 1 / std::max(b, 1e-3 * a));
            result.push_back({gain / (mMu * graph.cost[e] + 1e-12), e, v});
        }
    }
    std::sort(result.begin(), result.end(), [](const Cut &a, const Cut &b) {
        return a.score != b.score ? a.score > b.score
               : a.edge != b.edge ? a.edge < b.edge
                                  : a.vertex < b.vertex;
    });
    return result;
}

//! The uncut edge at `vertex` that best continues the direction of `edge`, with a cosine above 0.3; -1 when
//! there is none.
int SeamSearch::straightOn(int edge, int vertex) const
{
    const SeamGraph &graph = *mState.graph;
    const MeshData &mesh = *graph.soup->mesh;
    const auto direction = [&](int e, int from) {
        const EdgePair &pair = mesh.edgePairs[e];
        const int a = graph.ends[e][0] == from ? 0 : 1;
        const Vec3 d = mesh.cornerPosition(mesh.cornerOfSoup(pair.corner[1 - a][0])) -
                       mesh.cornerPosition(mesh.cornerOfSoup(pair.corner[a][0]));
        return Vec3(d / std::max(d.norm(), 1e-300));
    };
    const Vec3 along = direction(edge, graph.farEnd(edge, vertex));
    int best = -1;
    double most = 0.3;
    for (const int e : graph.edgesAt(vertex)) {
        if (e == edge || mState.cut[e] || graph.rule[e] == SeamGraph::Rule::NeverCut)
            continue;
        const double cosine = direction(e, vertex).dot(along);
        if (cosine > most) {
            most = cosine;
            best = e;
        }
    }
    return best;
}

//! Cuts edges that lead inwards from the boundary where that pays; two edges when one alone nearly does.
//! \param most number of trials
int SeamSearch::splitBoundary(int most)
{
    const SeamGraph &graph = *mState.graph;
    int split = 0, tries = 0;
    for (const Cut &cut : splitCandidates()) {
        if (tries >= most || cut.score < 0.05 || stopped())
            break;
        const int e = cut.edge, w = graph.farEnd(e, cut.vertex);
        if (mState.cut[e] || mSplitTried[e] >= std::max(mChanged[cut.vertex], mChanged[w]))
            continue;
        ++tries;
        mSplitTried[e] = mClock;
        SeamChange change{{e}, {}};
        if (attempt(Split, change, smallPatch, trialSteps, leastGain)) {
            ++split;
            continue;
        }
        if (mTrial.lastGain() < -0.7 * mMu * graph.cost[e] || mState.cutsAt[w] > 0 || graph.border[w])
            continue;
        const int next = straightOn(e, w);
        if (next < 0)
            continue;
        change.open.push_back(next);
        split += attempt(Split, change, smallPatch, trialSteps, leastGain);
    }
    return split;
}

//! The boundary loops of islands that are to lie along the axes, and may turn, where something has changed
//! since the last look.
std::vector<std::vector<int>> SeamSearch::loopsWithNecks() const
{
    const SeamGraph &graph = *mState.graph;
    const MeshData &mesh = *graph.soup->mesh;
    const std::vector<char> held = mState.chartsWithAnchors();
    const CutMesh charts(mesh, CutFlags(mState.cut.begin(), mState.cut.end()));
    std::vector<std::vector<int>> loops = charts.boundaryLoops();
    std::erase_if(loops, [&](const std::vector<int> &loop) {
        const int t = loop.front() / 3;
        return !(*graph.aligned)[mesh.component[t]] || held[mState.chart[t]] ||
               std::none_of(loop.begin(), loop.end(),
                            [&](int side) { return mChanged[graph.vertex[side]] > mNecksTried; });
    });
    return loops;
}

bool SeamSearch::cutNeckOf(const std::vector<int> &loop)
{
    constexpr std::size_t tries = 4; // the best necks
    const std::vector<Neck> necks = necksOf(mState, loop, mOptions.job);
    for (std::size_t i = 0; i < std::min(tries, necks.size()) && !stopped(); ++i) {
        if (attempt(Part, {necks[i].edges, {}}, mediumPatch, trialSteps, leastGain))
            return true;
    }
    return false;
}

bool SeamSearch::cutNecks()
{
    if (mState.crooked == 0)
        return false;
    bool anyCut = false;
    // Each round cuts every loop once at most; the parts are looked at again in the next one.
    for (bool again = true; again && !stopped();) {
        again = false;
        const std::vector<std::vector<int>> loops = loopsWithNecks();
        mNecksTried = mClock;
        for (const std::vector<int> &loop : loops) {
            if (!stopped() && cutNeckOf(loop))
                again = anyCut = true;
        }
    }
    return anyCut;
}

//! Worsening that the next change is allowed: exponentially distributed, as in simulated annealing.
double SeamSearch::heat()
{
    return -std::log(1 - mRandom.uniform()) * mHeat * mMu * mState.graph->soup->meanEdgeLength;
}

bool SeamSearch::tryLargeMove()
{
    // Rerouting a window is by far the most often accepted move.
    const double kind = mRandom.uniform();
    const Move move = kind < 0.6 ? Window : kind < 0.75 ? Remove : kind < 0.87 ? Regraft : Add;
    const SeamChange change = move == Window    ? windowChange()
                              : move == Remove  ? removeChange()
                              : move == Regraft ? regraftChange()
                                                : addChange();
    const int edges = static_cast<int>(change.open.size() + change.close.size());
    if (edges == 0)
        return false;
    const double before = mState.objective(mMu);
    const int size = std::clamp(trianglesPerMovedEdge * edges, 200, 1000);
    if (move == Window)
        return attempt(move, change, size, trialSteps, leastGain - heat());
    double moved = 0;
    for (const int e : change.open)
        moved += mState.graph->cost[e];
    for (const int e : change.close)
        moved += mState.graph->cost[e];
    if (!attempt(move, change, size, trialSteps, -promising * mMu * moved, &mBefore))
        return false;
    polish(2);
    if (mState.objective(mMu) < before - leastGain + heat())
        return true;
    --counts[move].kept;
    mState = mBefore;
    mTrial.reset();
    return false;
}

} // namespace autocuts::search
