// Puts together the report on a map.
#pragma once

#include "model/document/scene.h"
#include "model/layouts/report.h"
#include "model/plain/packingsettings.h"
#include "model/plain/uvfigures.h"

namespace autocuts {

//! The report on the active UV set, the first one, and the mesh.
//! \param figures of that set; null without UVs: then the figures of the map stay unknown
//! \param packing the texture, for figures in texels
MapReport mapReport(const Scene &scene, const metrics::UvMetrics *figures, const PackingSettings &packing);

} // namespace autocuts
