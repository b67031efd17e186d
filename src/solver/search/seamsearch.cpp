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
//! Score below which an edge is not opened, see splitCandidates(). Counted in standard on four meshes of 150
//! to 12,000 triangles: of the tries, .07 % are kept where the score is below .125, .3 % from there to .25,
//! and 12 % above. All the same they are worth their time: with .15 after large moves, and no stitching where
//! a like model promises less than a tenth of its price, the seams of 14 maps are 1.023 times as long in .97
//! of the CPU time.
AUTOCUTS_CONSTANT(double, leastCutScore, 0.05);
//! Tasks that are tried ahead at a time, per thread: a tenth of them is kept, and what comes after is
//! forgotten.
constexpr int tasksPerThread = 8;
//! Threads of one search, at most, and triangles of the copies that they work on.
constexpr int mostThreads = 16;
constexpr int mostCopiedTriangles = 4'000'000;

} // namespace

SeamSearch::SeamSearch(CutState &state, std::uint64_t seed, const SearchOptions &options)
    : mState(state), mOptions(options), mMu(options.mu), mRandom(seed), mTrial(state), mPaths(state),
      mChanged(state.graph->vertexCount, 1), mZipTried(state.cut.size(), 0), mSplitTried(state.cut.size(), 0)
{}

void SeamSearch::useThreads(int threads)
{
    const int most =
        std::clamp(mostCopiedTriangles / std::max(1, mState.graph->triangleCount()), 1, mostThreads);
    const int wanted = std::min(threads, most);
    if (wanted == (mThreads ? mThreads->threads() : 1))
        return;
    forgetAhead();
    mThreads = wanted > 1 ? std::make_unique<TrialsAhead>(mState, wanted) : nullptr;
}

void SeamSearch::setMu(double mu)
{
    if (mu != mMu)
        forgetAhead();
    if (std::abs(std::log(mu / mMu)) > 0.1) {
        std::fill(mZipTried.begin(), mZipTried.end(), 0);
        std::fill(mSplitTried.begin(), mSplitTried.end(), 0);
    }
    mMu = mu;
}

void SeamSearch::setHeat(double heat, int moves)
{
    forgetAhead();
    mHeat = heat;
    mCoolingMoves = moves;
    mMovesMade = 0;
}

void SeamSearch::setCeiling(double ceiling)
{
    forgetAhead();
    mCeiling = ceiling;
}

double SeamSearch::relaxAll(int steps, const SeamTrial::MapSink &between)
{
    mapChanged();
    return mTrial.relaxAll(steps, mOptions.guarded, mOptions.job, between);
}

double SeamSearch::relaxCharts(const std::vector<char> &which, int steps)
{
    mapChanged();
    return mTrial.relaxCharts(which, steps, mOptions.guarded, mOptions.job);
}

void SeamSearch::updateEnergy()
{
    mapChanged();
    mState.updateEnergy();
}

//! Must be called when the map changes in another way than by a task.
void SeamSearch::mapChanged()
{
    forgetAhead();
    if (mThreads)
        mThreads->mapChanged();
}

//! What comes next, or what makes a trial succeed, is not what it was.
void SeamSearch::forgetAhead()
{
    mAhead.clear();
    mDrawn.clear();
}

//! One trial on the map itself.
bool SeamSearch::attempt(Move move, const SeamChange &asked, int size, int steps, double minGain)
{
    TrialOutcome outcome;
    const bool kept = attemptAt({mTrial, outcome, false}, move, asked, size, steps, minGain);
    counts[move].tried += outcome.tried;
    if (kept) {
        mapChanged();
        noteChange(move, outcome.asked, mTrial.patch().triangles());
    }
    return kept;
}

