// A loaded file: its polygons, objects, materials and UV sets, and what a lossless save must give back.
#pragma once

#include "model/plain/meshdata.h"

#include <QByteArray>
#include <QString>

#include <memory>
#include <vector>

namespace autocuts {

//! A named UV set. One row per corner; a corner without a UV has a non-finite row.
struct UvSet
{
    QString name;
    UvMatrix uv;
};

//! What was read besides the geometry and must come back on saving. One kind per file format family.
struct SceneSource
{
    virtual ~SceneSource() = default;
};

//! A loaded model. The geometry is one polygon soup over all objects, shared and immutable; only the UV sets
//! are ever changed.
struct Scene
{
    QString path;   //!< file that it came from
    QString format; //!< lower-case suffix of that file: "obj", "ply", ...
    std::shared_ptr<const MeshData> mesh;
    std::vector<QString> objectNames; //!< by MeshData::faceObject
    std::vector<QString> materialNames;
    std::vector<int> faceMaterial; //!< index into materialNames, -1 for none
    std::vector<UvSet> uvSets;     //!< the first one is the active one
    std::shared_ptr<const SceneSource> source;
    std::vector<QString> notes; //!< what the reader skipped or repaired, one line each

    //! True when at least one corner of the active UV set has a finite UV.
    bool hasUv() const;
};

} // namespace autocuts
