// Matrices of Assimp and of Eigen.
#pragma once

#include <Eigen/Core>

#include <assimp/matrix4x4.h>

namespace autocuts {

inline aiMatrix4x4 toAssimp(const Eigen::Matrix4d &m)
{
    aiMatrix4x4 result;
    for (unsigned row = 0; row < 4; ++row) {
        for (unsigned column = 0; column < 4; ++column)
            result[row][column] = static_cast<ai_real>(m(row, column));
    }
    return result;
}

inline Eigen::Matrix4d toEigen(const aiMatrix4x4 &m)
{
    Eigen::Matrix4d result;
    for (unsigned row = 0; row < 4; ++row) {
        for (unsigned column = 0; column < 4; ++column)
            result(row, column) = m[row][column];
    }
    return result;
}

} // namespace autocuts
