// What an OBJ file must get back on saving.
#pragma once

#include "model/document/scene.h"

#include <QByteArray>

#include <vector>

namespace autocuts {

//! The file itself, and where its UVs came from.
struct ObjSource final : SceneSource
{
    QByteArray bytes;
    std::vector<double> textureVertices;  //!< u and v of every vt line
    std::vector<int> cornerTextureVertex; //!< 0-based vt of every corner of the mesh, -1 for none
    std::vector<int> skippedFaces; //!< numbers (0-based, rising) of the f lines that are not in the mesh

    //! The UVs as they are in the file, a row per corner; NaN where there is none.
    UvMatrix originalUv() const;
};

//! The normal of every corner (3 columns) as the file gives it; NaN where there is none. Read from the bytes
//! on demand, since only other formats need it.
PositionMatrix objCornerNormals(const ObjSource &source);

} // namespace autocuts
