// Picking in the UV view.
#pragma once

#include "views/canvas/mapcamera.h"
#include "views/canvas/picking.h"
#include "views/gl/souptopology.h"

namespace autocuts {

//! Finds the elements at a point of the map; where triangles overlap, those of the triangle drawn last.
//! \param uv one row per soup corner; triangles without UVs are ignored
PickResult pickMap(const MeshData &mesh, const SoupTopology &topology, const UvMatrix &uv,
                   const MapCamera &camera, const QPointF &pixel);
BoxPick pickMapBox(const MeshData &mesh, const SoupTopology &topology, const UvMatrix &uv,
                   const MapCamera &camera, const PickRegion &region);

} // namespace autocuts
