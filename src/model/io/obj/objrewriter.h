// Replaces the UVs in the text of an OBJ file.
#pragma once

#include "model/io/obj/objsource.h"

#include <QByteArray>

namespace autocuts {

//! Appends "vt U V" with the fewest digits from which the same doubles can be read.
void appendTextureVertex(QByteArray &out, double u, double v);

//! The bytes of the source with the given UVs. Only vt lines and the vt indices of f lines change:
//! - New vt lines replace the old ones in the same places, each as late as the faces that use it allow; they
//!   come before the first face when there were none.
//! - The vt lines that other statements (l, surf) refer to keep their numbers, and the new ones follow them.
//! - Faces that are not in the mesh and corners without UV get no vt index.
//! \param uv one row per corner of the mesh that was read from the source
QByteArray rewriteObj(const ObjSource &source, const MeshData &mesh, const UvMatrix &uv);

} // namespace autocuts
