// Truncated Newton directions: conjugate gradients with the hub preconditioner.
//
// Near a solution most corners of one mesh vertex (almost) coincide, tied by a ring of stiff springs. The
// preconditioner ties each such group of corners to one auxiliary point, its *hub*, by a spring k_c per
// corner:
//
//     M = [ S  -D ]    S = per triangle, 6 x 6: distortion + diag(k + ground),   D = diag(k)
//         [ -D  B ]    B = diagonal of the hubs (sum of k) + springs between hubs
//
// Eliminating the corners leaves the hub matrix A = B - sum over triangles of D S^-1 D with two unknowns per
// hub, six times fewer than the soup has. z = M^-1 r is computed as y = S^-1 r,
// A u = sum of k y, z = y + S^-1 D u. S is refreshed at every call. A and the grouping are kept until the
// iterations become slow: any symmetric positive definite A gives a valid preconditioner.
#include "solver/base/constant.h"
#include "solver/linear/cholmodsolver.h"
#include "solver/linear/frontalsolver.h"
#include "solver/newton/hubgroups.h"
#include "solver/newton/hubkernels.h"
#include "solver/newton/newtondirection.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace autocuts::newton {

namespace {

// Numbers in this file without another source were chosen by hand.

//! The iterations end when the residual is below this share of the gradient, which takes 2 to 4 of them.
//! Measured on the first meshes (docs/constants.md): for equal numbers of steps slightly worse than exact
//! Newton; with 13 to 20 steps per delta better, and still 11 to 26 times cheaper.
AUTOCUTS_CONSTANT(double, residualTolerance, 0.3);
constexpr int maxIterations = 60; // a guard
//! From iteration `lateIteration` on, the iterations also end when the last one lowered the quadratic model
//! by less than this share of the average (after Nash and Sofer 1990): the residual may stay long where
//! little is left to gain.
constexpr double leastGain = 0.4;
constexpr int lateIteration = 6;
//! The hub matrix is factorised again once the iterations, summed over the calls since the last time, exceed
//! those of a fresh factor by this number. On the first meshes 18 was best. On large meshes an iteration is
//! dearer against a factorisation, because the data no longer fits into the caches: there the optimum was
//! measured at 8, from 100,000 triangles on.
constexpr int excessBeforeRefresh = 18;
constexpr int excessBeforeRefreshLarge = 8;
constexpr int largeTriangleCount = 100000;

//! Position of each welded mesh vertex in an order that keeps the fill of the hub matrix low.
std::vector<int> vertexRanks(const MeshData &mesh)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(3 * static_cast<std::size_t>(mesh.triangleCount()) + mesh.vertexCount());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.vertexOfSoup(3 * t + k);
            const int b = mesh.vertexOfSoup(3 * t + (k + 1) % 3);
            entries.emplace_back(std::max(a, b), std::min(a, b), 1.0);
        }
    }
    for (int v = 0; v < mesh.vertexCount(); ++v)
        entries.emplace_back(v, v, 1.0);
    linear::LinearSolver::Matrix graph(mesh.vertexCount(), mesh.vertexCount());
    graph.setFromTriplets(entries.begin(), entries.end());
    return linear::eliminationRanks(graph);
}

//! Number of blocks of eight triangles in one job.
constexpr int blocksPerJob = jobSize / laneCount;

class HubDirection final : public NewtonDirection
{
public:
    HubDirection(std::shared_ptr<const Soup> soup, std::vector<bool> held, ThreadTeam *team, HubFactor factor)
        : mSoup(std::move(soup)), mTeam(team ? team : &mAlone), mRank(vertexRanks(*mSoup->mesh)),
          mFactor(factor), mFrontal(*mTeam)
    {
        const int triangles = mSoup->triangleCount();
        mExcessLimit = triangles > largeTriangleCount ? excessBeforeRefreshLarge : excessBeforeRefresh;
        mBlocks = (triangles + laneCount - 1) / laneCount;
        mSprings.resize(mBlocks);
        mInverses.resize(mBlocks);
        for (auto *vector : {&mResidual, &mSearch, &mProduct, &mSum})
            vector->assign(6 * static_cast<std::size_t>(mBlocks), Lanes{});
        linkCorners();
        if (!held.empty()) {
            mMovable.assign(6 * static_cast<std::size_t>(mBlocks), Lanes{} + 1);
            for (std::size_t c = 0; c < held.size(); ++c) {
                if (held[c])
                    flat(mMovable)[slotOf(static_cast<int>(c))] =
                        flat(mMovable)[slotOf(static_cast<int>(c)) + 1] = 0;
            }
        }
    }

