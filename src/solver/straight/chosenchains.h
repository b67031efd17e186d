// The edge loops that the user wants straight, as chains of the islands.
#pragma once

#include "solver/straight/borderchains.h"

namespace autocuts::straight {

//! Per island: the chains that a list of edge loops makes there. A loop along a seam makes one on each side.
//! \param loops edge pairs, see Steering::straightLoops
std::vector<std::vector<Chain>> chosenChains(const Soup &soup, const CutMesh &charts,
                                             const std::vector<Island> &islands,
                                             const std::vector<std::vector<int>> &loops);

} // namespace autocuts::straight
