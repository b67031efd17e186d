// Objects that share a mesh: the file has one map for all of them.
#pragma once

#include "model/document/scene.h"
#include "model/plain/islandflags.h"

namespace autocuts {

//! True when objects share a mesh, and each can get one of its own in the written file.
bool hasSharedMeshes(const Scene &scene);

//! The scene with the UVs that a file of a format will have: objects that share a mesh get the map of the one
//! that is written. \param format lower-case suffix; that of sessions stands for that of the model's file
//! \param tileHeight of the texture that the UVs are for, see tilescaling.h
Scene asWritten(const Scene &scene, const QString &format, double tileHeight = 1);

//! Counts equal islands of objects that share a mesh in the scene's file as deliberate stacks. Islands that
//! are in a stack already stay in it. \param flags per face; empty: none
std::vector<IslandFlags> withInstanceStacks(const Scene &scene, std::vector<IslandFlags> flags);

} // namespace autocuts
