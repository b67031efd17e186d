// The solver of the paper (section 3): optimises cuts and distortion together on the triangle soup.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/soup.h"
#include "solver/energy/constraintterms.h"
#include "solver/energy/distortion.h"
#include "solver/energy/separation.h"
#include "solver/newton/minimizer.h"

#include <memory>
#include <vector>

namespace autocuts::homotopy {

//! Result of one step.
struct StepResult
{
    int iteration = 0;     //!< steps since load()
    double energy = 0;     //!< (1 - lambda) D + lambda S + pins + boxes, after the step
    double distortion = 0; //!< D: area-weighted mean of the distortion density; 4 when isometric
    double separation = 0; //!< S: smoothed seam length, solver units
    double stepLength = 0; //!< 0: no descent was found
};

//! Takes one step at a time in the thread of the caller: load() a snapshot, then step(). update() changes
//! settings and steering between two steps and keeps the map. After every step every triangle is positively
//! oriented.
class Solver
{
public:
    Solver();
    ~Solver();

    //! Number of threads of one step; the result does not depend on it. To be called before load().
    void setThreads(int threads);
    //! Starts from the snapshot's start mode.
    //! \throws std::invalid_argument on a mesh without area
    void load(const Snapshot &snapshot);
    //! \pre load() was called with the same mesh
    void update(const Snapshot &snapshot);
    StepResult step();

    const Soup &soup() const { return *mSoup; }
    std::shared_ptr<const Soup> sharedSoup() const { return mSoup; }
    const Snapshot &snapshot() const { return mSnapshot; }
    //! Coordinates in solver units, see Soup.
    const std::vector<double> &coordinates() const { return mX; }
    //! \pre every triangle is positively oriented at x
    void setCoordinates(std::vector<double> x);
    //! s_delta of a corner pair: 0 when it coincides, near 1 when far apart.
    double separation(int pair) const { return mSeparation->separation(mX, pair); }

private:
    void rebuildTerms();
    void setBalance();
    void pullHardPins();
    template <class Term>
    double unweighted(Term &term) const;

    std::unique_ptr<ThreadTeam> mTeam;
    Snapshot mSnapshot;
    std::shared_ptr<const Soup> mSoup;
    std::unique_ptr<energy::DistortionTerm> mDistortion;
    std::unique_ptr<energy::SeparationTerm> mSeparation;
    std::unique_ptr<energy::PinTerm> mPins;
    std::unique_ptr<energy::BoxTerm> mBoxes;
    std::unique_ptr<newton::Minimizer> mMinimizer;
    std::vector<double> mX;
    std::vector<Pin> mHardPins;
    int mIteration = 0;
};

//! Smallest delta of the homotopy: the square of 0.3 mean edge lengths, or, if less, of half the fifth
//! percentile of the edge lengths (for graded meshes). Below it nothing merges any more; above it, stitching
//! would flip triangles. 0.3 was found on the first meshes, docs/constants.md (with deltas that did not scale
//! with the square of the edge length, stitching fine meshes flipped thousands of triangles); one half and
//! the percentile were chosen by hand.
double finalDelta(const Soup &soup);

} // namespace autocuts::homotopy
