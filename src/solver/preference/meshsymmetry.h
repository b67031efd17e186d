// Plane of symmetry of a mesh.
#pragma once

#include "model/plain/meshdata.h"
#include "solver/base/jobcontext.h"

#include <optional>
#include <vector>

namespace autocuts::preference {

//! A plane of symmetry and the mirror images of vertices and edges.
struct MeshSymmetry
{
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitX(); //!< the plane; the normal has unit length
    std::vector<int> mirrorVertex; //!< per vertex: itself on the plane; -1: none, or not a welded vertex
    std::vector<int> mirrorEdge;   //!< per edge pair; -1 without a mirror image and on diagonals
    double matchedShare = 0; //!< share of the length of all edges except diagonals that has a mirror image
    double matchedArea =
        0; //!< share of the area whose vertices all have one, however it is split into triangles
};

enum class Exactness {
    Exact, //!< 95 % of the edge length match
    Loose
};

//! Looks for a plane of symmetry: first across x, y and z through the middle, then across the principal axes.
//! Points match within a tenth of the mean edge length. Where less than 95 % of the edge length match, the
//! planes are moved to fit best, and points match within 0.6 of it: sculpts are never exact, and
//! triangles may be split the other way on the other side. \returns the plane with the greatest share of
//! matching edge length; nothing when less than three quarters of the area match, or less than 45 % of the
//! edges, or when the job is stopped
std::optional<MeshSymmetry> findSymmetry(const MeshData &mesh, Exactness exactness = Exactness::Loose,
                                         const JobContext &job = {});

//! Share of the length of the cut edges whose mirror images are cut as well; 1 without any cut.
double symmetricShare(const MeshData &mesh, const MeshSymmetry &symmetry, const std::vector<bool> &cut);

} // namespace autocuts::preference
