// Multifrontal Cholesky factorisation in single precision of matrices of 2 x 2 blocks, for preconditioners.
#pragma once

#include "model/plain/parallel.h"
#include "solver/base/lanes.h"
#include "solver/linear/frontalstructure.h"
#include "solver/linear/frontkernels.h"
#include "solver/linear/linearsolver.h"

#include <vector>

namespace autocuts::linear {

//! Faster than a general library where fronts are small, as they are on meshes: supernodes of about sixteen
//! nodes; explicit inverses of their pivot blocks, so that solving consists of dense matrix-vector products;
//! single precision, with the largest array cut to 16 bits per entry because solving is bound by memory;
//! independent subtrees on several threads. On the hub matrix of 5,800 triangles such a solver took 0.9 ms to
//! factorise and 0.05 ms to solve, CHOLMOD 6.5 to 7.4 ms and 0.25 ms. Relative residuals of about 1e-3 are
//! usual: not for exact solutions.
//! \pre the pattern consists of full 2 x 2 blocks (of their lower triangles on the diagonal)
class FrontalSolver final : public LinearSolver
{
public:
    explicit FrontalSolver(ThreadTeam &team) : mTeam(team) {}

    //! The caller has to order the unknowns: only Order::Natural is supported.
    //! \throws std::invalid_argument for another order or pattern
    void analyze(const Matrix &lower, Order order) override;
    bool factorize(const Matrix &lower) override;
    void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override;

private:
    using Floats = LaneVector;   //!< aligned storage
    using Packed = std::int32_t; //!< see packFront()

    //! Positions of a supernode's matrices, in floats.
    struct Layout
    {
        int pivots = 0, pivotStride = 0; //!< scalars; padded
        int rows = 0, stride = 0;        //!< scalars; padded as rows of T
        int updateStride = 0;
        std::size_t inverse = 0;  //!< in mInverse: of the pivots, W
        std::size_t coupling = 0; //!< in mCoupling: T = W B, packed
    };
    //! Consecutive supernodes that form one or more whole subtrees; one thread works on them.
    struct Task
    {
        int begin = 0, end = 0;
    };
    //! Working memory of one thread.
    struct Scratch
    {
        Floats coupling, solved;   //!< B of a front, and T = W B
        std::vector<Floats> spare; //!< memory of update matrices that are no longer needed
        Floats row;                //!< as long as the longest row of T
        Floats outside;            //!< contributions of a solve to the nodes of mTop
    };

    void makeTasks();
    void makeFronts();
    //! The memory of the thread that eliminates this supernode.
    Scratch &scratchOf(int node);
    bool eliminate(const Matrix &lower, int node, Scratch &scratch);
    void addEntries(const Matrix &lower, int node, float *coupling);
    void addChild(int child, int node, bool eliminated, float *coupling);

    static float *flat(Floats &v) { return reinterpret_cast<float *>(v.data()); }
    static const float *flat(const Floats &v) { return reinterpret_cast<const float *>(v.data()); }

    ThreadTeam &mTeam;
    FrontalStructure mStructure;
    std::vector<Layout> mLayout;
    std::vector<Scratch> mScratch; //!< per task; the last one is for mTop
    std::vector<Task> mTasks;
    std::vector<int> mTop;       //!< supernodes above all tasks, ascending
    std::vector<Floats> mUpdate; //!< per supernode: its update matrix until its parent has added it
    Floats mInverse;
    std::vector<Packed, LaneAllocator<Packed>> mCoupling;
    std::vector<PackedFront> mFronts; //!< per supernode
    std::vector<PackedFront> mTopFronts;
    std::vector<int> mTopNodes; //!< nodes that the supernodes of mTop eliminate
    std::vector<int> mOutside;  //!< positions in mTopNodes of rows outside the own task
    std::vector<float> mValues; //!< right-hand side, then solution, in the new numbers
    float mSmallest = 0;
    bool mPrefetch = false; //!< the factor is larger than the caches near the processor
};

} // namespace autocuts::linear
