// Figures of single islands, and setting their texel density.
#pragma once

#include "commands/setuvs.h"
#include "model/document/document.h"

#include <memory>
#include <vector>

namespace autocuts {

//! One island in numbers.
struct IslandFigures
{
    int faces = 0;
    double areaShare = 0;    //!< of the surface of all islands, in [0, 1]
    double texelDensity = 0; //!< texels per unit of the model; not a number without area
    double distortion =
        0; //!< area-weighted mean of the symmetric Dirichlet energy; not a number when unknown
    IslandFlags flags;
    std::vector<QString> tags;
};

//! Of all islands, in their order. \param triangleDistortion per triangle; empty: the distortion is not known
std::vector<IslandFigures> islandFigures(const Document &document,
                                         const std::vector<double> &triangleDistortion);

//! Mean of the islands' texel densities by their areas; not a number without area.
double meanTexelDensity(const Document &document, const std::vector<int> &islands);

//! Scales islands about the middles of their boxes to a texel density; locked ones, and those without area,
//! stay as they are. Pins travel along. \param density texels per unit of the model, > 0
std::unique_ptr<SetUvs> setTexelDensity(Document &document, const std::vector<int> &islands, double density);

} // namespace autocuts
