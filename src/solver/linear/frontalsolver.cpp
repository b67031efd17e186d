#include "solver/linear/frontalsolver.h"

#include "solver/linear/frontkernels.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

namespace autocuts::linear {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Subtrees are split until none has more than this share of the total work.
constexpr double largestTask = 1.0 / 12;
//! A pivot below this share of the mean diagonal means that the matrix is not positive definite.
constexpr float smallestPivot = 1e-9f;

//! How many supernodes ahead the factor is prefetched, and the number of floats above which it is prefetched
//! at all (smaller factors stay in the caches).
constexpr int prefetchDistance = 3;
constexpr std::size_t prefetchFrom = 1'000'000;

std::size_t lanesFor(std::size_t floats)
{
    return (floats + frontLanes - 1) / frontLanes;
}

bool isMadeOfBlocks(const LinearSolver::Matrix &lower)
{
    if (lower.rows() % 2 != 0)
        return false;
    const int *start = lower.outerIndexPtr(), *index = lower.innerIndexPtr();
    for (int j = 0; j < lower.cols(); j += 2) {
        const int length = start[j + 1] - start[j];
        if (length < 2 || length % 2 != 0 || start[j + 2] - start[j + 1] != length - 1)
            return false;
        for (int k = 0; k < length; ++k) {
            const int row = index[start[j] + k];
            if ((k % 2 == 0 && row % 2 != 0) || (k % 2 == 1 && row != index[start[j] + k - 1] + 1) ||
                (k > 0 && index[start[j + 1] + k - 1] != row) || (k == 0 && row != j))
                return false;
        }
    }
    return true;
}

} // namespace

void FrontalSolver::analyze(const Matrix &lower, Order order)
{
    if (order != Order::Natural || !isMadeOfBlocks(lower))
        throw std::invalid_argument("an ordered matrix of 2 x 2 blocks is needed");
    mStructure = FrontalStructure::build(lower);
    mLayout.clear();
    std::size_t inverse = 0, coupling = 0;
    for (const FrontalStructure::Supernode &node : mStructure.supernodes) {
        Layout l;
        l.pivots = 2 * node.count;
        l.pivotStride = paddedRow(l.pivots);
        l.rows = 2 * node.rowCount;
        l.stride = (l.rows + packedLanes - 1) / packedLanes * packedLanes;
        l.updateStride = paddedRow(l.rows);
        l.inverse = inverse;
        inverse += static_cast<std::size_t>(l.pivots) * l.pivotStride;
        l.coupling = coupling;
        coupling += static_cast<std::size_t>(l.pivots) * l.stride / 2;
        mLayout.push_back(l);
    }
    mInverse.resize(lanesFor(inverse));
    mCoupling.resize(coupling);
    mPrefetch = inverse + coupling > prefetchFrom;
    mUpdate.assign(mStructure.supernodes.size(), {});
    mValues.assign(2 * static_cast<std::size_t>(mStructure.nodeCount), 0);
    makeTasks();
    makeFronts();
}

void FrontalSolver::makeTasks()
{
    const int count = static_cast<int>(mStructure.supernodes.size());
    std::vector<double> work(count);
    std::vector<int> firstBelow(count);
    for (int n = 0; n < count; ++n) {
        const Layout &l = mLayout[n];
        work[n] = double(l.pivots) * (l.pivots + l.rows) * (l.pivots + l.rows) + 1000;
        firstBelow[n] = n;
        for (int c = mStructure.childBegin[n]; c < mStructure.childBegin[n + 1]; ++c) {
            work[n] += work[mStructure.children[c]];
            firstBelow[n] = std::min(firstBelow[n], firstBelow[mStructure.children[c]]);
        }
    }
    std::vector<int> open;
    double total = 0;
    for (int n = 0; n < count; ++n) {
        if (mStructure.supernodes[n].parent < 0) {
            open.push_back(n);
            total += work[n];
        }
    }
    mTasks.clear();
    mTop.clear();
    while (!open.empty()) {
        const int n = open.back();
        open.pop_back();
        if (work[n] <= largestTask * total) {
            mTasks.push_back({firstBelow[n], n + 1});
            continue;
        }
        mTop.push_back(n);
        open.insert(open.end(), mStructure.children.begin() + mStructure.childBegin[n],
                    mStructure.children.begin() + mStructure.childBegin[n + 1]);
    }
    std::sort(mTop.begin(), mTop.end());
    // Adjacent small subtrees are combined into one task.
    std::sort(mTasks.begin(), mTasks.end(), [](const Task &a, const Task &b) { return a.begin < b.begin; });
    std::vector<Task> merged;
    double load = 0;
    for (const Task &task : mTasks) {
        const double own = work[task.end - 1];
        if (!merged.empty() && merged.back().end == task.begin && load + own <= largestTask * total) {
            merged.back().end = task.end;
            load += own;
        } else {
            merged.push_back(task);
            load = own;
        }
    }
    mTasks = std::move(merged);
    mScratch.resize(mTasks.size() + 1);
}

