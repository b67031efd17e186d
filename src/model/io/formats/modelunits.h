// The units and axes of models: what their coordinates are in the world.
#pragma once

#include "model/document/scene.h"

namespace autocuts {

//! How the coordinates of a Scene lie in the world, in which y points up and a unit is a metre.
struct ModelUnits
{
    double metres = 1; //!< one unit
    bool zUp = false;  //!< z points up, and y to the back

    bool operator==(const ModelUnits &) const = default;
};

//! FBX files say their unit. glTF, Collada and Blender files are read in metres. OBJ files say nothing: as in
//! Blender, a unit is a metre and y points up; in PLY and STL files z does.
ModelUnits unitsOf(const Scene &scene);
//! Those of new files of a format. \param format lower-case suffix
ModelUnits unitsOfFormat(const QString &format);

//! From one kind of coordinates to another. Numbers stay exact where only axes change.
PositionMatrix inUnits(const PositionMatrix &positions, const ModelUnits &from, const ModelUnits &to);
//! The same as a matrix.
Eigen::Matrix4d unitChange(const ModelUnits &from, const ModelUnits &to);

//! The scene with its coordinates in other units; its source goes, since it has those of the file.
Scene inUnitsOf(Scene scene, const ModelUnits &units);

} // namespace autocuts
