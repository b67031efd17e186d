#include "solver/search/blockcholesky.h"

#include <algorithm>
#include <cmath>

namespace autocuts::search {

void BlockCholesky::analyze(int count, const std::vector<std::pair<int, int>> &lower)
{
    mCount = count;
    // First to the rows, then in order within each, which has few: faster than sorting all.
    mMark.assign(count + 1, 0); // the end of each row so far
    for (const auto &[row, column] : lower)
        ++mMark[row + 1];
    for (int row = 0; row < count; ++row)
        mMark[row + 1] += mMark[row];
    mRowStart.assign(mMark.begin(), mMark.end());
    mColumn.resize(lower.size());
    for (const auto &[row, column] : lower)
        mColumn[mMark[row]++] = column;
    auto end = mColumn.begin();
    for (int row = 0; row < count; ++row) {
        const auto first = mColumn.begin() + mRowStart[row], last = mColumn.begin() + mMark[row];
        std::sort(first, last);
        mRowStart[row] = static_cast<int>(end - mColumn.begin());
        end = std::copy(first, std::unique(first, last), end);
    }
    mColumn.erase(end, mColumn.end());
    mRowStart[count] = static_cast<int>(mColumn.size());
    mValue.resize(mColumn.size());
    mDiagonal.resize(count);
    findRows();
}

//! Finds the pattern of the factor. Row k of the factor holds the columns on the paths in the elimination
//! tree that lead from the entries of row k of the matrix up to k (Liu 1986).
void BlockCholesky::findRows()
{
    mParent.assign(mCount, -1);
    mMark.assign(mCount, -1);
    mPatternStart.assign(mCount + 1, 0);
    mPattern.clear();
    mColumnStart.assign(mCount + 1, 0);
    for (int k = 0; k < mCount; ++k) {
        mMark[k] = k;
        for (int p = mRowStart[k]; p < mRowStart[k + 1]; ++p) {
            for (int j = mColumn[p]; mMark[j] != k; j = mParent[j]) {
                if (mParent[j] < 0)
                    mParent[j] = k;
                mMark[j] = k;
                mPattern.push_back(j);
                ++mColumnStart[j + 1];
            }
        }
        mPatternStart[k + 1] = static_cast<int>(mPattern.size());
    }
    for (int k = 0; k < mCount; ++k)
        mColumnStart[k + 1] += mColumnStart[k];
    // Ascending column numbers are a valid order of elimination: transposed twice, the rows have it.
    mRowIndex.resize(mPattern.size());
    mFilled.assign(mColumnStart.begin(), mColumnStart.end() - 1);
    for (int k = 0; k < mCount; ++k) {
        for (int p = mPatternStart[k]; p < mPatternStart[k + 1]; ++p)
            mRowIndex[mFilled[mPattern[p]]++] = k;
    }
    mFilled.assign(mPatternStart.begin(), mPatternStart.end() - 1);
    for (int j = 0; j < mCount; ++j) {
        for (int i = mColumnStart[j]; i < mColumnStart[j + 1]; ++i)
            mPattern[mFilled[mRowIndex[i]]++] = j;
    }
    mFactor.resize(mPattern.size());
    mPivot.resize(mCount);
    mWork.assign(mCount, Rows{});
}

void BlockCholesky::clear()
{
    std::fill(mValue.begin(), mValue.end(), Block{});
    std::fill(mDiagonal.begin(), mDiagonal.end(), Block{});
}

int BlockCholesky::place(int row, int column) const
{
    const auto first = mColumn.begin() + mRowStart[row], last = mColumn.begin() + mRowStart[row + 1];
    return static_cast<int>(std::lower_bound(first, last, column) - mColumn.begin());
}

bool BlockCholesky::factorize(const JobContext &job)
{
    constexpr int rowsPerLook = 256; // a row takes microseconds at the sizes of a seam search
    std::copy(mColumnStart.begin(), mColumnStart.end() - 1, mFilled.begin());
    for (int k = 0; k < mCount; ++k) {
        if (k % rowsPerLook == 0 && job.stopped())
            return false;
        for (int p = mRowStart[k]; p < mRowStart[k + 1]; ++p) {
            const Block &v = mValue[p];
            mWork[mColumn[p]].both = Quad{v[0], v[1], v[2], v[3]};
        }
        double d00 = mDiagonal[k][0], d10 = mDiagonal[k][2], d11 = mDiagonal[k][3];
        for (int p = mPatternStart[k]; p < mPatternStart[k + 1]; ++p) {
            const int j = mPattern[p];
            const Quad y = mWork[j].both;
            mWork[j] = Rows{};
            const Block &q = mPivot[j];
            const double a = y[0] * q[0], b = y[0] * q[2] + y[1] * q[3];
            const double c = y[2] * q[0], d = y[2] * q[2] + y[3] * q[3];
            const Quad aacc{a, a, c, c}, bbdd{b, b, d, d};
            const int end = mFilled[j]++;
            for (int i = mColumnStart[j]; i < end; ++i) {
                const Columns &l = mFactor[i];
                mWork[mRowIndex[i]].both -= aacc * __builtin_shufflevector(l.first, l.first, 0, 1, 0, 1) +
                                            bbdd * __builtin_shufflevector(l.second, l.second, 0, 1, 0, 1);
            }
            mFactor[end] = {Pair{a, c}, Pair{b, d}};
            d00 -= a * a + b * b;
            d10 -= c * a + d * b;
            d11 -= c * c + d * d;
        }
        if (!(d00 > 0))
            return false;
        const double i00 = 1 / std::sqrt(d00);
        const double l10 = d10 * i00;
        const double rest = d11 - l10 * l10;
        if (!(rest > 0))
            return false;
        const double i11 = 1 / std::sqrt(rest);
        mPivot[k] = {i00, 0, -l10 * i00 * i11, i11};
    }
    return true;
}

void BlockCholesky::solve(double *b) const
{
    for (int k = 0; k < mCount; ++k) {
        const Block &q = mPivot[k];
        const double u = b[2 * k] * q[0];
        const double v = b[2 * k] * q[2] + b[2 * k + 1] * q[3];
        b[2 * k] = u;
        b[2 * k + 1] = v;
        const Pair uu{u, u}, vv{v, v};
        for (int i = mColumnStart[k]; i < mColumnStart[k + 1]; ++i) {
            const Columns &l = mFactor[i];
            double *w = b + 2 * mRowIndex[i];
            const Pair change = l.first * uu + l.second * vv;
            w[0] -= change[0];
            w[1] -= change[1];
        }
    }
    for (int k = mCount - 1; k >= 0; --k) {
        double u = b[2 * k], v = b[2 * k + 1];
        for (int i = mColumnStart[k]; i < mColumnStart[k + 1]; ++i) {
            const Columns &l = mFactor[i];
            const double *w = b + 2 * mRowIndex[i];
            u -= l.first[0] * w[0] + l.first[1] * w[1];
            v -= l.second[0] * w[0] + l.second[1] * w[1];
        }
        const Block &q = mPivot[k];
        b[2 * k] = q[0] * u + q[2] * v;
        b[2 * k + 1] = q[3] * v;
    }
}

} // namespace autocuts::search
