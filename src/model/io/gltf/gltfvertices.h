// Splits and joins the vertices of a primitive so that its corners can have other UVs.
#pragma once

#include "model/io/gltf/gltfelements.h"

#include <array>
#include <vector>

namespace autocuts {

//! The UVs of one set as the file stores them, one for each corner.
using FileUvs = std::vector<std::array<float, 2>>;

//! New vertices for the corners of a primitive.
struct GltfVertexMap
{
    std::vector<std::uint32_t> oldVertex;    //!< of each new vertex: an old one with its other attributes
    std::vector<std::uint32_t> corner;       //!< of each new vertex: one of its corners
    std::vector<std::uint32_t> cornerVertex; //!< the new vertex of each corner
    //! No vertex was split and none joined, so the old vertices can stay.
    bool same = false;
};

//! Makes as few vertices as possible: corners share one when the attributes that stay and all new UVs have
//! the same bits. Vertices keep their order; those that splitting adds follow.
//! \param corners the old vertex of each corner \param kept attributes that stay, of all old vertices
//! \param uvs the sets that change
GltfVertexMap mapVertices(const std::vector<std::uint32_t> &corners,
                          const std::vector<const GltfElements *> &kept, const std::vector<FileUvs> &uvs);

} // namespace autocuts
