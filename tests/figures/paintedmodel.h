// A model as an artist might paint it, for a figure.
#pragma once

#include "model/document/scene.h"

namespace autocuts::figures {

//! The mesh in 16 times as many triangles, smooth, with scales on its skin, and vertex colours: stripes on
//! the back, a pale belly. \param up the direction away from the belly
Scene paintedModel(const MeshData &mesh, const Vec3 &up);

//! The scene as an OBJ file with vertex colours.
QByteArray coloredObj(const Scene &scene);

} // namespace autocuts::figures
