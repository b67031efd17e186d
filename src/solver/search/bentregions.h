// Which rigid regions have lost their shape in a map.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/base/soup.h"

#include <vector>

namespace autocuts::search {

//! Per rigid region: true where its mean energy is above that of a stretch by 1.6 % both ways. \param x u and
//! v per soup corner, see Soup
[[nodiscard]] std::vector<bool> bentRegions(const Soup &soup, const RigidRegions &regions,
                                            const std::vector<double> &x);

} // namespace autocuts::search
