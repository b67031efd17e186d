// Replaces the UVs in the bytes of an FBX file.
#pragma once

#include "model/io/fbx/fbxsource.h"

#include <QByteArray>

namespace autocuts {

//! The bytes of the source with the UV sets of the scene that was read from it. Sets are found by their
//! names, so that their order in the scene means nothing: each goes back to its own place.
//! - Of a geometry whose UVs have the same bits as in the file, nothing changes.
//! - A changed set of a geometry gets UVs by polygon vertex, with an index that shares the UVs of equal bits
//! at
//!   one control point and is -1 at corners without UV.
//! - A set that the file does not have takes the place of one that the scene does not have (it was renamed),
//! or
//!   else gets a LayerElementUV of its own and an entry in a Layer, in those geometries where it has UVs.
//! - A set that the scene does not have, or that has no UVs left in a geometry, is taken out.
//! - Of several models that show one geometry, the first one whose UVs have changed is written.
//! - The corners of polygons that are not in the mesh keep their UVs.
QByteArray rewriteFbx(const FbxSource &source, const Scene &scene);

//! True when two models that show one geometry have different UVs, of which only one can be written.
bool hasUnequalInstances(const FbxSource &source, const Scene &scene);

} // namespace autocuts
