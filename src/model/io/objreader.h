// The project's own OBJ reader; together with objwriter it gives back every byte that is not a UV.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QByteArray>

namespace autocuts {

//! Reads polygons, objects (o), materials (usemtl) and UVs. Everything else stays in the ObjSource of the
//! scene. One UV set, or none when the file has no vt that a face uses; a corner whose vt is missing or not
//! finite has a non-finite row. Faces of fewer than three different vertices are left out and noted. Errors
//! name the line: wrong indices, coordinates that are no finite numbers, truncated or binary data.
Result<Scene> readObj(const QString &path);

//! The same from bytes in memory; `path` is for messages and for Scene::path.
Result<Scene> parseObj(QByteArray bytes, const QString &path);

} // namespace autocuts