//! One trial, on the map or on a copy of it.
bool SeamSearch::attemptAt(const Place &place, Move move, const SeamChange &asked, int size, int steps,
                           double minGain) const
{
    SeamTrial &trial = place.trial;
    ++place.outcome.tried;
    place.outcome.asked = withMirrorImages(asked, trial.state());
    TrialTerms terms;
    terms.mu = mMu;
    terms.patchSize = mState.graph->isMirrored() ? 2 * size : size;
    terms.steps = steps;
    terms.minGain = minGain;
    terms.guarded = mOptions.guarded;
    terms.ceiling = mCeiling;
    terms.parts = move == Part;
    place.outcome.kept = place.isCopy ? trial.wouldKeep(place.outcome.asked, terms, place.outcome.change)
                                      : trial.attempt(place.outcome.asked, terms, place.before);
    return place.outcome.kept;
}

//! The trials of a task, on the map or on a copy of it.
bool SeamSearch::tryAt(const Place &place, const Task &task) const
{
    if (task.move == Zip)
        return zip(place, task.number);
    if (task.move == Split)
        return split(place, task.number, task.vertex);
    return !task.change.isEmpty() &&
           attemptAt(place, task.move, task.change, task.size, task.steps, task.minGain);
}

//! Tries a task, here or ahead on a copy, and changes the map when it is kept.
bool SeamSearch::tryTask(const Task &task, const Foresight &foresight, TrialOutcome &outcome,
                         CutState *before)
{
    if (mThreads) {
        outcome = triedAhead(task, foresight);
        mStepsAhead += outcome.steps;
        mWorkAhead += outcome.work;
        if (outcome.kept) {
            if (before)
                *before = mState;
            mTrial.adopt(outcome.change);
        }
    } else {
        tryAt({mTrial, outcome, false, before}, task);
    }
    counts[task.move].tried += outcome.tried;
    if (outcome.kept) {
        forgetAhead();
        noteChange(task.move, outcome.asked,
                   mThreads ? outcome.change.triangles : mTrial.patch().triangles());
        if (mThreads)
            mThreads->adopted(std::move(outcome.change));
    }
    return outcome.kept;
}

//! What came of a task on a copy of the map. Tries those that come next as well, unless that has been done.
TrialOutcome SeamSearch::triedAhead(const Task &task, const Foresight &foresight)
{
    while (!mAhead.empty() && !mAhead.front().task.isSameAs(task))
        mAhead.pop_front();
    if (mAhead.empty()) {
        const std::size_t most = tasksPerThread * static_cast<std::size_t>(mThreads->threads());
        const std::vector<Task> next = foresight(most);
        std::vector<TrialsAhead::Task> tasks;
        for (const Task &t : next)
            tasks.push_back([this, &t](SeamTrial &trial, TrialOutcome &outcome) {
                tryAt({trial, outcome, true}, t);
            });
        std::vector<TrialOutcome> outcomes = mThreads->run(tasks);
        for (std::size_t i = 0; i < outcomes.size(); ++i)
            mAhead.push_back({next[i], std::move(outcomes[i])});
    }
    TrialOutcome outcome = std::move(mAhead.front().outcome);
    mAhead.pop_front();
    return outcome;
}

//! Counts a change that was kept, and what lies near it as changed.
void SeamSearch::noteChange(Move move, const SeamChange &asked, const std::vector<int> &triangles)
{
    ++counts[move].kept;
    ++mClock;
    const std::size_t disturbed =
        std::min(triangles.size(), disturbedTriangles + 4 * (asked.open.size() + asked.close.size()));
    for (std::size_t i = 0; i < disturbed; ++i) {
        for (int k = 0; k < 3; ++k)
            mChanged[mState.graph->vertex[3 * triangles[i] + k]] = mClock;
    }
}

