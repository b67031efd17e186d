// The library CHOLMOD behind the LinearSolver interface.
#pragma once

#include "solver/linear/linearsolver.h"

#include <memory>
#include <vector>

namespace autocuts::linear {

//! Cholesky factorisation by CHOLMOD, which chooses between its supernodal and its simplicial method by the
//! fill.
class CholmodSolver final : public LinearSolver
{
public:
    CholmodSolver();
    ~CholmodSolver() override;
    CholmodSolver(const CholmodSolver &) = delete;
    CholmodSolver &operator=(const CholmodSolver &) = delete;

    void analyze(const Matrix &lower, Order order) override;
    bool factorize(const Matrix &lower) override;
    void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override;

private:
    struct Internals;
    std::unique_ptr<Internals> mInternals;
};

//! Order of elimination that keeps the fill of a Cholesky factor low (approximate minimum degree).
//! \param lower lower triangle of a symmetric pattern
//! \returns the position of each row in that order
std::vector<int> eliminationRanks(const LinearSolver::Matrix &lower);

} // namespace autocuts::linear
