// Guided local search: islands may overlap for a while and are moved to where they overlap least.
#pragma once

#include "solver/base/random.h"
#include "solver/packing/distancefield.h"

namespace autocuts::packing {

//! Overlap of two islands = sum, over sample points of either, of how deep they are inside the other one
//! grown by the gutter. Every pair has a weight that grows while the pair overlaps, so that the search leaves
//! local minima (Umetani et al. 2009; Gardeyn and Wauters 2025).
class Separation
{
public:
    //! \param scale near which the search will work
    Separation(const PackProblem &problem, double scale, WorkMeter &work);

    //! Takes this layout as the state of the search, less what sticks out of the bin, and forgets the
    //! weights. \return false when an island is too large for the bin
    bool start(const Layout &layout, WorkMeter &work);
    //! Moves every overlapping island once, then raises the weights of the pairs that still overlap.
    void pass(Random &random, WorkMeter &work);

    const Layout &layout() const { return mLayout; }
    double overlap() const { return mTotal; }   //!< sum over all pairs, UV units
    double deepest() const { return mDeepest; } //!< largest depth of a sample point, UV units

private:
    //! Sample points that lie near each other.
    struct Cluster
    {
        Vec2 centre;
        double radius;
        int begin, end;
    };
    struct Body
    {
        DistanceField field;
        std::vector<Vec2> samples;
        std::vector<Cluster> clusters;
    };
    //! Cost of a pose with its derivatives.
    struct Evaluation
    {
        double cost = 0;
        Vec2 byPosition = Vec2::Zero();
        double byAngle = 0;
    };
    struct Depth
    {
        double sum = 0, deepest = 0;
    };

    //! A pose with its sine and cosine.
    struct Frame
    {
        double c, s, x, y, scale, angle;
    };

    Frame frameOf(int body, const Pose &pose) const;
    template <class Visit>
    void visitDeepPoints(int points, const Frame &from, int field, const Frame &to, double &operations,
                         Visit visit) const;
    Depth pairDepth(int i, const Frame &frame, int j, double &operations) const;
    template <class Visit>
    void visitNeighbours(int body, const Frame &frame, Visit visit) const;
    double cost(int body, const Pose &pose, double limit, WorkMeter &work) const;
    Evaluation evaluate(int body, const Pose &pose, WorkMeter &work) const;
    double descend(int body, Pose &pose, double cost, int steps, WorkMeter &work) const;
    bool confine(int body, Pose &pose) const;
    bool confineByTurning(int body, Pose &pose, double largestTurn) const;
    Pose randomPose(int body, Random &random) const;
    void moveBody(int body, Random &random, WorkMeter &work);
    void setPair(int i, int j, const Depth &depth);
    void updateRow(int body, WorkMeter &work);
    void updateTotals();
    std::size_t index(int i, int j) const { return static_cast<std::size_t>(i) * mProblem.count() + j; }

    const PackProblem &mProblem;
    Layout mLayout;
    std::vector<Body> mBodies;
    std::vector<Frame> mFrames;                    //!< of mLayout
    std::vector<double> mRadius;                   //!< UV units, at the layout's scale
    std::vector<float> mWeights, mOverlap, mDepth; //!< symmetric, one entry per pair of islands
    double mTotal = 0, mDeepest = 0;
};

} // namespace autocuts::packing
