// What the graphics card is given, as plain arrays: pure functions of the mesh, the map and the options.
#pragma once

#include "model/document/seams.h"
#include "model/document/selection.h"
#include "model/plain/meshadjacency.h"
#include "views/gl/meshframe.h"
#include "views/gl/souptopology.h"
#include "views/gl/stretch.h"
#include "views/gl/viewcolors.h"
#include "views/state/viewstate.h"

#include <span>
#include <vector>

namespace autocuts {

//! Position and smooth normal of a soup corner, in the frame of the mesh.
struct SoupVertex
{
    std::array<float, 3> position, normal;
};

//! UV of the corners of a triangle of which not all have one: nothing is drawn for it in the UV view.
inline constexpr float noUv = 1e30f;

//! Colour and marks of a triangle; the layout of a GL_RGBA8UI texel.
struct FaceTexel
{
    enum Mark : quint8 { Selected = 1, Overlapping = 2, Flipped = 4, WithoutUv = 8 };

    quint8 red = 0, green = 0, blue = 0, marks = 0;
    bool operator==(const FaceTexel &) const = default;
};

//! Lines along a side of a triangle; the layout of a GL_RGBA8UI texel. The line on top can be more or less
//! opaque at both ends.
struct SideTexel
{
    quint8 base = 0;            //!< SideStyle below
    quint8 opacity[2] = {0, 0}; //!< of the one on top, at the side's first and second corner
    quint8 top = 0;             //!< SideStyle on top
    bool operator==(const SideTexel &) const = default;
};

//! A vertex mark.
struct PointVertex
{
    std::array<float, 3> position; //!< in the frame of the mesh, or u, v and 0
    QRgb color;                    //!< as bytes: blue, green, red, alpha
};

//! One per soup corner. Normals are smoothed over faces that meet at less than 40 degrees.
std::vector<SoupVertex> soupVertices(const MeshData &mesh, const MeshAdjacency &adjacency,
                                     const MeshFrame &frame);
//! Two numbers per soup corner, or noUv. \param uv one row per soup corner
std::vector<float> soupUvs(const UvMatrix &uv);
//! The map that joining the nearly joined corner pairs of the live one would give: soup corners that hang
//! together are at their average (paper, "Finalizing"). \param separation as ShownMap::separation()
UvMatrix ghostUv(const MeshData &mesh, const UvMatrix &uv, std::span<const float> separation);
//! Per face, its island in the live map: what hangs together when nearly joined pairs are joined. Numbered by
//! their lowest faces like those of the document. \param separation as ShownMap::separation()
std::vector<int> liveIslands(const MeshData &mesh, std::span<const float> separation);

//! What the colours of faces are made from.
struct FaceInput
{
    const MeshData &mesh;
    const UvMatrix &uv; //!< one row per soup corner
    const ViewOptions &options;
    const ViewColors &colors;
    bool colorBlind = false;
    QColor plain;                        //!< faces without another colour
    const TriangleStretch &stretch;      //!< may be empty when the colouring does not need it
    std::span<const int> islands;        //!< per face, -1 without UVs
    std::span<const double> seamWeights; //!< Seams::weights
    std::span<const int> selectedFaces;
    std::span<const int> overlapping; //!< triangles
    const std::vector<bool> &flipped;
};
std::vector<FaceTexel> faceTexels(const FaceInput &input);

//! What the lines are made from.
struct SideInput
{
    const MeshData &mesh;
    const SoupTopology &topology;
    const UvMatrix &uv;                //!< one row per soup corner
    std::span<const float> separation; //!< ShownMap::separation()
    const Seams &seams;
    const ViewOptions &options;
    std::span<const int> selectedEdges; //!< edges of MeshAdjacency
};
//! One per side; sides of diagonals have nothing.
std::vector<SideTexel> sideTexels(const SideInput &input);

} // namespace autocuts
