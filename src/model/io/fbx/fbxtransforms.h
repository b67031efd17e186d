// Where the models of an FBX file stand in their parents.
#pragma once

#include "model/plain/types.h"

#include <Eigen/Geometry>

namespace autocuts {

class FbxProperties;

//! What moves in the transform of a model.
struct FbxPlacing
{
    Vec3 translation, rotation, scaling; //!< rotation: Euler angles in degrees
};

//! As the properties of the model say.
FbxPlacing fbxPlacing(const FbxProperties &p);

//! The transform of a model in its parent (FBX SDK, "Computing transformation matrices"). While
//! RotationActive is not set, the rotation has the order x, y, z and nothing before and behind it.
Eigen::Affine3d fbxLocalTransform(const FbxProperties &p, const FbxPlacing &placing);

} // namespace autocuts
