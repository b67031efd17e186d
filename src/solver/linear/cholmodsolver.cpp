#include "solver/linear/cholmodsolver.h"

#include <cholmod.h>

#include <stdexcept>

namespace autocuts {

struct CholmodSolver::Internals
{
    cholmod_common common;
    cholmod_factor *factor = nullptr;
    cholmod_dense *work1 = nullptr, *work2 = nullptr, *solution = nullptr;

    Internals()
    {
        cholmod_start(&common);
        common.print = 0;
        // One order, found fast; nested dissection only pays on large problems, where CHOLMOD tries it too.
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_AMD;
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

void CholmodSolver::analyze(const Matrix &lower)
{
    Internals &in = *mInternals;
    in.clear();
    cholmod_sparse view = viewOf(lower);
    in.factor = cholmod_analyze(&view, &in.common);
    if (!in.factor)
        throw std::runtime_error("CholmodSolver: the symbolic factorisation failed, out of memory");
}

bool CholmodSolver::factorize(const Matrix &lower)
{
    Internals &in = *mInternals;
    cholmod_sparse view = viewOf(lower);
    cholmod_factorize(&view, in.factor, &in.common);
    if (in.common.status == CHOLMOD_OUT_OF_MEMORY)
        throw std::runtime_error("CholmodSolver: out of memory");
    return in.common.status == CHOLMOD_OK;
}

void CholmodSolver::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
{
    Internals &in = *mInternals;
    cholmod_dense view{};
    view.nrow = view.d = view.nzmax = static_cast<std::size_t>(b.size());
    view.ncol = 1;
    view.x = const_cast<double *>(b.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(CHOLMOD_A, in.factor, &view, nullptr, &in.solution, nullptr, &in.work1, &in.work2,
                        &in.common))
        throw std::runtime_error("CholmodSolver: the solve failed");
    x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double *>(in.solution->x), b.size());
}

} // namespace autocuts
