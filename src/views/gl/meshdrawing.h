// What is drawn of a mesh, whatever its map is.
#pragma once

#include "views/gl/meshframe.h"
#include "views/gl/soupbuffers.h"
#include "views/gl/souptopology.h"

#include <memory>
#include <vector>

namespace autocuts {

//! Depends on the mesh only, so it is made on the thread that reads the model, and the views share it. Takes
//! long.
struct MeshDrawing
{
    //! \param hardEdges as in Scene::hardEdges
    MeshDrawing(std::shared_ptr<const MeshData> m, const std::vector<bool> &hardEdges)
        : mesh(std::move(m)), frame(MeshFrame::of(*mesh)), topology(*mesh),
          vertices(soupVertices(*mesh, hardEdges, frame))
    {}

    std::shared_ptr<const MeshData> mesh;
    MeshFrame frame;
    SoupTopology topology;
    std::vector<SoupVertex> vertices;
};

} // namespace autocuts
