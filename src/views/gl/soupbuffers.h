// The arrays for the graphics card, as pure functions of the mesh, the map and the options.
#pragma once

#include "model/document/seams.h"
#include "model/document/selection.h"
#include "model/plain/cornercolors.h"
#include "model/plain/meshadjacency.h"
#include "views/gl/meshframe.h"
#include "views/gl/souptopology.h"
#include "views/gl/stretch.h"
#include "views/gl/viewcolors.h"
#include "views/state/viewstate.h"

#include <span>
#include <vector>

namespace autocuts {

//! Position and smooth normal of a soup corner, in the mesh frame.
struct SoupVertex
{
    std::array<float, 3> position, normal;
};

//! UV of all corners of a triangle with a missing UV: the UV view does not draw it.
inline constexpr float noUv = 1e30f;

//! Colour and marks of a triangle; has the layout of a GL_RGBA8UI texel.
struct FaceTexel
{
    enum Mark : quint8 {
        Selected = 1,
        Overlapping = 2,
        Flipped = 4,
        WithoutUv = 8,
        Hidden = 16,
        Buried = 32
    };

    quint8 red = 0, green = 0, blue = 0, marks = 0;
    bool operator==(const FaceTexel &) const = default;
};

//! The lines along a side of a triangle; has the layout of a GL_RGBA8UI texel. The opacity of the top line
//! may differ at its two ends.
struct SideTexel
{
    quint8 base = 0;            //!< SideStyle of the lower line
    quint8 opacity[2] = {0, 0}; //!< opacity of the top line at the first and second corner of the side
    quint8 top = 0;             //!< SideStyle of the top line
    bool operator==(const SideTexel &) const = default;
};

//! A mark on a vertex.
struct PointVertex
{
    std::array<float, 3> position; //!< in the mesh frame, or u, v and 0
    QRgb color;                    //!< bytes: blue, green, red, alpha
};

//! One per soup corner, with its shadingNormals(). \param hardEdges as in Scene::hardEdges
std::vector<SoupVertex> soupVertices(const MeshData &mesh, const std::vector<bool> &hardEdges,
                                     const MeshFrame &frame);
//! The tangents for normal maps: three numbers per soup corner and the side of the bitangent, as in Tangent.
//! Takes seconds for a million triangles. \param uv one row per polygon corner \param hardEdges as above
std::vector<float> soupTangents(const MeshData &mesh, const UvMatrix &uv, const std::vector<bool> &hardEdges);
//! Two numbers per soup corner, noUv where the triangle has no UVs. \param uv one row per soup corner
std::vector<float> soupUvs(const UvMatrix &uv);
//! Previews the finished map of a running solve: corner pairs with a separation below 0.5 are closed, and
//! each group of connected soup corners is drawn at its average (paper, section 4, "Finalizing the UV map").
//! \param separation as ShownMap::separation()
UvMatrix ghostUv(const MeshData &mesh, const UvMatrix &uv, std::span<const float> separation);
//! The island of each face in the live map, when corner pairs with a separation below 0.5 count as closed.
//! Islands are numbered by their lowest faces, like those of the document.
//! \param separation as ShownMap::separation()
std::vector<int> liveIslands(const MeshData &mesh, std::span<const float> separation);

//! The input for the colours of the faces.
struct FaceInput
{
    const MeshData &mesh;
    const UvMatrix &uv; //!< one row per soup corner
    const ViewOptions &options;
    const ViewColors &colors;
    bool colorBlind = false;
    QColor plain;                        //!< for faces without another colour
    const TriangleStretch &stretch;      //!< may be empty when the colouring does not use it
    std::span<const int> islands;        //!< per face; -1 without UVs
    std::span<const double> seamWeights; //!< Seams::weights
    std::span<const int> selectedFaces;
    std::span<const int> overlapping; //!< triangle indices
    const std::vector<bool> &flipped;
    std::span<const float> density = {}; //!< per triangle; may be empty when the colouring does not use it
    double rightDensity = 1;             //!< that gets the colour in the middle
    std::span<const double> texelWeights = {}; //!< per face; empty when all are 1
    std::span<const int> hiddenFaces = {};
    std::span<const CornerColor> vertexColors = {}; //!< per corner; may be empty
};
std::vector<FaceTexel> faceTexels(const FaceInput &input);

//! The input for the lines.
struct SideInput
{
    const MeshData &mesh;
    const SoupTopology &topology;
    const UvMatrix &uv;                //!< one row per soup corner
    std::span<const float> separation; //!< ShownMap::separation()
    const Seams &seams;
    const ViewOptions &options;
    std::span<const int> selectedEdges;  //!< edges of MeshAdjacency
    const std::vector<bool> &givenSeams; //!< per edge pair; empty when none are shown
};
//! One per side; sides of diagonals have no lines.
std::vector<SideTexel> sideTexels(const SideInput &input);

} // namespace autocuts
