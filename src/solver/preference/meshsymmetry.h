// The reflection that maps a mesh onto itself.
#pragma once

#include "model/plain/meshdata.h"

#include <optional>
#include <vector>

namespace autocuts::preference {

//! A plane and what lies where its mirror image does.
struct MeshSymmetry
{
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitX(); //!< the plane; the normal has unit length
    std::vector<int> mirrorVertex; //!< per vertex (welded ones, others -1); itself on the plane, -1: none
    std::vector<int> mirrorEdge;   //!< per edge pair, -1 without a partner and on diagonals
    double matchedShare = 0;       //!< of the length of all edges but diagonals
};

//! Looks for a plane of symmetry: first across x, y and z through the middle, then across the principal axes.
//! Points match within a tenth of the mean edge length. \returns the plane under which most of the length of
//! the edges matches; nothing when that is less than 95 %: the mesh is not symmetric, or its triangulation is
//! not
std::optional<MeshSymmetry> findSymmetry(const MeshData &mesh);

//! Share of the length of the cut edges whose mirror images are cut as well; 1 without any cut.
double symmetricShare(const MeshData &mesh, const MeshSymmetry &symmetry, const std::vector<bool> &cut);

} // namespace autocuts::preference
