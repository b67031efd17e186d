// The polygon soup that everything works on, and the triangle soup made from it. Plain: no Qt.
//
// Words. A *vertex* is a row of `positions`. A *corner* is one vertex in one polygon; corners are numbered
// through all polygons, and UVs in files and in the document are per corner. A *soup corner* is one corner
// of one triangle, number 3 * triangle + k; the solver's variables are per soup corner (paper, section 3).
// An *edge pair* is two triangle sides that lie on the same 3D edge and are allowed to be joined in UV
// space; it has two *corner pairs*, one at each end, numbered 2 * pair + end.
#pragma once

#include "model/plain/types.h"

#include <memory>
#include <ranges>
#include <string>
#include <vector>

namespace autocuts {

//! Two triangle sides on one 3D edge.
struct EdgePair
{
    std::array<int, 2> triangle;              //!< the two triangles
    std::array<std::array<int, 2>, 2> corner; //!< soup corner at [end][which triangle]
    double length = 0;                        //!< 3D length, in the units of the mesh
    bool diagonal = false;                    //!< both in one polygon: never a seam

    //! Side of triangle which (0 or 1): k means the side from its corner k to its corner k + 1.
    int side(int which) const
    {
        const int a = corner[0][which] % 3;
        const int b = corner[1][which] % 3;
        return (a + 1) % 3 == b ? a : b;
    }
};

//! Why a triangle side has no partner.
enum class OpenSide {
    Boundary,    //!< only one face on this edge
    NonManifold, //!< three or more faces; the others found better partners
    Winding      //!< the neighbour runs the same way along the edge: its winding disagrees
};

//! A triangle side without a partner.
struct BoundarySide
{
    int triangle = 0;
    int side = 0; //!< from its corner `side` to the next
    OpenSide reason = OpenSide::Boundary;
};

//! What was found to be unusual when the mesh was built, and how it is handled ("mesh doctor").
struct MeshReport
{
    int vertices = 0, weldedVertices = 0, isolatedVertices = 0;
    int faces = 0, polygons = 0; //!< polygons: faces of more than three corners
    int objects = 0, components = 0;
    int concavePolygons = 0;     //!< triangulated by ear clipping or a chosen fan apex
    int degenerateTriangles = 0; //!< no area in 3D: a thin stand-in shape is used for them
    int duplicateFaces = 0;
    int boundaryEdges = 0, nonManifoldEdges = 0, windingEdges = 0;
    double area = 0, boxDiagonal = 0, distanceFromOrigin = 0;
};

//! Immutable once built; shared between threads as shared_ptr<const MeshData>.
struct MeshData
{
    // The polygons as given.
    PositionMatrix positions;      //!< V x 3, in the file's own units
    std::vector<int> faceStart{0}; //!< F + 1 offsets into cornerVertex
    std::vector<int> cornerVertex; //!< vertex of each corner
    std::vector<int> faceObject;   //!< object of each face

    // Derived by build().
    std::vector<int> vertexWeld;               //!< vertex -> first vertex at exactly the same position
    std::vector<std::array<int, 3>> triangles; //!< corners of each triangle, in the winding of its face
    std::vector<int> triangleFace;             //!< face of each triangle
    std::vector<int> faceTriangle;             //!< first triangle of each face; its others follow
    std::vector<double> triangleArea;          //!< 3D area
    std::vector<bool> triangleDegenerate;      //!< area <= 1e-10 * longest edge squared
    std::vector<EdgePair> edgePairs;           //!< ordered by first triangle and side
    std::vector<BoundarySide> boundarySides;
    std::vector<int> component; //!< connected component (over edge pairs) of each triangle
    int componentCount = 0;
    double area = 0; //!< total 3D area
    MeshReport report;

    int vertexCount() const { return static_cast<int>(positions.rows()); }
    int faceCount() const { return static_cast<int>(faceStart.size()) - 1; }
    int cornerCount() const { return static_cast<int>(cornerVertex.size()); }
    int triangleCount() const { return static_cast<int>(triangles.size()); }
    int soupCornerCount() const { return 3 * triangleCount(); }
    int cornerPairCount() const { return 2 * static_cast<int>(edgePairs.size()); }

    //! Numbers of a face's triangles, and of their soup corners.
    auto trianglesOf(int face) const
    {
        return std::views::iota(faceTriangle[face],
                                faceTriangle[face] + faceStart[face + 1] - faceStart[face] - 2);
    }
    auto soupCornersOf(int face) const
    {
        const auto own = trianglesOf(face);
        return std::views::iota(3 * *own.begin(), 3 * *own.end());
    }

    //! Polygon corner of a soup corner.
    int cornerOfSoup(int soupCorner) const { return triangles[soupCorner / 3][soupCorner % 3]; }
    //! Welded vertex of a soup corner.
    int vertexOfSoup(int soupCorner) const { return vertexWeld[cornerVertex[cornerOfSoup(soupCorner)]]; }
    Vec3 cornerPosition(int corner) const { return positions.row(cornerVertex[corner]); }

    //! Builds the triangle soup. Accepts anything: n-gons, non-manifold edges, duplicated and degenerate
    //! faces, isolated vertices. Sides pair only within one object and only where the windings agree; on an
    //! edge with more than two faces each face gets the partner that continues it most smoothly. In large
    //! meshes the triangles of faces near to each other have near numbers, whatever the order of the faces.
    //! \pre all indices are in range, every face has at least three corners, positions are finite and at most
    //! 1e150 \throws std::invalid_argument when the precondition does not hold
    [[nodiscard]] static std::shared_ptr<const MeshData> build(PositionMatrix positions,
                                                               std::vector<int> faceStart,
                                                               std::vector<int> cornerVertex,
                                                               std::vector<int> faceObject);

    //! Checks the invariants of everything derived; empty when all hold, else the first broken one.
    std::string validate() const;
};

} // namespace autocuts