    energy::HessianBlocks::Precision precision() const override
    {
        return energy::HessianBlocks::Precision::Single;
    }

    void invalidate() override { mFresh = false; }

    void compute(energy::HessianBlocks &blocks, std::span<const double> gradient,
                 std::span<double> direction) override
    {
        if (!mFresh || mExcess >= mExcessLimit)
            refresh(blocks);
        else
            prepare(blocks);
        int iterations = conjugateGradients(blocks.lanes, gradient, direction);
        if (iterations >= maxIterations && mExcess > 0) {
            mExcess = mExcessLimit;
            return;
        }
        if (mBaseline < 0)
            mBaseline = iterations;
        mExcess += std::max(0, iterations - mBaseline);
    }

private:
    static float *flat(LaneVector &v) { return reinterpret_cast<float *>(v.data()); }
    const Lanes *movable() const { return mMovable.empty() ? nullptr : mMovable.data(); }
    const Lanes *ground() const { return mGround.empty() ? nullptr : mGround.data(); }

    template <class Job>
    void overBlocks(Job &&job)
    {
        mTeam->run((mBlocks + blocksPerJob - 1) / blocksPerJob,
                   [&](int i) { job(i * blocksPerJob, std::min(mBlocks, (i + 1) * blocksPerJob)); });
    }

    template <class Sum>
    double sumOverBlocks(Sum &&sum)
    {
        mParts.assign((mBlocks + blocksPerJob - 1) / blocksPerJob, 0.0);
        overBlocks([&](int first, int end) { mParts[first / blocksPerJob] = sum(first, end); });
        double total = 0;
        for (const double part : mParts)
            total += part;
        return total;
    }

    void linkCorners()
    {
        mLinks.partner.resize(mBlocks);
        mLinks.pair.resize(mBlocks);
        const int pairs = static_cast<int>(mSoup->pairCorners.size());
        for (int t = 0; t < mBlocks * laneCount; ++t) {
            for (int i = 0; i < 6; ++i) {
                const int corner = 3 * t + i / 2;
                int &partner = mLinks.partner[t / laneCount][i][t % laneCount];
                int &pair = mLinks.pair[t / laneCount][i][t % laneCount];
                partner = slotOf(corner);
                pair = pairs;
                if (t < mSoup->triangleCount() && mSoup->partners[corner].pair[i % 2] >= 0) {
                    partner = slotOf(mSoup->partners[corner].corner[i % 2]);
                    pair = mSoup->partners[corner].pair[i % 2];
                }
            }
        }
    }

    void refresh(energy::HessianBlocks &blocks)
    {
        if (mGroups.hub.empty() || !mGroups.stillFit(*mSoup, blocks)) {
            mGroups = HubGroups::build(*mSoup, blocks, mRank);
            mTeam->run(2, [&](int job) { job == 0 ? mMatrix.setPattern(*mSoup, mGroups) : linkHubs(); });
            mAnalyzed = false;
        }
        prepare(blocks);
        factorize(blocks);
        mFresh = true;
        mExcess = 0;
        mBaseline = -1;
    }

    void linkHubs()
    {
        std::vector<int> place(mGroups.corners.size());
        for (std::size_t i = 0; i < place.size(); ++i)
            place[mGroups.corners[i]] = static_cast<int>(i);
        mHubLinks.hub.resize(mBlocks);
        mHubLinks.place.resize(mBlocks);
        mHubLinks.kind.assign(mBlocks, {});
        for (int t = 0; t < mBlocks * laneCount; ++t) {
            const int block = t / laneCount, lane = t % laneCount;
            for (int k = 0; k < 3; ++k) {
                const int corner = 3 * t + k;
                const bool real = t < mSoup->triangleCount();
                const int hub = real ? mGroups.hub[corner] : -1;
                mHubLinks.hub[block][k][lane] = 2 * (hub >= 0 ? hub : mGroups.count);
                mHubLinks.place[block][k][lane] = 2 * (real ? place[corner] : corner);
                for (int side = 0; real && side < 2; ++side) {
                    const int partner = mSoup->partners[corner].corner[side];
                    if (partner < 0)
                        continue;
                    const int other = mGroups.hub[partner], bit = 1 << (2 * k + side);
                    mHubLinks.kind[block].within[lane] |= hub >= 0 && hub == other ? bit : 0;
                    mHubLinks.kind[block].holding[lane] |= hub < 0 || other < 0 ? bit : 0;
                }
            }
        }
        mLoads.assign(6 * static_cast<std::size_t>(mBlocks) * laneCount, 0.0f);
        mPulls.assign(2 * static_cast<std::size_t>(mGroups.count) + 2, 0.0f);
        mHubLoad.resize(2 * mGroups.count);
    }