void FrontalSolver::makeFronts()
{
    const int count = static_cast<int>(mStructure.supernodes.size());
    std::vector<int> placeInTop(mStructure.nodeCount, -1);
    mTopNodes.clear();
    for (const int n : mTop) {
        const FrontalStructure::Supernode &s = mStructure.supernodes[n];
        for (int i = s.first; i < s.first + s.count; ++i) {
            placeInTop[i] = static_cast<int>(mTopNodes.size());
            mTopNodes.push_back(i);
        }
    }
    mOutside.assign(mStructure.rows.size(), -1);
    mFronts.resize(count);
    int longest = 0;
    for (int n = 0; n < count; ++n) {
        const FrontalStructure::Supernode &s = mStructure.supernodes[n];
        const Layout &l = mLayout[n];
        const bool inTop = placeInTop[s.first] >= 0;
        int inside = 0;
        while (inside < s.rowCount && (inTop || placeInTop[mStructure.rows[s.rowBegin + inside]] < 0))
            ++inside;
        for (int i = inside; i < s.rowCount; ++i)
            mOutside[s.rowBegin + i] = placeInTop[mStructure.rows[s.rowBegin + i]];
        mFronts[n] = {2 * s.first,
                      l.pivots,
                      l.pivotStride,
                      l.stride,
                      s.rowCount,
                      inside,
                      mStructure.rows.data() + s.rowBegin,
                      mOutside.data() + s.rowBegin + inside,
                      flat(mInverse) + l.inverse,
                      mCoupling.data() + l.coupling};
        longest = std::max(longest, l.stride);
    }
    mTopFronts.clear();
    for (const int n : mTop)
        mTopFronts.push_back(mFronts[n]);
    for (Scratch &scratch : mScratch)
        scratch.row.resize(lanesFor(longest));
}

bool FrontalSolver::factorize(const Matrix &lower)
{
    mSmallest = smallestPivot * static_cast<float>(lower.diagonal().mean());
    std::atomic<bool> good = true;
    mTeam.run(static_cast<int>(mTasks.size()), [&](int i) {
        for (int n = mTasks[i].begin; n < mTasks[i].end && good; ++n) {
            if (!eliminate(lower, n, mScratch[i]))
                good = false;
        }
    });
    for (std::size_t i = 0; good && i < mTop.size(); ++i)
        good = eliminate(lower, mTop[i], mScratch.back());
    if (!good) {
        for (Floats &update : mUpdate)
            Floats().swap(update);
    }
    return good;
}

FrontalSolver::Scratch &FrontalSolver::scratchOf(int node)
{
    const auto task =
        std::upper_bound(mTasks.begin(), mTasks.end(), node, [](int n, const Task &t) { return n < t.end; });
    const bool inTask = task != mTasks.end() && node >= task->begin;
    return inTask ? mScratch[static_cast<std::size_t>(task - mTasks.begin())] : mScratch.back();
}

bool FrontalSolver::eliminate(const Matrix &lower, int node, Scratch &scratch)
{
    const Layout &l = mLayout[node];
    float *inverse = flat(mInverse) + l.inverse;
    std::fill(inverse, inverse + static_cast<std::ptrdiff_t>(l.pivots) * l.pivotStride, 0.0f);
    scratch.coupling.assign(lanesFor(static_cast<std::size_t>(l.pivots) * l.stride), Lanes{});
    Floats &update = mUpdate[node];
    if (l.rows > 0 && !scratch.spare.empty()) {
        update = std::move(scratch.spare.back());
        scratch.spare.pop_back();
    }
    update.resize(std::max(update.size(), lanesFor(static_cast<std::size_t>(l.rows) * l.updateStride)));
    addEntries(lower, node, flat(scratch.coupling));
    const int *begin = mStructure.children.data() + mStructure.childBegin[node];
    const int *end = mStructure.children.data() + mStructure.childBegin[node + 1];
    for (const int *child = begin; child != end; ++child)
        addChild(*child, node, true, flat(scratch.coupling));
    for (int i = 1; i < l.pivots; ++i) {
        for (int j = 0; j < i; ++j)
            inverse[i * l.pivotStride + j] = inverse[j * l.pivotStride + i];
    }
    if (!invertFront(inverse, l.pivots, l.pivotStride, mSmallest))
        return false;
    scratch.solved.resize(scratch.coupling.size());
    multiplyFront(inverse, l.pivotStride, flat(scratch.coupling), flat(scratch.solved), l.pivots, l.stride);
    reduceFront(flat(scratch.coupling), flat(scratch.solved), l.pivots, l.rows, l.stride, flat(update),
                l.updateStride);
    for (const int *child = begin; child != end; ++child) {
        addChild(*child, node, false, nullptr);
        scratchOf(*child).spare.push_back(std::move(mUpdate[*child]));
    }
    packFront(flat(scratch.solved), l.pivots, l.stride, mCoupling.data() + l.coupling);
    return true;
}

