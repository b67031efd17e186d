// Changes the texel weights of a mesh without copying it each time.
#pragma once

#include "model/plain/meshdata.h"

#include <memory>
#include <vector>

namespace autocuts {

//! A mesh with other texel weights, as withTexelWeights() makes it. An earlier result that nobody else uses
//! any more is changed instead of copying the mesh again: a brush changes the weights with each move of the
//! mouse. Those that somebody still uses, such as a live solve, stay as they are.
//! \param before the mesh with other weights \param mesh the same without \param weights not empty
std::shared_ptr<const MeshData> reweighted(std::shared_ptr<const MeshData> before,
                                           const std::shared_ptr<const MeshData> &mesh,
                                           const std::vector<double> &weights);

} // namespace autocuts