void SeamSearch::restore(const CutState &state)
{
    mState = state;
    mTrial.reset();
    mapChanged();
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
    mapChanged();
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

//! The one edge of a seam that ends at `tip`, when something near it has changed since it was last zipped;
//! else -1.
int SeamSearch::freshEdgeAt(int tip) const
{
    const SeamGraph &graph = *mState.graph;
    if (mState.cutsAt[tip] != 1 || graph.border[tip])
        return -1;
    const auto edges = graph.edgesAt(tip);
    const int edge = *std::find_if(edges.begin(), edges.end(), [this](int e) { return mState.cut[e] != 0; });
    const bool fresh = mZipTried[edge] < std::max(mChanged[tip], mChanged[graph.farEnd(edge, tip)]);
    return fresh && graph.rule[edge] != SeamGraph::Rule::AlwaysCut ? edge : -1;
}

//! Stitches seams from their free ends. \returns the number of changes
int SeamSearch::zipEnds()
{
    const SeamGraph &graph = *mState.graph;
    int zipped = 0;
    for (int v = 0; v < graph.vertexCount && !stopped(); ++v) {
        int tip = v;
        for (int edge = freshEdgeAt(tip); edge >= 0; edge = freshEdgeAt(tip)) {
            const auto foresight = [&](std::size_t most) {
                std::vector<Task> tasks{{Zip, tip}};
                for (int next = v + 1; next < graph.vertexCount && tasks.size() < most; ++next) {
                    if (freshEdgeAt(next) >= 0)
                        tasks.push_back({Zip, next});
                }
                return tasks;
            };
            mZipTried[edge] = mClock;
            TrialOutcome outcome;
            if (!tryTask({Zip, tip}, foresight, outcome))
                break;
            ++zipped;
            tip = outcome.end;
        }
    }
    return zipped;
}

//! Stitches a seam from its free end, up to zipLookAhead edges at a time.
bool SeamSearch::zip(const Place &place, int tip) const
{
    const CutState &state = place.trial.state();
    const SeamGraph &graph = *state.graph;
    SeamChange change;
    int at = tip;
    double length = 0;
    while (static_cast<int>(change.close.size()) < zipLookAhead) {
        int next = -1, count = 0;
        for (const int e : graph.edgesAt(at)) {
            if (state.cut[e]) {
                ++count;
                if (change.close.empty() || e != change.close.back())
                    next = e;
            }
        }
        if (next < 0 || count > 2 || graph.rule[next] == SeamGraph::Rule::AlwaysCut)
            return false;
        change.close.push_back(next);
        length += graph.cost[next];
        at = graph.farEnd(next, at);
        place.outcome.end = at;
        if (attemptAt(place, Zip, change, smallPatch, trialSteps, leastGain) ||
            (place.trial.lastGain() > -0.4 * mMu * length &&
             attemptAt(place, Zip, change, mediumPatch, trialSteps, leastGain)))
            return true;
    }
    return false;
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
int SeamSearch::straightOn(const CutState &state, int edge, int vertex)
{
    const SeamGraph &graph = *state.graph;
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
        if (e == edge || state.cut[e] || graph.rule[e] == SeamGraph::Rule::NeverCut)
            continue;
        const double cosine = direction(e, vertex).dot(along);
        if (cosine > most) {
            most = cosine;
            best = e;
        }
    }
    return best;
}

bool SeamSearch::isWorthSplitting(const Cut &cut) const
{
    const int far = mState.graph->farEnd(cut.edge, cut.vertex);
    return !mState.cut[cut.edge] && mSplitTried[cut.edge] < std::max(mChanged[cut.vertex], mChanged[far]);
}

//! Cuts edges that lead inwards from the boundary where that pays. \param most number of tries
int SeamSearch::splitBoundary(int most)
{
    std::vector<Cut> cuts = splitCandidates();
    const auto hopeless = [](const Cut &cut) { return cut.score < leastCutScore; };
    cuts.erase(std::find_if(cuts.begin(), cuts.end(), hopeless), cuts.end());
    int kept = 0, tries = 0;
    for (auto cut = cuts.begin(); cut != cuts.end() && tries < most && !stopped(); ++cut) {
        if (!isWorthSplitting(*cut))
            continue;
        ++tries;
        mSplitTried[cut->edge] = mClock;
        const auto foresight = [&](std::size_t mostTasks) {
            std::vector<Task> tasks{{Split, cut->edge, cut->vertex}};
            for (auto next = cut + 1; next != cuts.end() && tasks.size() < mostTasks; ++next) {
                if (isWorthSplitting(*next))
                    tasks.push_back({Split, next->edge, next->vertex});
            }
            return tasks;
        };
        TrialOutcome outcome;
        kept += tryTask({Split, cut->edge, cut->vertex}, foresight, outcome);
    }
    return kept;
}

//! Cuts an edge that leads inwards from the boundary; two edges when one alone nearly pays.
bool SeamSearch::split(const Place &place, int edge, int vertex) const
{
    const CutState &state = place.trial.state();
    const SeamGraph &graph = *state.graph;
    SeamChange change{{edge}, {}};
    if (attemptAt(place, Split, change, smallPatch, trialSteps, leastGain))
        return true;
    const int far = graph.farEnd(edge, vertex);
    if (place.trial.lastGain() < -0.7 * mMu * graph.cost[edge] || state.isBoundaryVertex(far))
        return false;
    const int next = straightOn(state, edge, far);
    if (next < 0)
        return false;
    change.open.push_back(next);
    return attemptAt(place, Split, change, smallPatch, trialSteps, leastGain);
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

//! Worsening that a large move is allowed: exponentially distributed, as in simulated annealing.
double SeamSearch::heat(int move)
{
    const double heat = mHeat * (1 - double(move) / mCoolingMoves);
    return -std::log(1 - mRandom.uniform()) * heat * mMu * mState.graph->soup->meanEdgeLength;
}

SeamChange SeamSearch::changeOf(Move move)
{
    return move == Window    ? windowChange()
           : move == Remove  ? removeChange()
           : move == Regraft ? regraftChange()
                             : addChange();
}

//! Draws the next large move that has not been drawn yet.
void SeamSearch::drawLargeMove()
{
    const Random now = mRandom;
    if (!mDrawn.empty())
        mRandom = mDrawn.back().after;
    // Rerouting a window is by far the most often accepted move.
    const double kind = mRandom.uniform();
    Task task{kind < 0.6 ? Window : kind < 0.75 ? Remove : kind < 0.87 ? Regraft : Add, ++mTasks};
    task.change = changeOf(task.move);
    double moved = 0;
    int count = 0;
    for (const std::vector<int> *edges : {&task.change.open, &task.change.close}) {
        count += static_cast<int>(edges->size());
        for (const int e : *edges)
            moved += mState.graph->cost[e];
    }
    task.size = std::clamp(trianglesPerMovedEdge * count, 200, 1000);
    if (task.move != Window)
        task.minGain = -promising * mMu * moved;
    else if (!task.change.isEmpty())
        task.minGain -= heat(mMovesMade + static_cast<int>(mDrawn.size()));
    mDrawn.push_back({std::move(task), mRandom});
    mRandom = now;
}

bool SeamSearch::tryLargeMove(int following)
{
    if (mDrawn.empty())
        drawLargeMove();
    const LargeMove move = std::move(mDrawn.front());
    mDrawn.pop_front();
    mRandom = move.after;
    const int number = mMovesMade++;
    if (move.task.change.isEmpty())
        return false;
    const auto foresight = [&](std::size_t most) {
        const std::size_t wanted = std::min(static_cast<std::size_t>(following), most / 4);
        while (mDrawn.size() < wanted)
            drawLargeMove();
        std::vector<Task> tasks{move.task};
        for (const LargeMove &drawn : mDrawn)
            tasks.push_back(drawn.task);
        return tasks;
    };
    const double before = mState.objective(mMu);
    TrialOutcome outcome;
    if (move.task.move == Window)
        return tryTask(move.task, foresight, outcome);
    if (!tryTask(move.task, foresight, outcome, &mBefore))
        return false;
    polish(2);
    if (mState.objective(mMu) < before - leastGain + heat(number))
        return true;
    --counts[move.task.move].kept;
    mState = mBefore;
    mTrial.reset();
    mapChanged();
    return false;
}

} // namespace autocuts::search