void FrontalSolver::addEntries(const Matrix &lower, int node, float *coupling)
{
    const Layout &l = mLayout[node];
    float *inverse = flat(mInverse) + l.inverse;
    const double *values = lower.valuePtr();
    for (int e = mStructure.entryBegin[node]; e < mStructure.entryBegin[node + 1]; ++e) {
        const FrontalStructure::Entry &entry = mStructure.entries[e];
        const int row = 2 * entry.row, column = 2 * entry.column;
        float *place = column < l.pivots ? inverse + row * l.pivotStride + column
                                         : coupling + row * l.stride + column - l.pivots;
        float *below = place + (column < l.pivots ? l.pivotStride : l.stride);
        const double *first = values + entry.first, *second = values + entry.second;
        place[0] += static_cast<float>(first[0]);
        below[1] += static_cast<float>(second[1]);
        place[1] += static_cast<float>(first[1]);
        if (row != column)
            below[0] += static_cast<float>(second[0]);
    }
}

//! Adds rows of a child's update matrix to the front of its parent `node`: either the rows that the node
//! eliminates, or the others, which go into the node's own update matrix.
void FrontalSolver::addChild(int child, int node, bool eliminated, float *coupling)
{
    const Layout &from = mLayout[child], &to = mLayout[node];
    const FrontRun *runs = mStructure.runs.data() + mStructure.runBegin[child];
    const int count = mStructure.runBegin[child + 1] - mStructure.runBegin[child];
    int others = 0; // first run of the others
    while (others < count && runs[others].place < to.pivots)
        ++others;
    const float *update = flat(mUpdate[child]);
    if (eliminated) {
        addUpdate(update, from.updateStride, runs, 0, others, count, to.pivots, flat(mInverse) + to.inverse,
                  to.pivotStride, coupling, to.stride);
    } else {
        float *own = flat(mUpdate[node]) - static_cast<std::ptrdiff_t>(to.pivots) * to.updateStride;
        addUpdate(update, from.updateStride, runs, others, count, count, to.pivots, nullptr, 0, own,
                  to.updateStride);
    }
}

void FrontalSolver::solve(const Eigen::VectorXd &b, Eigen::VectorXd &x)
{
    for (int n = 0; n < mStructure.nodeCount; ++n) {
        float *to = mValues.data() + 2 * static_cast<std::size_t>(mStructure.newNumber[n]);
        to[0] = static_cast<float>(b[2 * n]);
        to[1] = static_cast<float>(b[2 * n + 1]);
    }
    const int tasks = static_cast<int>(mTasks.size()), top = static_cast<int>(mTopFronts.size());
    const int ahead = mPrefetch ? prefetchDistance : 0;
    mTeam.run(tasks, [&](int i) {
        Scratch &own = mScratch[i];
        own.outside.assign(lanesFor(2 * mTopNodes.size()), Lanes{});
        solveForward(mFronts.data(), mTasks[i].begin, mTasks[i].end, mValues.data(), flat(own.outside),
                     flat(own.row));
    });
    for (int i = 0; i < tasks; ++i) {
        const float *outside = flat(mScratch[i].outside);
        for (const int n : mTopNodes) {
            mValues[2 * static_cast<std::size_t>(n)] += *outside++;
            mValues[2 * static_cast<std::size_t>(n) + 1] += *outside++;
        }
    }
    float *row = flat(mScratch.back().row);
    solveForward(mTopFronts.data(), 0, top, mValues.data(), nullptr, row);
    solveBackward(mTopFronts.data(), 0, top, ahead, mValues.data(), row);
    mTeam.run(tasks, [&](int i) {
        solveBackward(mFronts.data(), mTasks[i].begin, mTasks[i].end, ahead, mValues.data(),
                      flat(mScratch[i].row));
    });
    x.resize(b.size());
    for (int n = 0; n < mStructure.nodeCount; ++n) {
        const float *from = mValues.data() + 2 * static_cast<std::size_t>(mStructure.newNumber[n]);
        x[2 * n] = from[0];
        x[2 * n + 1] = from[1];
    }
}

} // namespace autocuts::linear
