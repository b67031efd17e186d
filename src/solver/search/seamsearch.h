// Local search on one map: shortens its seams and opens new ones where distortion concentrates.
#pragma once

#include "solver/base/constant.h"
#include "solver/base/jobcontext.h"
#include "solver/base/random.h"
#include "solver/search/seamchains.h"
#include "solver/search/seamtrial.h"
#include "solver/search/trialsahead.h"

#include <deque>
#include <functional>
#include <memory>
#include <vector>

namespace autocuts::search {

struct SearchOptions
{
    double mu = 0.06;    //!< energy that one unit of seam cost is worth
    bool guarded = true; //!< no chart may come to overlap itself
    JobContext job;
};

//! Lowers energy + mu * cost of a map by trials on patches. It rises only with heat and for small charts.
class SeamSearch
{
public:
    SeamSearch(CutState &state, std::uint64_t seed, const SearchOptions &options);

    //! From now on, several threads try what comes next, see TrialsAhead. \param threads including the
    //! calling one
    void useThreads(int threads);
    void setMu(double mu);
    double mu() const { return mMu; }
    //! Heat of the simulated annealing: mean worsening allowed to a large move, in mean edge lengths of seam.
    //! Zero: none. \param moves large moves over which it falls to zero
    void setHeat(double heat, int moves = 1);
    //! No change may raise the energy of the map above this.
    void setCeiling(double ceiling);

    //! Zips free ends and splits boundaries where that pays, for `rounds` rounds or until nothing changes.
    void polish(int rounds);
    //! Tries one random large move: reroutes a part of a seam, closes one, regrafts one or adds one.
    //! \param following large moves that come after it before anything else changes: they may be tried ahead
    //! \returns true when the move was kept
    bool tryLargeMove(int following = 0);
    //! Joins charts below CutState::smallestChart() to their neighbours at any cost, as long as the energy
    //! stays below the ceiling.
    void absorbSmallCharts();
    //! Joins charts along their whole common seams where that pays, the longest seam first.
    void joinCharts();
    //! Cuts islands through at their necks where that pays, see seamnecks.h. Looks only at loops along which
    //! something has changed since the last call. Charts with anchors stay whole. \returns true when
    //! something was cut
    bool cutNecks();
    //! Tries random new seams and leaves the map as it was.
    //! \returns the one that lowers the energy most per length; empty when none does
    std::vector<int> bestNewSeam(int tries);
    //! Takes charts to their pins, see anchoring.h. Does nothing when that has been done.
    void anchor();
    //! See SeamTrial::relaxAll().
    double relaxAll(int steps, const SeamTrial::MapSink &between = {});
    //! See SeamTrial::relaxCharts().
    double relaxCharts(const std::vector<char> &which, int steps);
    //! See CutState::updateEnergy().
    void updateEnergy();
    //! Replaces the map under search. \pre it is a map of the same mesh
    void restore(const CutState &state);

    //! Newton steps so far, but for those of trials that were made ahead and forgotten.
    int steps() { return mStepsAhead + mTrial.patch().steps(); }
    long long work() { return mWorkAhead + mTrial.patch().work(); } //!< see Patch::work()
    bool stopped() const { return mOptions.job.stopped(); }
    struct Counts
    {
        int tried = 0, kept = 0;
    };
    enum Move { Zip, Split, Window, Remove, Regraft, Add, Absorb, Part, MoveCount };
    std::array<Counts, MoveCount> counts{};

private:
    //! Triangles of a patch: the usual size, and the one for trials whose result on the small patch was
    //! close. Found on the first meshes (docs/constants.md).
    static inline AUTOCUTS_CONSTANT(int, smallPatch, 110);
    static inline AUTOCUTS_CONSTANT(int, mediumPatch, 450);
    static inline AUTOCUTS_CONSTANT(int, trialSteps, 6); //!< Newton steps of a trial
    //! Of energy + mu * cost, by a change that is kept. Chosen by hand.
    static inline AUTOCUTS_CONSTANT(double, leastGain, 2e-6);

