// Relaxes some faces of a map while the rest stays where it is.
#pragma once

#include "model/plain/meshdata.h"
#include "solver/base/jobcontext.h"

#include <utility>
#include <vector>

namespace autocuts::homotopy {

//! The faces to solve for, the points to hold and the points with a target. A *point* is a UV vertex, named
//! by its first corner (UvTopology::cornerRoot).
struct LocalProblem
{
    std::vector<int> faces;         //!< faces to solve for, ascending
    std::vector<int> reference;     //!< faces that define the scale of the map, ascending; empty: `faces`
    std::vector<int> pointOfCorner; //!< point of each corner of the mesh
    std::vector<int> held;          //!< points that do not move
    std::vector<std::pair<int, Vec2>> targets; //!< points and their targets in the texture
};

struct LocalSolution
{
    enum class Outcome {
        Solved,
        Empty, //!< there is nothing that can move
        Stuck, //!< the targets cannot be reached without flipping a triangle
        Cancelled
    };

    Outcome outcome = Outcome::Empty;
    UvMatrix uv;                  //!< one row per corner; the input unless Solved
    int foldedFaces = 0;          //!< faces left as they were because one of their triangles is flipped
    double before = 0, after = 0; //!< mean symmetric Dirichlet energy of the faces at the scale of the map
};

//! Moves the points to their targets and minimises the symmetric Dirichlet energy of the faces, by Newton
//! steps that never flip a triangle. Points of other faces stay unless they are targets. Faces that are
//! mirrored as a whole are solved mirrored. Faces without area in 3D follow their points.
//! \param uv one row per corner, texture space
LocalSolution solveLocally(const MeshData &mesh, const UvMatrix &uv, const LocalProblem &problem,
                           const JobContext &job = {});

} // namespace autocuts::homotopy
