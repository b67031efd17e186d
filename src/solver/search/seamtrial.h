// One trial: changes the seams within a patch and keeps the change when the objective falls.
#pragma once

#include "solver/search/cutstate.h"
#include "solver/search/patch.h"
#include "solver/search/topologyupdate.h"

#include <functional>
#include <limits>
#include <vector>

namespace autocuts::search {

//! Edge pairs to cut and to stitch in one change.
struct SeamChange
{
    std::vector<int> open, close;

    bool isEmpty() const { return open.empty() && close.empty(); }
};

//! Conditions for a change to be kept, and the effort spent on it.
struct TrialTerms
{
    double mu = 0.06;      //!< energy that one unit of seam cost is worth
    int patchSize = 110;   //!< triangles that may move
    int steps = 6;         //!< Newton steps
    double minGain = 1e-6; //!< the decrease of energy + mu * seam cost must be larger
    double ceiling =
        std::numeric_limits<double>::infinity(); //!< the energy of the map may not rise above this
    bool guarded = true;                         //!< no chart may come to overlap itself
    bool parts = false; //!< the change may part an island, however few edges it opens
};

//! A change that a trial would keep, and what it changes of the map.
struct KeptChange
{
    SeamChange change; //!< may close more edges than was asked for
    std::vector<int> triangles;
    std::vector<double> x, triangleEnergy;                                //!< of these triangles afterwards
    double energy = 0, distortion = 0, cost = 0, crooked = 0, length = 0; //!< of the map afterwards
};

//! Trials on one map. The gain of a change is exact, not an estimate, because nothing outside the patch
//! moves.
class SeamTrial
{
public:
    using MapSink = std::function<void(const CutState &)>;

    explicit SeamTrial(CutState &state);

    //! Makes the change and keeps it when it fulfils the terms, else leaves the state as it was.
    //! \param before receives the state as it was, when the change may be kept; null: not asked for
    //! \returns true when the change was kept
    bool attempt(const SeamChange &change, const TrialTerms &terms, CutState *before = nullptr)
    {
        return attempt(change, terms, before, nullptr);
    }
    //! Finds out whether the change would be kept, and leaves the state as it was, to the last bit.
    //! \param kept set when it would be
    bool wouldKeep(const SeamChange &change, const TrialTerms &terms, KeptChange &kept)
    {
        return attempt(change, terms, nullptr, &kept);
    }
    //! Makes a change that a trial on a copy of this map would keep.
    void adopt(const KeptChange &kept);
    //! Cuts uncut edges that separate charts, and moves the charts apart rigidly.
    void cutApart(const std::vector<int> &edges);
    //! Must be called when the state has been replaced from outside.
    void reset() { mX = mState.x; }
    //! From now on, guarded relaxations bar contacts at once: for charts that are known to overlap otherwise.
    void barContacts() { mGuardedFor = std::numeric_limits<int>::max(); }
    //! Minimises the energy of every chart by Newton steps with the seams fixed. When stopped, the chart
    //! under way stays as it was, so that more time never gives less.
    //! \param between called between the steps of large charts with the map as it is then, where valid
    //! \returns the energy gained
    double relaxAll(int steps, bool guarded, const JobContext &job = {}, const MapSink &between = {});
    //! The same for some charts. \param which per chart
    double relaxCharts(const std::vector<char> &which, int steps, bool guarded, const JobContext &job = {},
                       const MapSink &between = {});
    //! The same for the charts that have anchors.
    double relaxAnchored(int steps, bool guarded, const JobContext &job = {});
    //! Puts the corner of a hard pin onto it and holds it there, unless that flips a triangle or makes charts
    //! overlap. \param pin its index in the anchors
    bool reachPin(int pin, bool guarded);
    //! Decrease of the objective by the last attempt, kept or not; minus infinity when the change could not
    //! be made.
    double lastGain() const { return mLastGain; }

    CutState &state() { return mState; }
    Patch &patch() { return mPatch; }

private:
    bool attempt(const SeamChange &change, const TrialTerms &terms, CutState *before, KeptChange *instead);
    KeptChange changeMade(const SeamChange &change) const;
    bool mayChange(const SeamChange &change) const;
    void closeLoneEdges(SeamChange &change);
    static void setFlags(CutState &state, const std::vector<int> &edges, bool cut);
    void setFlags(const std::vector<int> &edges, bool cut) { setFlags(mState, edges, cut); }
    bool closeGaps(const std::vector<int> &close);
    //! The connected components of the patch over its uncut sides.
    struct Pieces
    {
        std::vector<int> piece;    //!< per triangle of the patch: its component
        std::vector<char> settled; //!< per component: it keeps its place
    };
    Pieces findPieces() const;
    void alignPieces(const std::vector<int> &close);
    double solve(const SeamChange &change, const TrialTerms &terms, double before, double costGain);
    void relaxChart(const std::vector<int> &triangles, int steps, bool guarded, const JobContext &job,
                    const MapSink &between);
    void keep();
    void undo();
    bool keepsCharts(const SeamChange &change, int oldSmallParts);
    double hopeOf(const SeamChange &change, bool parts) const;
    std::vector<int> seedsOf(const SeamChange &change) const;

    CutState &mState;
    Patch mPatch;
    TopologyUpdate mTopology;
    std::vector<double> mX; //!< coordinates of the state, except for the patch during an attempt
    double mLastGain = 0;
    std::vector<double> mOldX, mOldEnergy; //!< of the patch, before keep()
    std::vector<double> mOldAreas;         //!< of the charts, before an attempt
    double mOldSum = 0, mOldDistortion = 0;
    //! Per triangle, for the first one of a chart: the energy from which the chart could not be relaxed.
    std::vector<double> mSettled;
    int mGuardedFor = 0;           //!< number of further chart relaxations that bar contacts from the start
    bool mTopologyChanged = false; //!< the state's topology was updated during the attempt
};

} // namespace autocuts::search
