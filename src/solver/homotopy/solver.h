// The live solver: cuts and distortion optimised together on the triangle soup (paper, section 3).
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

//! What one step did.
struct StepResult
{
    int iteration = 0;     //!< steps since load()
    double energy = 0;     //!< (1 - lambda) D + lambda S + pins + boxes, after the step
    double distortion = 0; //!< D: area-weighted mean of the distortion energy, 4 when isometric
    double separation = 0; //!< S: the smoothed seam length (solver units)
    double stepLength = 0; //!< 0: nothing left to gain
};

//! A stepper without threads: load() a snapshot, then step(); update() changes settings and steering between
//! two steps and keeps the map. Every triangle stays positively oriented after every step.
class Solver
{
public:
    Solver();
    ~Solver();

    //! Threads of one step; the result does not depend on it. To be called before load().
    void setThreads(int threads);
    //! Starts from the snapshot's start mode. \throws std::invalid_argument on a mesh without area
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
    //! s_delta of a corner pair: 0 joined, near 1 cut.
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

//! Smallest delta that the homotopy needs: the square of 0.3 mean edge lengths, or of half a short edge (the
//! fifth percentile) where the mesh is graded. Below it nothing merges any more; above it, joining pairs
//! would fold triangles.
double finalDelta(const Soup &soup);

} // namespace autocuts::homotopy
