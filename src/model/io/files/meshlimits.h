// Limits of what the readers of mesh files take.
#pragma once

#include <QtGlobal>

#include <cstddef>
#include <limits>

namespace autocuts {

//! Bytes, where the format has no limit of its own. Chosen by hand.
constexpr qint64 maxMeshFileSize = qint64(4) << 30;
//! Corners, vertices and faces at most. Soup corners are up to three times as many; their number, and small
//! multiples of it, has to fit into an int.
constexpr std::size_t maxElements = std::numeric_limits<int>::max() / 8;
//! Areas of meshes with larger coordinates may leave the range of doubles.
constexpr double maxCoordinate = 1e100;

} // namespace autocuts
