// Puts new UVs into the text of an OBJ file.
#pragma once

#include "model/io/objsource.h"

#include <QByteArray>

namespace autocuts {

//! For every corner the first corner of the same welded vertex with bit-identical UV; -1 without a finite UV.
//! \param uv a row per corner of the mesh
std::vector<int> sharedUvCorners(const MeshData &mesh, const UvMatrix &uv);

//! Appends "vt U V" with the fewest digits that read back to the same doubles.
void appendTextureVertex(QByteArray &out, double u, double v);

//! The bytes of the source with the given UVs. Only vt lines and the vt indices of f lines differ:
//! - the new vt lines stand where the old ones stood, each as late as the faces that use it allow, or before
//!   the first face when there were none;
//! - vt lines that other statements (l, surf) refer to stay, with their numbers, and the new ones follow
//! them;
//! - a face that is not in the mesh, and a corner without UV, get no vt index.
//! \param uv a row per corner of the mesh that was read from the source
QByteArray rewriteObj(const ObjSource &source, const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
