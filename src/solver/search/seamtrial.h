// Tries a change of the seams on a patch and keeps it when it pays.
#pragma once

#include "solver/search/cutstate.h"
#include "solver/search/patch.h"

#include <limits>
#include <vector>

namespace autocuts::search {

//! Edges to open and to close in one go.
struct SeamChange
{
    std::vector<int> open, close;
};

//! What a change has to bring.
struct TrialTerms
{
    double mu = 0.06;      //!< energy that one unit of seam is worth
    int patchSize = 110;   //!< triangles that may move
    int steps = 6;         //!< of Newton's method
    double minGain = 1e-6; //!< least decrease of energy + mu * seam cost
    double ceiling =
        std::numeric_limits<double>::infinity(); //!< no gain may lift the energy of the map above it
    bool guarded = true;                         //!< no chart may come to cover itself
};

//! One map under search. Every accepted change lowers energy + mu * cost exactly as computed: what is outside
//! of the patch stands still.
class SeamTrial
{
public:
    explicit SeamTrial(CutState &state);

    //! Makes the change and keeps it when it gains enough, else leaves the state as it was.
    bool attempt(const SeamChange &change, const TrialTerms &terms);
    //! To be called when the state has been replaced from outside.
    void reset() { mX = mState.x; }
    //! Moves all points downhill; returns the energy gained.
    double relaxAll(int steps, bool guarded);
    //! Gain of the last attempt, also when it was not enough; minus infinity when it could not be made.
    double lastGain() const { return mLastGain; }

    CutState &state() { return mState; }
    Patch &patch() { return mPatch; }
    double work() const { return mPatch.work(); }

private:
    bool mayChange(const SeamChange &change) const;
    void closeLoneEdges(SeamChange &change);
    void setFlags(const std::vector<int> &edges, bool cut);
    bool closeGaps(const std::vector<int> &close);
    //! What hangs together in the patch while edges are cut.
    struct Pieces
    {
        std::vector<int> piece;    //!< per triangle of the patch
        std::vector<char> settled; //!< per piece: it stays where it is
    };
    Pieces findPieces() const;
    void alignPieces(const std::vector<int> &close);
    double solve(const SeamChange &change, const TrialTerms &terms, double before, double costGain);
    void relaxChart(const std::vector<int> &triangles, int steps, bool guarded);
    void keep();
    void undo();
    bool keepsCharts(int oldSmallParts);
    std::vector<int> seedsOf(const SeamChange &change) const;

    CutState &mState;
    Patch mPatch;
    std::vector<double> mX; //!< equal to the coordinates of the state but for the patch of the moment
    double mLastGain = 0;
    std::vector<double> mOldX, mOldEnergy; //!< of the patch, before keep()
    double mOldSum = 0;
    int mGuardedFor = 0;           //!< so many relaxations need not try the free way
    bool mTopologyChanged = false; //!< the state's topology is that of the change
};

} // namespace autocuts::search
