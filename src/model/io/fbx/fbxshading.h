// Hard edges of FBX files, from normals and smoothing.
#pragma once

#include "model/io/fbx/fbxgeometry.h"
#include "model/io/fbx/fbxsource.h"

namespace autocuts {

//! The geometries of a file by their nodes, in the order of FbxSource::uses.
using FbxGeometries = std::vector<FbxGeometry>;

//! The corner of the soup for each file corner of an instance; -1 for those of polygons that are left out.
std::vector<int> fbxSoupCorners(const MeshData &mesh, const FbxGeometry &geometry,
                                const FbxUse::Instance &instance);

//! The hard edges of the mesh, as in hardedges.h. Normals say it; where a geometry has none, its smoothing
//! groups or the smoothing of its edges.
std::vector<bool> fbxHardEdges(const FbxTree &tree, const MeshData &mesh, const FbxSource &source,
                               const FbxGeometries &geometries);

} // namespace autocuts
