// Assimp's scene as bytes: how the program autocuts-reader gives it to the one that asked for it.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>

struct aiScene;

namespace autocuts {

//! The exit codes of autocuts-reader. Its standard output holds the scene after Done, after Unreadable the
//! reason in UTF-8 behind the last zero byte, and nothing of use after anything else.
namespace readerexit {
inline constexpr int done = 0, unreadable = 1, outOfMemory = 3;
}

//! Writes everything that exporting needs: nodes, meshes with all their data, materials, textures,
//! animations, cameras, lights and metadata. The form is that of this machine; both programs must be of one
//! version. Sets counts without data to 0. \throws std::runtime_error when the file cannot be written or the
//! nodes are nested too deeply
void writeAssimpScene(aiScene &scene, std::FILE *file);

//! Rebuilds the scene of writeAssimpScene(). Bytes of any content are safe: sizes are compared with what is
//! left before memory is taken. Indices of nodes to meshes, faces and bones to vertices, and meshes to
//! materials are as in the file; who uses them checks them. \param memory the scene may take as many bytes
//! \throws std::runtime_error when the bytes are not what writeAssimpScene() writes, or need more memory
std::unique_ptr<aiScene> readAssimpScene(std::span<const char> bytes, std::size_t memory);

} // namespace autocuts
