// The data of an OBJ file that saving preserves.
#pragma once

#include "model/io/formats/filesource.h"

#include <QByteArray>

#include <vector>

namespace autocuts {

//! The bytes of the file and the sources of its UVs.
struct ObjSource final : FileSource
{
    QByteArray bytes;
    std::vector<double> textureVertices;  //!< u and v of each vt line
    std::vector<int> cornerTextureVertex; //!< 0-based vt number of each corner of the mesh, -1 for none
    //! 0-based numbers of the f lines that are not in the mesh, ascending.
    std::vector<int> skippedFaces;

    //! The UVs in the file, one row per corner; NaN where there is none.
    UvMatrix originalUv() const;

    //! Computed from the bytes on demand, since they are needed only to find hard edges and to write other
    //! formats.
    FileShading shading() const override;
    // In objanswers.cpp.
    bool isOf(const MeshData &mesh) const override;
    SceneWriter rewriter(const QString &suffix) const override;
    QStringList rewritingLosses(const Scene &scene) const override;
    std::vector<UvSet> uvSets(const Scene &scene) const override;
    QStringList filesBeside(const QString &path) const override;
    FileBlock sessionBlock() const override { return {"obj", true}; }
    QByteArray bytesForSession() const override { return bytes; }
};

} // namespace autocuts
