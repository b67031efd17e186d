// Writes new FBX files, of scenes that come from no FBX file.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QByteArray>

namespace autocuts {

//! A binary FBX file of version 7.4, in metres with y up: materials with their pictures, all UV sets in their
//! order, vertex colours, and the normals and smoothing groups of an OBJ file, as far as there are no more
//! than 32. What Assimp has read keeps its nodes, normals, cameras, lights, bones and animations; of other
//! scenes each object is one mesh and one model in world space. Corners without UV have none. \param path of
//! the file, which pictures are named from
QByteArray fbxBytes(const Scene &scene, const QString &path = {});

//! Writes that.
Result<Done> writeNewFbx(const Scene &scene, const QString &path);

} // namespace autocuts
