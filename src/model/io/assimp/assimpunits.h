// Units and axes that Assimp's importers leave out, in the reader.
#pragma once

#include <string>

struct aiScene;

namespace autocuts {

//! Turns the root of a scene from the unit and the axes of its file to metres with y up, where Assimp does
//! not: 3MF, AMF and OpenGEX files say theirs, trueSpace, Valve and 3D GameStudio files have z up. \param
//! suffix lower-case
void completeUnits(aiScene &scene, const std::string &suffix, const std::string &path);

} // namespace autocuts
