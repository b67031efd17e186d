// Cameras and lights in new Collada files, of which Assimp's exporter leaves things out.
#pragma once

#include <string>
#include <string_view>

struct aiScene;

namespace autocuts {

//! Blender shows a light of one watt, or a sun of one watt per square metre, as so many lumens.
inline constexpr double lumensPerWatt = 683;

//! The text of a Collada file with orthographic cameras, and with the strengths of lights where Blender looks
//! for them. \param text as Assimp writes it \param scene that was written \param fromGltf the strengths are
//! those of glTF; those of other formats are taken as in watts
std::string withViews(std::string_view text, const aiScene &scene, bool fromGltf);

} // namespace autocuts
