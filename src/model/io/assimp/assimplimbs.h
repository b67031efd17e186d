// Tells from the reader to the program which nodes the file calls bones; Assimp has no place for that.
#pragma once

#include <set>
#include <string>

struct aiNode;

namespace autocuts {

//! Notes at a node that the file calls it a bone.
void markLimb(aiNode &node);
//! The names of the nodes with such notes, which are removed.
std::set<std::string> takeLimbs(aiNode &node);

} // namespace autocuts
