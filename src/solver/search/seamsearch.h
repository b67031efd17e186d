// Shortens the seams of a map step by step, and opens new ones where distortion concentrates.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/base/random.h"
#include "solver/search/seamchains.h"
#include "solver/search/seamtrial.h"

#include <atomic>
#include <vector>

namespace autocuts::search {

//! How a search goes.
struct SearchOptions
{
    double mu = 0.06; //!< energy that one unit of seam is worth
    bool guarded = true;
    JobContext job;
};

//! Local search on one map: lowers energy + mu * cost, never raises it.
class SeamSearch
{
public:
    SeamSearch(CutState &state, std::uint64_t seed, const SearchOptions &options);

    void setMu(double mu);
    double mu() const { return mMu; }
    //! Large moves may make things worse by about so many edges (simulated annealing).
    void setHeat(double heat) { mHeat = heat; }
    //! No step may lift the energy above this.
    void setCeiling(double ceiling) { mCeiling = ceiling; }

    //! Zips free ends and splits boundaries where that pays, until little changes or `rounds` are over.
    void polish(int rounds);
    //! One random larger change: another way for a part of a seam, one less, one more. Returns true when
    //! kept.
    bool tryLargeMove();
    //! Joins charts below CutState::smallestChart to their neighbours, whatever it costs below the ceiling.
    void absorbSmallCharts();
    double relaxAll(int steps) { return mTrial.relaxAll(steps, mOptions.guarded); }
    //! Replaces the map under search. \pre of the same mesh
    void restore(const CutState &state);

    double work() const { return mTrial.work(); }
    //! Newton steps so far.
    int steps() { return mTrial.patch().steps(); }
    bool stopped() const { return mOptions.job.stopped(); }
    struct Counts
    {
        int tried = 0, kept = 0;
    };
    enum Move { Zip, Split, Window, Remove, Regraft, Add, Absorb, MoveCount };
    std::array<Counts, MoveCount> counts{};

private:
    static constexpr int smallPatch = 110, mediumPatch = 450; // triangles

    int zipEnds();
    int splitBoundary(int most);
    bool attempt(Move move, const SeamChange &asked, int size, int steps, double minGain);
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
        double score;
        int edge, vertex;
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
    // What failed is tried again only where something has changed since.
    int mClock = 1;
    std::vector<int> mChanged;               //!< per point of the surface
    std::vector<int> mZipTried, mSplitTried; //!< per edge
};

} // namespace autocuts::search
