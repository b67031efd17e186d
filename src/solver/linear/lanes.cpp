#include "solver/linear/lanes.h"

#include "solver/linear/simd.h"

#include <cmath>

namespace autocuts {

AUTOCUTS_CLONES
void invertLanes(const LaneMatrix &a, LaneMatrix &inverse)
{
    Lanes l[6][6];
    Lanes r[6]; // 1 / diagonal of l
    int at = 0;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j <= i; ++j) {
            Lanes sum = a[at++];
            for (int k = 0; k < j; ++k)
                sum -= l[i][k] * l[j][k];
            if (i != j) {
                l[i][j] = sum * r[j];
                continue;
            }
            for (int lane = 0; lane < laneCount; ++lane)
                r[i][lane] = 1 / std::sqrt(sum[lane] > 1e-30f ? sum[lane] : 1e-30f);
        }
    }
    Lanes w[6][6]; // inverse of l
    for (int j = 0; j < 6; ++j) {
        w[j][j] = r[j];
        for (int i = j + 1; i < 6; ++i) {
            Lanes sum = l[i][j] * w[j][j];
            for (int k = j + 1; k < i; ++k)
                sum += l[i][k] * w[k][j];
            w[i][j] = -sum * r[i];
        }
    }
    at = 0;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j <= i; ++j) {
            Lanes sum = w[i][i] * w[i][j];
            for (int k = i + 1; k < 6; ++k)
                sum += w[k][i] * w[k][j];
            inverse[at++] = sum;
        }
    }
}

} // namespace autocuts