    struct Cut
    {
        double score;     //!< estimated energy gain over seam cost
        int edge, vertex; //!< the edge, and its end on the boundary
    };
    //! A list of trials, made one after another until one is kept.
    struct Task
    {
        Move move;
        int number = 0;        //!< Zip: the free end; Split: the edge; else different for each task
        int vertex = 0;        //!< Split: its end on the boundary
        SeamChange change{};   //!< but for Zip and Split
        int size = smallPatch; //!< triangles of the patch
        int steps = trialSteps;
        double minGain = leastGain;

        bool isSameAs(const Task &other) const
        {
            return move == other.move && number == other.number && vertex == other.vertex;
        }
    };
    //! A task, and the random numbers after it has been drawn.
    struct LargeMove
    {
        Task task;
        Random after;
    };
    //! Where a task is tried: on the map, or on a copy of it, where nothing is kept.
    struct Place
    {
        SeamTrial &trial;
        TrialOutcome &outcome;
        bool isCopy;
        CutState *before = nullptr; //!< see SeamTrial::attempt()
    };
    //! Lists the task at hand and others that come next if it fails, no more than so many.
    using Foresight = std::function<std::vector<Task>(std::size_t most)>;

    void touchAll();
    void mapChanged();
    void forgetAhead();
    int zipEnds();
    int freshEdgeAt(int tip) const;
    bool zip(const Place &place, int tip) const;
    int splitBoundary(int most);
    bool isWorthSplitting(const Cut &cut) const;
    bool split(const Place &place, int edge, int vertex) const;
    bool attempt(Move move, const SeamChange &asked, int size, int steps, double minGain);
    bool attemptAt(const Place &place, Move move, const SeamChange &asked, int size, int steps,
                   double minGain) const;
    bool tryAt(const Place &place, const Task &task) const;
    bool tryTask(const Task &task, const Foresight &foresight, TrialOutcome &outcome,
                 CutState *before = nullptr);
    TrialOutcome triedAhead(const Task &task, const Foresight &foresight);
    void noteChange(Move move, const SeamChange &asked, const std::vector<int> &triangles);
    void drawLargeMove();
    SeamChange changeOf(Move move);
    std::vector<std::vector<int>> loopsWithNecks() const;
    bool cutNeckOf(const std::vector<int> &loop);
    static SeamChange withMirrorImages(const SeamChange &change, const CutState &state);
    std::vector<std::vector<int>> seamsAround(int chart) const;
    bool absorb(int chart);
    bool tryJoin(const std::vector<Task> &joins, std::size_t which);
    std::vector<int> regionAcross(int chart, int edge) const;
    void cutApart(const std::vector<int> &edges);
    bool grow(int chart);
    SeamChange windowChange();
    SeamChange removeChange();
    SeamChange regraftChange();
    SeamChange addChange();
    int randomSeamEdge();
    double heat(int move);
    std::vector<Cut> splitCandidates() const;
    static int straightOn(const CutState &state, int edge, int vertex);

    CutState &mState;
    SearchOptions mOptions;
    double mMu;
    double mHeat = 0;
    int mCoolingMoves = 1, mMovesMade = 0; //!< see setHeat()
    double mCeiling = std::numeric_limits<double>::infinity();
    Random mRandom;
    SeamTrial mTrial;
    SeamPaths mPaths;
    CutState mBefore; //!< before the last large move that was kept; a buffer
    // A trial that failed is repeated only after something near it has changed. The clock counts changes.
    int mClock = 1;
    int mNecksTried = 0;                     //!< clock of the last call of cutNecks()
    std::vector<int> mChanged;               //!< per vertex of the uncut surface: clock of the last change
    std::vector<int> mZipTried, mSplitTried; //!< per edge: clock of the last trial
    std::unique_ptr<TrialsAhead> mThreads;   //!< null: the search has no other threads
    struct Ahead
    {
        Task task;
        TrialOutcome outcome;
    };
    std::deque<Ahead> mAhead;     //!< tried ahead, in the order in which they are expected
    std::deque<LargeMove> mDrawn; //!< large moves drawn ahead
    int mTasks = 0;               //!< numbers given to tasks
    int mStepsAhead = 0;          //!< Newton steps of trials on copies that counted
    long long mWorkAhead = 0;
};

} // namespace autocuts::search
