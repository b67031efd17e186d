// The project's own OBJ reader. Together with objwriter it preserves every byte that does not state a UV.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QByteArray>

#include <atomic>

namespace autocuts {

//! Reads polygons, objects (o), materials (usemtl), the colours in the files of its materials, UVs and vertex
//! colours (three numbers behind a vertex).
//! Everything else stays in the ObjSource of the scene. The scene has one UV set, or none when no face uses a
//! vt. The row of a corner is not finite when its vt is missing or not finite. Faces of fewer than three
//! different vertices are left out and mentioned in the notes. Errors name the line: wrong indices,
//! coordinates that are not finite numbers, truncated or binary data. \param stop ends the reading with an
//! Error when it becomes true; null: never
Result<Scene> readObj(const QString &path, const std::atomic<bool> *stop = nullptr);

//! Reads from bytes in memory; `path` is used in messages and for Scene::path.
Result<Scene> parseObj(QByteArray bytes, const QString &path, const std::atomic<bool> *stop = nullptr);

} // namespace autocuts
