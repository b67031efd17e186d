// Texel weights: how much more texels per length some faces are to have than others. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <memory>
#include <vector>

namespace autocuts {

//! The range of the painted texel weights. 2 is twice the texels per length; the default is 1.
inline constexpr double minTexelWeight = 0.125, maxTexelWeight = 8;

//! The weights in the form in which they are stored: one per face, or none when all are 1.
std::vector<double> storedTexelWeights(std::vector<double> weights);

//! True when they are one per face, in range and in the stored form.
bool areTexelWeights(const std::vector<double> &weights, int faceCount);

//! The mesh with texel weights: the given object when there are none, else a copy.
//! \pre areTexelWeights(weights, mesh->faceCount())
std::shared_ptr<const MeshData> withTexelWeights(const std::shared_ptr<const MeshData> &mesh,
                                                 const std::vector<double> &weights);

} // namespace autocuts
