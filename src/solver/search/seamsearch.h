// Local search on one map: shortens its seams and opens new ones where distortion concentrates.
#pragma once

#include "solver/base/constant.h"
#include "solver/base/jobcontext.h"
#include "solver/base/random.h"
#include "solver/search/seamchains.h"
#include "solver/search/seamtrial.h"

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

    void setMu(double mu);
    double mu() const { return mMu; }
    //! Heat of the simulated annealing: mean worsening allowed to a large move, in mean edge lengths of seam.
    //! Zero: none.
    void setHeat(double heat) { mHeat = heat; }
    //! No change may raise the energy of the map above this.
    void setCeiling(double ceiling) { mCeiling = ceiling; }

    //! Zips free ends and splits boundaries where that pays, for `rounds` rounds or until nothing changes.
    void polish(int rounds);
    //! Tries one random large move: reroutes a part of a seam, closes one, regrafts one or adds one.
    //! \returns true when the move was kept
    bool tryLargeMove();
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
    double relaxAll(int steps, const SeamTrial::MapSink &between = {})
    {
        return mTrial.relaxAll(steps, mOptions.guarded, mOptions.job, between);
    }
    //! See SeamTrial::relaxCharts().
    double relaxCharts(const std::vector<char> &which, int steps)
    {
        return mTrial.relaxCharts(which, steps, mOptions.guarded, mOptions.job);
    }
    //! Replaces the map under search. \pre it is a map of the same mesh
    void restore(const CutState &state);

    //! Newton steps so far.
    int steps() { return mTrial.patch().steps(); }
    long long work() { return mTrial.patch().work(); } //!< see Patch::work()
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

    void touchAll();
    int zipEnds();
    int splitBoundary(int most);
    bool attempt(Move move, const SeamChange &asked, int size, int steps, double minGain,
                 CutState *before = nullptr);
    std::vector<std::vector<int>> loopsWithNecks() const;
    bool cutNeckOf(const std::vector<int> &loop);
    SeamChange withMirrorImages(const SeamChange &change) const;
    std::vector<std::vector<int>> seamsAround(int chart) const;
    bool absorb(int chart);
    std::vector<int> regionAcross(int chart, int edge) const;
    void cutApart(const std::vector<int> &edges);
    bool grow(int chart);
    SeamChange windowChange();
    SeamChange removeChange();
    SeamChange regraftChange();
    SeamChange addChange();
    int randomSeamEdge();
    double heat();
    struct Cut
    {
        double score;     //!< estimated energy gain over seam cost
        int edge, vertex; //!< the edge, and its end on the boundary
    };
    std::vector<Cut> splitCandidates() const;
    int straightOn(int edge, int vertex) const;

    CutState &mState;
    SearchOptions mOptions;
    double mMu;
    double mHeat = 0;
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
};

} // namespace autocuts::search
