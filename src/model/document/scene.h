// A loaded model: its polygons, objects, materials and UV sets, and the data that saving must preserve.
#pragma once

#include "model/document/texturesets.h"
#include "model/plain/cornercolors.h"
#include "model/plain/meshdata.h"

#include <QByteArray>
#include <QRgb>
#include <QString>

#include <memory>
#include <vector>

namespace autocuts {

//! A named UV set. One row per corner; the row of a corner without a UV is not finite.
struct UvSet
{
    QString name;
    UvMatrix uv;
};

//! Data read besides the geometry that must be written back on saving. One subclass per family of file
//! formats.
struct SceneSource
{
    virtual ~SceneSource() = default;
};

//! A loaded model. Its geometry is one polygon soup over all objects, shared and immutable; only the UV sets
//! change.
struct Scene
{
    QString path;   //!< the file it was loaded from
    QString format; //!< lower-case suffix of that file: "obj", "ply", ...
    std::shared_ptr<const MeshData> mesh;
    std::vector<QString> objectNames; //!< indexed by MeshData::faceObject
    std::vector<QString> materialNames;
    std::vector<int> faceMaterial; //!< index into materialNames, -1 for none
    //! Base colour of each material, opaque; 0 where the file says none. May be shorter than materialNames.
    std::vector<QRgb> materialColors;
    //! Picture of each material's base colour. May be shorter than materialNames.
    std::vector<SceneTexture> materialTextures;
    //! What else the file says of each material; without its base colour. May be shorter than materialNames.
    std::vector<TextureSet> materialSets;
    //! Per edge pair: the file shades its two sides as separate surfaces, by smoothing groups or by normals
    //! that differ; empty when the file says nothing about shading.
    std::vector<bool> hardEdges;
    //! Per corner: the vertex colours of the file; null when it has none. glTF has them in linear light,
    //! other files in sRGB.
    std::shared_ptr<const CornerColors> cornerColors;
    std::vector<UvSet> uvSets; //!< the first one is the active one
    std::shared_ptr<const SceneSource> source;
    //! Objects that share a mesh in the file get a mesh of their own when that is written again.
    bool uniqueMeshes = false;
    std::vector<QString> notes; //!< what the reader skipped or repaired, one line each

    //! True when at least one corner of the active UV set has a finite UV.
    bool hasUv() const;
    //! All that the file says of a material; empty for -1.
    TextureSet fileSet(int material) const;
};

} // namespace autocuts
