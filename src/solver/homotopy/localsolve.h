// Solving a part of a map while the rest stays where it is.
#pragma once

#include "model/plain/meshdata.h"
#include "solver/base/jobcontext.h"

#include <atomic>
#include <functional>
#include <utility>
#include <vector>

namespace autocuts::homotopy {

//! What may move, what is held, and where it should go. A *point* is a UV vertex, named by its first corner
//! (UvTopology::cornerRoot).
struct LocalProblem
{
    std::vector<int> faces;                    //!< that are solved for, rising
    std::vector<int> reference;                //!< faces that say how large the map is; empty: `faces`
    std::vector<int> pointOfCorner;            //!< per corner of the mesh
    std::vector<int> held;                     //!< points that stay
    std::vector<std::pair<int, Vec2>> targets; //!< points that go to places of the texture
};

struct LocalSolution
{
    enum class Outcome {
        Solved,
        Empty, //!< nothing can move
        Stuck, //!< the targets cannot be reached without turning a triangle over
        Cancelled
    };

    Outcome outcome = Outcome::Empty;
    UvMatrix uv;                  //!< one row per corner; unless solved as it was
    int foldedFaces = 0;          //!< left as they were because a triangle of them is turned over
    double before = 0, after = 0; //!< mean symmetric Dirichlet energy of the faces at the size of the map
};

//! Brings the points to their targets and makes the symmetric Dirichlet energy of the faces small, by Newton
//! steps that never turn a triangle over. Points of other faces stay unless they are targets. A part that is
//! mirrored as a whole is solved as it lies. Faces without area in 3D follow their points.
//! \param uv one row per corner, texture space
LocalSolution solveLocally(const MeshData &mesh, const UvMatrix &uv, const LocalProblem &problem,
                           const JobContext &job = {});

} // namespace autocuts::homotopy
