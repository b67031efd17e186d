// The polygon soup that every part of the program works on, and the triangle soup made from it. Plain: no Qt.
//
// Terms. A *vertex* is a row of `positions`. Vertices at the same position are *welded*: one of them stands
// for all. A *corner* is one vertex in one polygon; corners are numbered through all polygons, and UVs in
// files and in the document are per corner. A *soup corner* is one corner of one triangle, number 3 *
// triangle + k; the variables of the solver are per soup corner (paper, section 3). An *edge pair* is two
// triangle sides on the same 3D edge that may be stitched in UV space; it has two *corner pairs*, one at each
// end, numbered 2 * pair + end.
#pragma once

#include "model/plain/types.h"

#include <memory>
#include <ranges>
#include <string>
#include <vector>

namespace autocuts {

//! Two triangle sides on one 3D edge that may be stitched.
struct EdgePair
{
    std::array<int, 2> triangle;              //!< the two triangles
    std::array<std::array<int, 2>, 2> corner; //!< the soup corners, as [end][index in triangle]
    double length = 0;                        //!< 3D length, in the units of the mesh
    bool diagonal = false;                    //!< both sides are in one polygon: never a seam

    //! The side of triangle[which]: side k runs from corner k to corner k + 1.
    int side(int which) const
    {
        const int a = corner[0][which] % 3;
        const int b = corner[1][which] % 3;
        return (a + 1) % 3 == b ? a : b;
    }
};

//! Why a triangle side has no partner on its 3D edge.
enum class OpenSide {
    Boundary,    //!< only one face is on this edge
    NonManifold, //!< three or more faces; the others were paired with each other
    Winding,     //!< the neighbour runs in the same direction along the edge: its winding disagrees
    SelfContact  //!< the polygon meets itself at an end of this side in a way that cannot be laid flat
};

//! A triangle side without a partner.
struct BoundarySide
{
    int triangle = 0;
    int side = 0; //!< runs from corner `side` of the triangle to the next
    OpenSide reason = OpenSide::Boundary;
};

//! What was unusual about the input mesh, for the mesh doctor panel and the reports.
struct MeshReport
{
    int vertices = 0, weldedVertices = 0, isolatedVertices = 0;
    int faces = 0, polygons = 0; //!< polygons are faces of more than three corners
    int objects = 0, components = 0;
    //! Triangulated by ear clipping, or as a fan from a corner other than the first.
    int concavePolygons = 0;
    int degenerateTriangles = 0; //!< without area in 3D; the solver uses a thin shape in their place
    int duplicateFaces = 0;
    //! Polygons that meet themselves in a way that cannot be laid flat, such as `a b c b`. Their sides at
    //! these vertices are open.
    std::vector<int> selfContactFaces;
    int boundaryEdges = 0, nonManifoldEdges = 0, windingEdges = 0;
    double area = 0, boxDiagonal = 0, distanceFromOrigin = 0;
};

//! A mesh. Immutable once built; threads share it as shared_ptr<const MeshData>.
struct MeshData
{
    // The polygons as they were given.
    PositionMatrix positions;      //!< V x 3, in the units of the file
    std::vector<int> faceStart{0}; //!< F + 1 offsets into cornerVertex
    std::vector<int> cornerVertex; //!< vertex of each corner
    std::vector<int> faceObject;   //!< object of each face

    // Derived by build().
    //! For each vertex, the first vertex at exactly the same position.
    std::vector<int> vertexWeld;
    std::vector<std::array<int, 3>> triangles; //!< corners of each triangle, in the winding of its face
    std::vector<int> triangleFace;             //!< face of each triangle
    std::vector<int> faceTriangle;             //!< first triangle of each face; its others follow
    std::vector<double> triangleArea;          //!< 3D area
    //! Area <= 1e-10 * longest edge squared; the threshold was chosen by hand.
    std::vector<bool> triangleDegenerate;
    std::vector<EdgePair> edgePairs; //!< ordered by first triangle and side
    std::vector<BoundarySide> boundarySides;
    std::vector<int> component; //!< connected component of each triangle, over edge pairs
    int componentCount = 0;
    double area = 0; //!< total 3D area
    MeshReport report;

    //! What the user wants of the map, per face: how many times the texels per length of a face of weight 1.
    //! Empty when all are 1. See withTexelWeights().
    std::vector<double> texelWeight;

    //! Per face: how many copies of it there are in the mesh that this one stands for. Distortion and seams
    //! count as often. Empty: each stands for itself only. See unwrap/alikeparts.h.
    std::vector<int> faceCopies;

    int vertexCount() const { return static_cast<int>(positions.rows()); }
    int faceCount() const { return static_cast<int>(faceStart.size()) - 1; }
    int cornerCount() const { return static_cast<int>(cornerVertex.size()); }
    int triangleCount() const { return static_cast<int>(triangles.size()); }
    int soupCornerCount() const { return 3 * triangleCount(); }
    int cornerPairCount() const { return 2 * static_cast<int>(edgePairs.size()); }

    //! The indices of a face's triangles, then those of their soup corners.
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

    //! The polygon corner of a soup corner.
    int cornerOfSoup(int soupCorner) const { return triangles[soupCorner / 3][soupCorner % 3]; }
    //! The welded vertex of a soup corner.
    int vertexOfSoup(int soupCorner) const { return vertexWeld[cornerVertex[cornerOfSoup(soupCorner)]]; }
    Vec3 cornerPosition(int corner) const { return positions.row(cornerVertex[corner]); }
    //! The texel weight of a triangle's face.
    double texelWeightOf(int triangle) const
    {
        return texelWeight.empty() ? 1 : texelWeight[triangleFace[triangle]];
    }
    //! The copies of a triangle's face.
    int copiesOf(int triangle) const { return faceCopies.empty() ? 1 : faceCopies[triangleFace[triangle]]; }
    //! The 3D area of a triangle whose sides are multiplied by its texel weight.
    double targetArea(int triangle) const
    {
        const double weight = texelWeightOf(triangle);
        return weight * weight * triangleArea[triangle];
    }

    //! Builds the triangle soup. Accepts any polygons: n-gons, non-manifold edges, duplicated and degenerate
    //! faces, isolated vertices. Two sides form an edge pair only within one object and only when their
    //! windings agree. On an edge with more than two faces, each face is paired with the one that continues
    //! it most smoothly. From spatiallyNumberedFaces on, triangles are numbered so that neighbours in space
    //! have near numbers, whatever the order of the faces.
    //! \pre all indices are in range, every face has at least three corners, positions are finite and at most
    //! 1e150
    //! \throws std::invalid_argument when the precondition does not hold
    [[nodiscard]] static std::shared_ptr<const MeshData> build(PositionMatrix positions,
                                                               std::vector<int> faceStart,
                                                               std::vector<int> cornerVertex,
                                                               std::vector<int> faceObject);

    //! Checks the invariants of all derived data. Returns an empty string, or the first one that does not
    //! hold.
    std::string validate() const;
};

//! True when both have the same polygons at the same positions: they differ in their texel weights at most.
bool samePolygons(const MeshData &a, const MeshData &b);

} // namespace autocuts
