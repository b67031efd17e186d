// Interface of the sparse symmetric positive definite solvers.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace autocuts::linear {

//! Solves A x = b for a sparse symmetric positive definite A, given by its lower triangle. Call analyze()
//! once per pattern, factorize() for each set of values, then solve().
class LinearSolver
{
public:
    using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

    virtual ~LinearSolver() = default;

    enum class Order { FillReducing, Natural }; //!< Natural: the caller has ordered the unknowns

    //! Orders the unknowns and factorises the pattern of `lower` symbolically.
    //! \throws std::runtime_error when the library fails (out of memory)
    virtual void analyze(const Matrix &lower, Order order) = 0;
    //! Factorises numerically.
    //! \return false when the matrix is not positive definite
    //! \pre `lower` has the pattern of analyze()
    virtual bool factorize(const Matrix &lower) = 0;
    //! \pre factorize() returned true
    virtual void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) = 0;
};

} // namespace autocuts::linear
