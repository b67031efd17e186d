#include "solver/base/lanes.h"

#include "solver/base/simd.h"

namespace autocuts {

AUTOCUTS_CLONES
void invertLanes(const EdgeMatrix &a, EdgeMatrix &inverse)
{
    // Small enough not to change valid pivots, large enough for a finite reciprocal in single precision.
    constexpr float leastPivot = 1e-30f;
    // a = L D L^T with a unit diagonal of L. With W the inverse of L: a^-1 = W^T D^-1 W.
    Lanes l[4][4], w[4][4];
    Lanes r[4]; // 1 / D
    int at = 0;
    for (int i = 0; i < 4; ++i) {
        Lanes scaled[4]; // row i of L D
        for (int j = 0; j < i; ++j) {
            scaled[j] = a[at++];
            for (int k = 0; k < j; ++k)
                scaled[j] -= scaled[k] * l[j][k];
        }
        Lanes pivot = a[at++];
        for (int j = 0; j < i; ++j) {
            l[i][j] = scaled[j] * r[j];
            pivot -= scaled[j] * l[i][j];
        }
        r[i] = 1 / (pivot > leastPivot ? pivot : Lanes{} + leastPivot);
    }
    for (int j = 0; j < 4; ++j) {
        for (int i = j + 1; i < 4; ++i) {
            w[i][j] = -l[i][j];
            for (int k = j + 1; k < i; ++k)
                w[i][j] -= l[i][k] * w[k][j];
        }
    }
    at = 0;
    for (int i = 0; i < 4; ++i) {
        Lanes column[4]; // of D^-1 W
        for (int k = i + 1; k < 4; ++k)
            column[k] = r[k] * w[k][i];
        for (int j = 0; j < i; ++j) {
            Lanes sum = r[i] * w[i][j];
            for (int k = i + 1; k < 4; ++k)
                sum += column[k] * w[k][j];
            inverse[at++] = sum;
        }
        Lanes sum = r[i];
        for (int k = i + 1; k < 4; ++k)
            sum += column[k] * w[k][i];
        inverse[at++] = sum;
    }
}

} // namespace autocuts
