// Makes .blend files readable for Assimp, which loses objects whose names begin alike.
#pragma once

#include <string>
#include <vector>

namespace autocuts {

//! A .blend file in which object n is called blendName(n), and the names that its objects had.
struct BlendObjects
{
    std::string bytes;
    std::vector<std::string> names;
};

//! Assimp sorts objects by the characters that both names have, and leaves out one of "Cube" and "Cube.001".
//! \param bytes of a .blend file as Blender writes it, also compressed by gzip; damaged ones keep what is not
//! understood
BlendObjects withDistinctNames(std::string bytes);

//! All such names have one length.
std::string blendName(std::size_t number);

} // namespace autocuts