    //! Computes the springs and S^-1 of every triangle.
    void prepare(const energy::HessianBlocks &blocks)
    {
        const int pairs = static_cast<int>(blocks.pair.size());
        mPairs.resize(blocks.pair.size() + 1);
        mTeam->run(jobCount(pairs), [&](int job) {
            for (int p = job * jobSize; p < std::min(pairs, (job + 1) * jobSize); ++p)
                mPairs[p] = static_cast<float>(blocks.pair[p]);
        });
        mPairs.back() = 0;
        mGround.clear();
        if (!blocks.ground.empty()) {
            mGround.resize(6 * static_cast<std::size_t>(mBlocks));
            toSlots(blocks.ground.data(), 1, mSoup->triangleCount(), mGround.data(), 0, mBlocks);
        }
        overBlocks([&](int first, int end) {
            prepareBlocks(blocks.lanes.data(), mLinks.pair.data(), mHubLinks.kind.data(), mPairs.data(),
                          ground(), movable(), mSprings.data(), mInverses.data(), first, end);
        });
    }

    void factorize(const energy::HessianBlocks &blocks)
    {
        if (mGroups.count == 0)
            return;
        const auto fill = [&] { mMatrix.fill(*mSoup, blocks, mGroups, mInverses); };
        if (mAnalyzed) {
            fill();
        } else {
            mSolver =
                mFactor == HubFactor::Frontal ? static_cast<linear::LinearSolver *>(&mFrontal) : &mGeneral;
            // Independent of each other: analyze() needs the pattern only, fill() writes the values.
            mTeam->run(2, [&](int job) {
                job == 0 ? mSolver->analyze(mMatrix.matrix(), linear::LinearSolver::Order::Natural) : fill();
            });
            mAnalyzed = true;
        }
        // Small relative to the mean diagonal entry; a hundred times more after each failure, with CHOLMOD
        // from the third attempt on.
        double shift = 1e-7 * mMatrix.matrix().diagonal().mean();
        for (int attempt = 0; attempt < 9; ++attempt, shift *= 100) {
            mMatrix.addToDiagonal(shift);
            if (mSolver->factorize(mMatrix.matrix()))
                return;
            if (attempt == 1) {
                // Too ill-conditioned for single precision: use CHOLMOD.
                mAnalyzed = false;
                mSolver = &mGeneral;
                mSolver->analyze(mMatrix.matrix(), linear::LinearSolver::Order::Natural);
            }
        }
        throw std::runtime_error(
            "the solver found no step: the mesh may mix very large and very small triangles");
    }

    //! First half of z = M^-1 r: computes the hubs' positions u.
    //! \return r . z
    double moveHubs()
    {
        double product = sumOverBlocks([&](int first, int end) {
            return loadHubs(mInverses.data(), mHubLinks.place.data(), mResidual.data(), mLoads.data(), first,
                            end);
        });
        if (mGroups.count == 0)
            return product;
        mTeam->run(jobCount(mGroups.count), [&](int job) {
            for (int h = job * jobSize; h < std::min(mGroups.count, (job + 1) * jobSize); ++h) {
                float u = 0, v = 0;
                for (int i = mGroups.begin[h]; i < mGroups.begin[h + 1]; ++i) {
                    u += mLoads[2 * static_cast<std::size_t>(i)];
                    v += mLoads[2 * static_cast<std::size_t>(i) + 1];
                }
                mHubLoad[2 * h] = u;
                mHubLoad[2 * h + 1] = v;
            }
        });
        mSolver->solve(mHubLoad, mHubMove);
        for (Eigen::Index i = 0; i < mHubMove.size(); ++i)
            mPulls[static_cast<std::size_t>(i)] = static_cast<float>(mHubMove[i]);
        return product + mHubLoad.dot(mHubMove);
    }

