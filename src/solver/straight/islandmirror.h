// Which islands are mirror images of themselves or of each other.
#pragma once

#include "solver/straight/linenewton.h"

namespace autocuts::straight {

//! The mirror image of an island.
struct IslandMirror
{
    int island = -1;     //!< that is the image; -1: none
    MirrorPoints points; //!< per point: its image there
};

//! Per island: its mirror image under a plane of symmetry, where seams are symmetric as well. First that of
//! the mesh is tried, then one of the island. Not all are found when stopped.
std::vector<IslandMirror> mirrorsOf(const MeshData &mesh, const std::vector<Island> &islands,
                                    const JobContext &job = {});

//! Turns and moves an island so that it lies about symmetric to the line u = 0.
void placeAtAxis(Positions &positions, const MirrorPoints &mirror);

} // namespace autocuts::straight
