// The blocks of a session that hold the model, so that a session opens without the model's file.
#pragma once

#include "model/document/result.h"
#include "model/io/projects/projectstate.h"

namespace autocuts {

//! The blocks "scene" and, for a model from an OBJ or FBX file, "obj" or "fbx" with the bytes of that file,
//! or else "polygons"; for a model from a glTF file also "gltf", with its bytes and those of its buffers.
PartMap scenePartsOf(const Scene &scene);

//! Reads the scene without its UV sets. Error when the model is damaged; when only its names are, `lost` says
//! so.
//! \param path path of the session, used in messages
Result<Scene> readSceneParts(const PartMap &parts, const QString &path, QStringList &lost);

//! The path of the model's file in the block "scene"; empty when there is none or the block is damaged.
QString modelPathIn(const QByteArray &sceneBlock);

//! Data of the model's file that a session does not hold, one line each; empty for OBJ, FBX and glTF.
QStringList sessionLosses(const Scene &scene);

} // namespace autocuts
