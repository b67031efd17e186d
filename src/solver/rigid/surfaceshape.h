// How a surface is bent: normals of triangles, angle defects of vertices.
#pragma once

#include "solver/base/cutmesh.h"

#include <vector>

namespace autocuts::rigid {

struct SurfaceShape
{
    CutMesh uncut;               //!< of the mesh without seams
    std::vector<Vec3> normal;    //!< per triangle; that of its polygon where this is plane
    std::vector<bool> planeFace; //!< per face
    std::vector<bool> thin;      //!< per triangle: too thin for a reliable normal
    double size = 0;             //!< diagonal of the mesh's box
    double wholeArea = 0;        //!< of the mesh, with all copies, see MeshData::faceCopies
    double wholeFaces = 0;       //!< number of faces, with all copies
    std::vector<double> defect;  //!< per vertex of the uncut surface: its angle defect, radians
    std::vector<bool> flatPoint; //!< per vertex of the uncut surface: its angle defect counts as none
    std::vector<bool> inner;     //!< per vertex of the uncut surface: not on a border

    explicit SurfaceShape(const MeshData &mesh);

    //! Triangles whose normals have a greater cosine than this, that of one degree, lie in one plane.
    static double planeCosine();

private:
    void measureTriangles(const MeshData &mesh);
    void flattenPolygons(const MeshData &mesh);
    void measureVertices(const MeshData &mesh);
};

} // namespace autocuts::rigid
