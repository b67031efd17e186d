// The part of a map that one trial may move, and Newton's method on it.
#pragma once

#include "solver/search/blockcholesky.h"
#include "solver/search/cutstate.h"
#include "solver/search/segments.h"

#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace autocuts::search {

//! How far Patch::minimize() goes.
struct PatchLimits
{
    int steps = 6;
    double tolerance = 1e-6; //!< stop when a step promises less
    //! Give up when even twice the promise of the quadratic model leaves the energy above this.
    double hopeless = std::numeric_limits<double>::infinity();
    bool guarded = false; //!< no step may make boundary sides cross
};

//! Some triangles whose points may move while everything around them is held. Works on a copy of the
//! coordinates until store(). Keeps its memory between uses; one per thread.
class Patch
{
public:
    explicit Patch(std::shared_ptr<const SeamGraph> graph);

    //! Takes the triangles around `seeds`, nearest first, over the uncut sides, about `size` of them.
    void select(const CutState &state, std::span<const int> seeds, int size);
    const std::vector<int> &triangles() const { return mTriangles; }
    //! Place of a triangle among triangles(), -1 outside.
    int localOf(int triangle) const { return mLocal[triangle]; }

    //! Finds the points of the patch as the flags of the state have it. Corners that share a point are put at
    //! their mean, or where the surroundings hold them. False when these hold one point at two places.
    //! \param x coordinates to start from, as in the state
    bool join(const CutState &state, const std::vector<double> &x);
    //! Moves the points on freshly opened edges a little into their own side, so that no two of them
    //! coincide.
    void partSides(const std::vector<int> &edges);
    //! Springs that pull the two sides of edges together until they can be closed.
    void addSprings(const std::vector<int> &edges);
    void setStiffness(double stiffness) { mStiffness = stiffness; }

    //! Weighted energy of the patch without the springs; infinite when a triangle is turned over.
    double energy() const { return energyAt(mPosition); }
    //! Smallest determinant of the Jacobians.
    double smallestDeterminant() const;
    //! Newton steps; returns the number of steps taken. \pre energy() is finite
    int minimize(const PatchLimits &limits);
    //! True when boundary sides cross, among those of the patch and with those of the state outside of it.
    bool crossesItself();
    //! Writes the coordinates of the patch.
    void store(std::vector<double> &x) const;
    //! Writes coordinates and energies, and updates the energy of the state.
    void commit(CutState &state) const;

    //! Triangles times steps since the beginning: a measure of time that is the same everywhere.
    double work() const { return mWork; }
    //! Newton steps since the beginning.
    int steps() const { return mSteps; }

private:
    void setTriangles(const std::vector<int> &triangles);
    void mergeCorners(const CutState &state);
    void numberUnknowns();
    double energyAt(const std::vector<double> &position) const;
    double springEnergy(const std::vector<double> &position) const;
    void assemble();
    void assembleTriangles();
    void assembleSprings();
    bool solve();
    double flipFreeStep(double limit) const;
    bool lineSearch(double before, const PatchLimits &limits, double slope, double &after);

    std::shared_ptr<const SeamGraph> mGraph;
    std::vector<int> mTriangles;
    std::vector<int> mLocal;                 //!< per triangle of the mesh, -1 outside
    std::vector<int> mPoint;                 //!< per local corner: point
    std::vector<int> mParent;                //!< union-find over local corners
    std::vector<double> mPosition;           //!< per point
    std::vector<int> mUnknown;               //!< per point, -1 held
    std::vector<int> mPointVertex;           //!< per point, point of the surface
    std::vector<std::array<int, 3>> mPlace;  //!< per local triangle: blocks (1,0), (2,0), (2,1)
    std::vector<std::pair<int, int>> mLower; //!< scratch
    struct Spring
    {
        int a, b; //!< points
        int place;
        double weight;
    };
    std::vector<Spring> mSprings;
    double mStiffness = 0;
    BlockCholesky mSystem;
    std::vector<double> mGradient, mDirection, mTrial;
    std::vector<char> mFrozen; //!< per unknown: stands still because of a contact
    Segments mSegments;
    bool mSegmentsKnown = false;
    const CutState *mState = nullptr;
    double mWork = 0;
    int mSteps = 0;
};

} // namespace autocuts::search
