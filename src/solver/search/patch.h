// The triangles that one trial may move, and Newton's method on them.
#pragma once

#include "solver/base/jobcontext.h"
#include "solver/search/blockcholesky.h"
#include "solver/search/cutstate.h"
#include "solver/search/patchkernel.h"
#include "solver/search/segments.h"

#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace autocuts::search {

//! When Patch::minimize() stops.
struct PatchLimits
{
    int steps = 6;           //!< Newton steps at most; see SeamSearch::trialSteps
    double tolerance = 1e-6; //!< stop when the predicted decrease (-gradient * direction) is not above this
    //! Give up when the energy would stay above this even if it fell by the whole predicted decrease, twice
    //! what the quadratic model gains.
    double hopeless = std::numeric_limits<double>::infinity();
    bool guarded = false;          //!< no step may make boundary sides cross
    JobContext job;                //!< the step under way is given up once it is stopped
    std::function<void()> stepped; //!< called after every step, when set
};

//! A patch: the triangles around a change of seams whose points may move while everything outside is held.
//! A point is a UV vertex of the patch. Works on a copy of the coordinates until store(). Buffers are reused;
//! use one patch per thread.
class Patch
{
public:
    explicit Patch(std::shared_ptr<const SeamGraph> graph);

    //! Selects about `size` triangles around `seeds`: breadth first, over uncut sides. Seeds are always
    //! taken. \param size 0: the seeds are all triangles of their charts
    void select(const CutState &state, std::span<const int> seeds, int size);
    const std::vector<int> &triangles() const { return mTriangles; }
    //! Index of a triangle in triangles(), -1 outside the patch.
    int localOf(int triangle) const { return mLocal[triangle]; }

    //! Welds the corners of the patch to points according to the state's cut flags. A point shared with a
    //! triangle outside, or with a corner on a hard pin, is held there; any other one goes to the mean of its
    //! corners.
    //! \param x coordinates to start from, as in the state
    //! \returns false when one point is held at two positions
    bool join(const CutState &state, const std::vector<double> &x);
    //! Moves the points on newly cut edges a little into their own side of the cut, so that the two sides no
    //! longer coincide.
    void partSides(const std::vector<int> &edges);
    //! Adds springs that pull the two sides of cut edges together, to stitch them afterwards.
    void addSprings(const std::vector<int> &edges);
    void setStiffness(double stiffness) { mStiffness = stiffness; }

    //! Energy of the patch without the springs, see CutState::energyOf(); infinite when a triangle is
    //! flipped.
    double energy() const { return energyAt(mPosition); }
    //! Smallest Jacobian determinant of the patch; 1 at an isometry, not positive when a triangle is flipped.
    double smallestDeterminant() const;
    //! Minimises energy and springs by Newton's method. \returns the number of steps taken
    //! \pre energy() is finite
    int minimize(const PatchLimits &limits);
    //! True when boundary sides of the patch cross each other or boundary sides of the state outside.
    bool crossesItself();
    //! Writes the coordinates of the patch into x.
    void store(std::vector<double> &x) const;
    //! Writes coordinates and triangle energies of the patch into the state and updates the state's energy
    //! and distortion.
    void commit(CutState &state) const;

    //! Newton steps since construction.
    int steps() const { return mSteps; }
    //! Their sizes added up: triangles.
    long long work() const { return mWork; }

private:
    void setTriangles(const std::vector<int> &triangles);
    void findAcross(const CutState &state);
    void mergeCorners();
    double distortionOf(const CutState &state) const;
    void numberUnknowns();
    void addSidesAround();
    void addObstacles();
    void loadBlocks();
    double energyAt(const std::vector<double> &position) const;
    double springEnergy(const std::vector<double> &position) const;
    void assemble();
    void assembleTriangles();
    template <int stride>
    void assembleTriangle(std::size_t i, const double *g, const double *h);
    void assembleSprings();
    bool solve(const JobContext &job);
    double flipFreeStep(double limit) const;
    bool lineSearch(double before, const PatchLimits &limits, double slope, double &after);

    std::shared_ptr<const SeamGraph> mGraph;
    std::vector<int> mTriangles;
    std::vector<int> mLocal;            //!< per triangle of the mesh: index in mTriangles, -1 outside
    std::vector<TriangleBlock> mBlocks; //!< of mTriangles
    std::vector<int> mPoint;            //!< per local corner: its point
    //! Per local side, which has the number of its first corner: the local side across its edge. apart: there
    //! is none; outside: it is not in the patch.
    std::vector<int> mAcross;
    static constexpr int apart = -1, outside = -2;
    std::vector<double> mPosition; //!< per point: u, v in solver units
    bool mNumbered = false;        //!< mUnknown holds rows
    std::vector<int> mUnknown; //!< per point: its block row in mSystem; -1 when held, before numbering too
    std::vector<int> mPointVertex;           //!< per point: vertex of the uncut surface
    std::vector<int> mPlace;                 //!< per local side: of the block of its ends in mSystem, or -1
    std::vector<std::pair<int, int>> mLower; //!< scratch
    struct Spring
    {
        int a, b;      //!< points
        int place;     //!< of the block in mSystem, -1 when a or b is held
        double weight; //!< length of the edge, solver units
    };
    std::vector<Spring> mSprings;
    double mStiffness = 0;
    BlockCholesky mSystem;
    std::vector<double> mGradient, mDirection, mTrial;
    mutable std::vector<double> mEnergies; //!< scratch
    std::vector<char> mFrozen;             //!< per unknown: held during this step because of a crossing
    Segments mSegments;
    bool mSegmentsKnown = false;
    bool mCoversCharts = false; //!< the patch is made of whole charts
    const CutState *mState = nullptr;
    int mSteps = 0;
    long long mWork = 0;
};

} // namespace autocuts::search
