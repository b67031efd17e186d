// The model inside a session, so that the session opens without the file it came from.
#pragma once

#include "model/document/result.h"
#include "model/io/projectstate.h"

namespace autocuts {

//! The parts "scene" and, for a model from an OBJ file, "obj" with that file's bytes; else "polygons".
PartMap scenePartsOf(const Scene &scene);

//! The scene without its UV sets. An Error when the model is damaged; when only its names are, `lost` tells.
//! \param path of the session, for messages
Result<Scene> readSceneParts(const PartMap &parts, const QString &path, QStringList &lost);

//! What of the file that the model came from is not in a session, one line each; empty for OBJ.
QStringList sessionLosses(const Scene &scene);

} // namespace autocuts
