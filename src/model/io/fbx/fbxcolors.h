// Vertex colours of FBX files.
#pragma once

#include "model/io/fbx/fbxshading.h"
#include "model/plain/cornercolors.h"

namespace autocuts {

//! The colours of the first LayerElementColor of each geometry, read as sRGB; null when there are none.
//! Layers whose numbers do not fit their geometry, or are too many for the file, are left out. \param damaged
//! gets their number
std::shared_ptr<const CornerColors> fbxCornerColors(const FbxTree &tree, const MeshData &mesh,
                                                    const FbxSource &source, const FbxGeometries &geometries,
                                                    int &damaged);

} // namespace autocuts
