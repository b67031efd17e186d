// Guided local search: resolves a layout with overlapping islands by moving them to where they overlap least.
#pragma once

#include "solver/base/random.h"
#include "solver/packing/distancefield.h"

namespace autocuts::packing {

//! The overlap of two islands is the sum, over the sample points of both, of the depth in the other island
//! grown by the gutter. Every pair has a weight that grows while the pair overlaps, so that the search leaves
//! local minima (Umetani et al. 2009; Gardeyn and Wauters 2025).
class Separation
{
public:
    //! \param scale the scale at which the search will work, roughly; sets the spacing of grids and samples
    Separation(const PackProblem &problem, double scale, WorkMeter &work);

    //! Starts from this layout, with islands moved into the bin, and resets the weights.
    //! \return false when an island is too large for the bin
    bool start(const Layout &layout, WorkMeter &work);
    //! Tries to move every overlapping island once, then raises the weights of the pairs that still overlap.
    void pass(Random &random, WorkMeter &work);

    const Layout &layout() const { return mLayout; }
    double overlap() const { return mTotal; }   //!< sum of depths over all pairs, without weights, UV units
    double deepest() const { return mDeepest; } //!< largest depth of a sample point, UV units

private:
    //! Sample points that lie near each other and are rejected together.
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
    //! Weighted overlap of an island in a pose, with its derivatives.
    struct Evaluation
    {
        double cost = 0;
        Vec2 byPosition = Vec2::Zero();
        double byAngle = 0;
    };
    //! Depth of the sample points of a pair, UV units.
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
    std::vector<Frame> mFrames;                    //!< per island: its pose in mLayout
    std::vector<double> mRadius;                   //!< UV units, at the layout's scale
    std::vector<float> mWeights, mOverlap, mDepth; //!< symmetric, one entry per ordered pair, see index()
    double mTotal = 0, mDeepest = 0;
};

} // namespace autocuts::packing
