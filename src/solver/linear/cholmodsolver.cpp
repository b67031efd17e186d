#include "solver/linear/cholmodsolver.h"

#include "solver/linear/loadedfunction.h"

#include <cholmod.h>
#include <omp.h>

#include <mutex>
#include <stdexcept>

namespace autocuts::linear {

struct CholmodSolver::Internals
{
    cholmod_common common;
    cholmod_factor *factor = nullptr;
    cholmod_dense *work1 = nullptr, *work2 = nullptr, *solution = nullptr;

    Internals()
    {
        cholmod_start(&common);
        common.print = 0;
        common.nmethods = 1;
        common.postorder = 1;
        common.quick_return_if_not_posdef = 1;
    }
    ~Internals()
    {
        clear();
        cholmod_finish(&common);
    }
    void clear()
    {
        cholmod_free_factor(&factor, &common);
        cholmod_free_dense(&work1, &common);
        cholmod_free_dense(&work2, &common);
        cholmod_free_dense(&solution, &common);
    }
};

namespace {

//! The BLAS that CHOLMOD uses. Any BLAS may be installed; OpenBLAS needs special care.
class Blas
{
public:
    Blas()
    {
        if (const auto setThreads = function<void(int)>("openblas_set_num_threads"))
            setThreads(1);
        // Ends its worker threads, which would otherwise poll for work that never comes.
        if (const auto endThreads = function<int()>("blas_thread_shutdown_"))
            endThreads();
        // OpenBLAS built without threads does not lock its buffers: two threads that call it get wrong
        // numbers.
        if (const auto parallel = function<int()>("openblas_get_parallel"))
            mThreadSafe = parallel() != 0;
    }

    bool isThreadSafe() const { return mThreadSafe; }

private:
    template <class F>
    static F *function(const char *name)
    {
        return reinterpret_cast<F *>(loadedFunction(name));
    }

    bool mThreadSafe = true;
};

//! While it lives, CHOLMOD runs on the calling thread only: otherwise it asks OpenMP for four threads in
//! loops that are far too small for them, and results must not depend on the number of cores. Where the BLAS
//! is not thread-safe, only one thread at a time may have a SerialRegion.
class SerialRegion
{
public:
    SerialRegion() : mLock(mutex(), std::defer_lock)
    {
        static const Blas blas;
        omp_set_max_active_levels(0);
        if (!blas.isThreadSafe())
            mLock.lock();
    }

private:
    static std::mutex &mutex()
    {
        static std::mutex single;
        return single;
    }

    std::unique_lock<std::mutex> mLock;
};

cholmod_sparse viewOf(const LinearSolver::Matrix &lower)
{
    cholmod_sparse view{};
    view.nrow = static_cast<std::size_t>(lower.rows());
    view.ncol = static_cast<std::size_t>(lower.cols());
    view.nzmax = static_cast<std::size_t>(lower.nonZeros());
    view.p = const_cast<int *>(lower.outerIndexPtr());
    view.i = const_cast<int *>(lower.innerIndexPtr());
    view.x = const_cast<double *>(lower.valuePtr());
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
}

} // namespace

CholmodSolver::CholmodSolver() : mInternals(std::make_unique<Internals>()) {}

CholmodSolver::~CholmodSolver() = default;

void CholmodSolver::analyze(const Matrix &lower, Order order)
{
    const SerialRegion serial;
    Internals &in = *mInternals;
    in.clear();
    in.common.method[0].ordering = order == Order::Natural ? CHOLMOD_NATURAL : CHOLMOD_AMD;
    cholmod_sparse view = viewOf(lower);
    in.factor = cholmod_analyze(&view, &in.common);
    if (!in.factor)
        throw std::runtime_error("there is not enough memory for the solver");
}

bool CholmodSolver::factorize(const Matrix &lower)
{
    const SerialRegion serial;
    Internals &in = *mInternals;
    cholmod_sparse view = viewOf(lower);
    cholmod_factorize(&view, in.factor, &in.common);
    if (in.common.status == CHOLMOD_OUT_OF_MEMORY)
        throw std::runtime_error("there is not enough memory for the solver");
    return in.common.status == CHOLMOD_OK;
}

void CholmodSolver::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
{
    const SerialRegion serial;
    Internals &in = *mInternals;
    cholmod_dense view{};
    view.nrow = view.d = view.nzmax = static_cast<std::size_t>(b.size());
    view.ncol = 1;
    view.x = const_cast<double *>(b.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(CHOLMOD_A, in.factor, &view, nullptr, &in.solution, nullptr, &in.work1, &in.work2,
                        &in.common))
        throw std::runtime_error("a linear system could not be solved");
    x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double *>(in.solution->x), b.size());
}

std::vector<int> eliminationRanks(const LinearSolver::Matrix &lower)
{
    const SerialRegion serial;
    cholmod_common common;
    cholmod_start(&common);
    common.print = 0;
    cholmod_sparse view = viewOf(lower);
    std::vector<int> order(lower.rows());
    const int ok = cholmod_amd(&view, nullptr, 0, order.data(), &common);
    cholmod_finish(&common);
    if (!ok)
        throw std::runtime_error("there is not enough memory for the solver");
    std::vector<int> rank(order.size());
    for (std::size_t place = 0; place < order.size(); ++place)
        rank[order[place]] = static_cast<int>(place);
    return rank;
}

} // namespace autocuts::linear
