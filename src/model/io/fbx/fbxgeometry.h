// The polygons of one geometry of an FBX file and what its layers say about them.
#pragma once

#include "model/io/fbx/fbxtree.h"
#include "model/plain/types.h"

#include <QString>

namespace autocuts {

//! The polygons of a geometry. A *file corner* is an entry of PolygonVertexIndex.
struct FbxGeometry
{
    int node = 0;
    PositionMatrix points;            //!< the control points; those that are not finite are zero
    std::vector<int> polygonStart{0}; //!< offsets of the polygons into the file corners
    std::vector<int> cornerPoint;     //!< control point of each file corner
    //! The polygons that can be unwrapped: with three different control points, all of them known.
    std::vector<int> faces;
    int skippedElements = 0; //!< polygons of one or two corners: points and lines
    int skippedFaces = 0;    //!< other polygons that cannot be unwrapped

    int polygonCount() const { return static_cast<int>(polygonStart.size()) - 1; }
    int cornerCount() const { return static_cast<int>(cornerPoint.size()); }
};

//! Reads a geometry, or the model of version 6 that holds one. Nothing when its arrays are damaged.
std::optional<FbxGeometry> readFbxGeometry(const FbxTree &tree, int node);

//! The values of a layer element, one row of numbers for each file corner; NaN where it says nothing. Nothing
//! when its data do not fit the geometry. \param values the name of the list of values \param indices of the
//! list of indices, which may be missing \param width numbers per row
std::optional<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
readFbxLayer(const FbxTree &tree, int element, const FbxGeometry &geometry, std::string_view values,
             std::string_view indices, int width);

//! The UVs of a LayerElementUV, one row per file corner. All NaN when its data do not fit.
//! \param fits is set to whether they do
UvMatrix readFbxUv(const FbxTree &tree, int element, const FbxGeometry &geometry, bool &fits);

//! The name of a layer element.
QString fbxLayerName(const FbxTree &tree, int element);

} // namespace autocuts
