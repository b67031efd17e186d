// A multifrontal Cholesky solver in single precision for matrices of 2 x 2 blocks: preconditioners.
#pragma once

#include "solver/base/lanes.h"
#include "solver/base/parallel.h"
#include "solver/linear/frontalstructure.h"
#include "solver/linear/frontkernels.h"
#include "solver/linear/linearsolver.h"

#include <vector>

namespace autocuts::linear {

//! Faster than a general library where fronts are small, as on meshes: supernodes of about sixteen nodes,
//! explicit inverses of their pivot blocks (so that solving is products of dense matrices and vectors),
//! single precision (what is read most as floats cut to 16 bits: solving is bound by memory), independent
//! subtrees on several threads. Residuals of about 1e-3 are usual: not for exact solutions. \pre the pattern
//! is made of full 2 x 2 blocks (their lower triangles on the diagonal)
class FrontalSolver final : public LinearSolver
{
public:
    explicit FrontalSolver(ThreadTeam &team) : mTeam(team) {}

    //! The caller has to bring the unknowns in order: only Order::Natural is known.
    //! \throws std::invalid_argument for another order or pattern
    void analyze(const Matrix &lower, Order order) override;
    bool factorize(const Matrix &lower) override;
    void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override;

private:
    using Floats = LaneVector;   //!< aligned storage
    using Packed = std::int32_t; //!< see packFront()

    //! Where a supernode's parts lie, in floats.
    struct Layout
    {
        int pivots = 0, pivotStride = 0; //!< scalars; padded
        int rows = 0, stride = 0;        //!< scalars; padded as rows of T
        int updateStride = 0;
        std::size_t inverse = 0;  //!< in mInverse: of the pivots, W
        std::size_t coupling = 0; //!< in mCoupling: T = W B, packed
    };
    //! A run of supernodes that makes up one or some whole subtrees, worked on by one thread.
    struct Task
    {
        int begin = 0, end = 0;
    };
    //! What one thread needs at a time.
    struct Scratch
    {
        Floats coupling, solved;   //!< B of a front, and T = W B
        std::vector<Floats> spare; //!< memory of update matrices that have been taken
        Floats row;                //!< as long as the longest row of T
        Floats outside;            //!< what solving passes on to the nodes of mTop
    };

    void makeTasks();
    void makeFronts();
    bool eliminate(const Matrix &lower, int node, Scratch &scratch);
    void addEntries(const Matrix &lower, int node, float *coupling);
    void addChild(int child, int node, bool eliminated, float *coupling);

    static float *flat(Floats &v) { return reinterpret_cast<float *>(v.data()); }
    static const float *flat(const Floats &v) { return reinterpret_cast<const float *>(v.data()); }

    ThreadTeam &mTeam;
    FrontalStructure mStructure;
    std::vector<Layout> mLayout;
    std::vector<Scratch> mScratch; //!< per task, and one for mTop
    std::vector<Task> mTasks;
    std::vector<int> mTop;       //!< supernodes above all tasks, ascending
    std::vector<Floats> mUpdate; //!< per supernode, its update matrix until its parent takes it
    Floats mInverse;
    std::vector<Packed, LaneAllocator<Packed>> mCoupling;
    std::vector<PackedFront> mFronts; //!< per supernode
    std::vector<PackedFront> mTopFronts;
    std::vector<int> mTopNodes; //!< eliminated by mTop
    std::vector<int> mOutside;  //!< places in mTopNodes of rows outside the own task
    std::vector<float> mValues; //!< right-hand side, then solution, in the new numbers
    float mSmallest = 0;
    bool mPrefetch = false; //!< the factor is larger than near caches
};

} // namespace autocuts::linear
