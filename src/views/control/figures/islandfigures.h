// Computes figures of single islands and sets their texel density.
#pragma once

#include "commands/setuvs.h"
#include "model/document/document.h"

#include <memory>
#include <vector>

namespace autocuts {

//! The figures of one island.
struct IslandFigures
{
    int faces = 0;
    double areaShare = 0;    //!< share of the total 3D area of all islands, in [0, 1]
    double texelDensity = 0; //!< texels per unit of the model where the texel weight is 1; NaN without area
    //! The same with the weights, so as the island has them; NaN without texel weights, or without area.
    double shownDensity = 0;
    //! Mean symmetric Dirichlet energy at the scale that suits the island, so that it does not depend on the
    //! others; NaN when unknown.
    double distortion = 0;
    IslandFlags flags;
    std::vector<QString> tags;
};

//! The figures of all islands, in their order. \param distortion UvMetrics::chartSymDirichlet of the map;
//! empty when it is not known
std::vector<IslandFigures> islandFigures(const Document &document, const std::vector<double> &distortion);

//! Mean symmetric Dirichlet energy of every island at the scale that suits it; NaN when unknown.
std::vector<double> islandDistortions(const Document &document);

//! The texel density that islands with half of the area have at most; NaN when they have no area.
double medianTexelDensity(const std::vector<IslandFigures> &figures);

//! Mean texel density of the islands, weighted by area; NaN when they have no area.
double meanTexelDensity(const Document &document, const std::vector<int> &islands);

//! Scales islands about the centres of their boxes to a texel density. Locked islands and islands without
//! area are not changed. Pins move with the islands.
//! \param density texels per unit of the model where the texel weight is 1, > 0
std::unique_ptr<SetUvs> setTexelDensity(Document &document, const std::vector<int> &islands, double density);

} // namespace autocuts