    //! Second half: p = z + beta p, after x += alpha p.
    void turnSearch(float alpha, float beta)
    {
        overBlocks([&](int first, int end) {
            pullCorners(mInverses.data(), mHubLinks.hub.data(), mResidual.data(), mPulls.data(), movable(),
                        alpha, beta, mSum.data(), mSearch.data(), first, end);
        });
    }

    //! \return the number of iterations
    int conjugateGradients(const std::vector<EdgeMatrix> &hessian, std::span<const double> gradient,
                           std::span<double> direction)
    {
        const double norm = loadResidual(gradient);
        if (norm == 0) {
            std::fill(direction.begin(), direction.end(), 0.0);
            return 0;
        }
        double rz = moveHubs(), gained = 0;
        turnSearch(0, 0);
        int iteration = 0;
        float alpha = 0;
        while (iteration < maxIterations && rz > 0) {
            const double curvature = sumOverBlocks([&](int first, int end) {
                return multiplyBlocks(hessian.data(), mSprings.data(), mLinks.partner.data(), mSearch.data(),
                                      ground(), movable(), mProduct.data(), first, end);
            });
            if (!(curvature > 0))
                break;
            alpha = static_cast<float>(rz / curvature);
            const double rest = sumOverBlocks([&](int first, int end) {
                return advanceBlocks(alpha, mProduct.data(), mResidual.data(), first, end);
            });
            ++iteration;
            const double gain = rz * alpha;
            gained += gain;
            if (rest < residualTolerance * residualTolerance ||
                (iteration >= lateIteration && iteration * gain < leastGain * gained))
                break;
            const double next = moveHubs();
            turnSearch(alpha, static_cast<float>(next / rz));
            alpha = 0;
            rz = next;
        }
        overBlocks([&](int first, int end) {
            fromSlots(mSum.data(), alpha, mSearch.data(), norm, mSoup->triangleCount(), direction.data(),
                      first, end);
        });
        return iteration;
    }

    //! Initial residual, scaled to unit length so that single precision is enough for gradients of any size.
    //! \return the length before scaling
    double loadResidual(std::span<const double> gradient)
    {
        const double squares = sumInOrder(mTeam, mSoup->triangleCount(), [&](int first, int end) {
            double sum = 0;
            for (std::size_t i = 6 * static_cast<std::size_t>(first); i < 6 * static_cast<std::size_t>(end);
                 ++i)
                sum += gradient[i] * gradient[i];
            return sum;
        });
        const double norm = std::sqrt(squares);
        if (norm == 0)
            return 0;
        const double scale = -1 / norm;
        overBlocks([&](int first, int end) {
            toSlots(gradient.data(), scale, mSoup->triangleCount(), mResidual.data(), first, end);
            if (movable()) {
                for (int i = 6 * first; i < 6 * end; ++i)
                    mResidual[i] *= mMovable[i];
            }
        });
        return norm;
    }

    std::shared_ptr<const Soup> mSoup;
    ThreadTeam mAlone, *mTeam;
    std::vector<int> mRank;
    int mBlocks = 0;

    bool mFresh = false;
    int mExcess = 0, mExcessLimit = 0, mBaseline = -1;
    HubGroups mGroups;
    HubMatrix mMatrix;
    HubFactor mFactor;
    linear::FrontalSolver mFrontal;
    linear::CholmodSolver mGeneral;
    linear::LinearSolver *mSolver = nullptr;
    bool mAnalyzed = false; //!< mSolver is the wanted solver and has analysed the pattern

    CornerLinks mLinks;
    HubLinks mHubLinks;
    std::vector<LinkSprings> mSprings;
    std::vector<BlockInverse> mInverses;
    std::vector<float> mPairs; //!< spring constant per corner pair, and a zero for borders
    LaneVector mMovable;       //!< 0 where a corner is held, else 1; empty when none is held
    LaneVector mGround;
    LaneVector mResidual, mSearch, mProduct, mSum;
    std::vector<float> mLoads; //!< load of every corner on its hub, ordered by hub
    std::vector<float> mPulls; //!< positions of the hubs, and one that does not move
    Eigen::VectorXd mHubLoad, mHubMove;
    std::vector<double> mParts;
};

} // namespace

std::unique_ptr<NewtonDirection> makeHubDirection(std::shared_ptr<const Soup> soup, std::vector<bool> held,
                                                  ThreadTeam *team, HubFactor factor)
{
    return std::make_unique<HubDirection>(std::move(soup), std::move(held), team, factor);
}

} // namespace autocuts::newton
