// The triangle soup in solver units: separate triangles, related by corner pairs (paper, section 3).
#pragma once

#include "model/plain/snapshot.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace autocuts {

//! The soup corners that one soup corner is paired with: one across each of the two sides that meet at it.
struct CornerPartners
{
    std::array<int, 2> corner{-1, -1}; //!< soup corner; -1 at a border
    std::array<int, 2> pair{-1, -1};   //!< corner pair
};

//! Rest shapes and corner pairs of the soup, the state of the paper in which all triangles are separate.
//! Lengths are in *solver units*: the mesh is scaled to area pi. Rest shapes are multiplied by the texel
//! weights of their faces, so that whatever brings the map near to them gives each face its texel density;
//! weights and lengths of edges stay those of the model. Immutable. Coordinates are a flat vector x of 2 *
//! soupCornerCount() numbers: u and v of soup corner c are x[2c] and x[2c + 1].
struct Soup
{
    //! Linear map from a triangle's corners to its Jacobian: J(r, c) = sum over k of x(corner k)[r] * b[2k +
    //! c].
    using Basis = std::array<double, 6>;

    std::shared_ptr<const MeshData> mesh;
    double scale = 1;         //!< mesh units to solver units
    std::vector<Basis> basis; //!< per triangle
    //! Per triangle, what it is to be in the map: x0 y0 x1 y1 x2 y2.
    std::vector<std::array<double, 6>> restShape;
    //! Per triangle, share of the total area; with MeshData::faceCopies, that of all copies of it.
    std::vector<double> weight;
    double perCopy = 1;                          //!< area of the mesh over that with all copies
    std::vector<double> componentShare;          //!< per connected component: the sum of shareOfCopy()
    std::vector<std::array<int, 2>> pairCorners; //!< per corner pair, the two soup corners
    std::vector<CornerPartners> partners;        //!< per soup corner
    std::vector<double> pairLength;              //!< per corner pair, length of its edge
    double meanEdgeLength = 0;

    int triangleCount() const { return static_cast<int>(basis.size()); }
    int coordinateCount() const { return 6 * triangleCount(); }
    //! The weight of a triangle for one copy of its face: its share of the area of the mesh with all copies.
    double shareOfCopy(int triangle) const { return weight[triangle] / mesh->copiesOf(triangle); }
    //! The share of the area of the mesh as it is.
    double areaShare(int triangle) const { return shareOfCopy(triangle) / perCopy; }
    //! The share of the total area that a triangle is to have in a map where those of texel weight 1 have
    //! theirs.
    double targetWeight(int triangle) const
    {
        const double texelWeight = mesh->texelWeightOf(triangle);
        return texelWeight * texelWeight * areaShare(triangle);
    }

    //! Builds the soup of a mesh. Triangles without area in 3D get a thin stand-in shape and a weight near
    //! zero: they must not flip either but hardly pull at their neighbours.
    //! \throws std::invalid_argument when the mesh has no area at all
    [[nodiscard]] static std::shared_ptr<const Soup> build(std::shared_ptr<const MeshData> mesh);
    //! The same soup in which some triangles are to have the shape that they have at x. Weights stay.
    //! \param which per triangle; those that are flipped at x keep their rest shape
    [[nodiscard]] std::shared_ptr<const Soup> shapedAs(const std::vector<double> &x,
                                                       const std::vector<bool> &which) const;
};

//! The coordinates as one row per soup corner.
inline UvMatrix rowsOf(const std::vector<double> &x)
{
    return Eigen::Map<const UvMatrix>(x.data(), static_cast<Eigen::Index>(x.size() / 2), 2);
}

//! Determinant of the Jacobian of triangle t at x: signed area in UV over area at rest.
inline double jacobianDeterminant(const Soup &soup, const double *x, int t)
{
    const double *p = x + 6 * static_cast<std::ptrdiff_t>(t);
    const Soup::Basis &b = soup.basis[t];
    const double restFactor = b[2] * b[5] - b[3] * b[4]; // 1 / twice the area at rest
    return ((p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0])) * restFactor;
}

} // namespace autocuts
