// What a model is like, part by part: flat faces with sharp edges, or curved.
#pragma once

#include "model/plain/meshdata.h"
#include "model/plain/solvesettings.h"

#include <vector>

namespace autocuts::preference {

struct SurfaceParts
{
    std::vector<bool> creased; //!< per connected component: seams may run along its sharp edges
    std::vector<bool> hard;    //!< per connected component: it is a hard surface, creased and flat in places
    double creasedShare = 0, hardShare = 0; //!< of the area of the mesh, in [0, 1]
};

//! The kinds of the connected components. A polygon is flat when each of its edges is sharp, open, or leads
//! to a polygon in the same plane. A part is creased when creases are at least 1 % of the length of its edges
//! and 70 % of that of its sharp edges, or at least half of its area is flat. A hard surface is creased, and
//! 1 % of its area is flat: a stuffed toy has creases, too. Where the model as a whole is one of these, so
//! are its parts below a tenth of the area, and those with creases of 60 % of their sharp edges. \param kind
//! what the user says; Auto: recognise
[[nodiscard]] SurfaceParts surfaceParts(const MeshData &mesh, SurfaceKind kind = SurfaceKind::Auto);

//! True when at least half of the area is in hard surfaces.
[[nodiscard]] bool isMostlyHard(const MeshData &mesh, SurfaceKind kind);

} // namespace autocuts::preference
