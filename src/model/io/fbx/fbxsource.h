// The data of an FBX file that saving preserves.
#pragma once

#include "model/io/fbx/fbxobjects.h"

#include <QByteArray>

#include <atomic>
#include <vector>

namespace autocuts {

//! One UV set of one geometry.
struct FbxUvElement
{
    int node = 0; //!< the LayerElementUV
    int set = 0;  //!< index into FbxSource::setNames
};

//! A geometry and where it is in the soup: once for each model that shows it.
struct FbxUse
{
    int node = 0;      //!< the geometry
    int faceCount = 0; //!< those of FbxGeometry::faces
    std::vector<FbxUvElement> elements;
    struct Instance
    {
        int firstFace = 0;     //!< of the soup; the others follow in their order
        bool mirrored = false; //!< the corners of each face are in reverse order
    };
    std::vector<Instance> instances;
};

//! Whether Assimp reads the same polygons from the file, for writing other formats.
enum class FbxTwin { Unknown, Found, None };

//! The bytes of the file and where its UVs are. Nodes are numbered as parseFbxTree() does it.
struct FbxSource final : SceneSource
{
    QByteArray bytes;
    int version = 0;
    FbxSpace space;
    SourceContents contents;
    std::vector<QString> setNames; //!< of the UV sets of the scene that was read
    std::vector<FbxUse> uses;
    int corners = 0;                                      //!< of the mesh
    mutable std::atomic<FbxTwin> twin = FbxTwin::Unknown; //!< set by assimpTwin()
};

//! The FBX source of the scene's mesh, or null.
const FbxSource *fbxSourceOf(const Scene &scene);

} // namespace autocuts
