// Packs the charts of a UV map; used by the window and by the command line.
#pragma once

#include "model/plain/rigidpieces.h"
#include "solver/base/jobcontext.h"
#include "solver/packing/islandgeometry.h"

namespace autocuts::packing {

//! Gives the pieces one texel density (unless settings.keepScale), packs them and moves their UVs.
//! \param uv one row per corner, UV units; changed only when the result is complete
//! \param basis of the texel density
PackResult packMap(const MeshData &mesh, const RigidPieces &pieces, const PackOptions &settings,
                   DensityBasis basis, UvMatrix &uv, const JobContext &job = {});

//! Options for packing into the UDIM tile of the settings: 1001 is the first, ten tiles make a row.
PackOptions tileOptions(const PackingSettings &settings);

} // namespace autocuts::packing
