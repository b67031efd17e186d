// The project's own FBX reader. Together with fbxrewriter it preserves everything but the UVs.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QByteArray>

#include <atomic>

namespace autocuts {

//! Reads binary and text FBX files of version 6.1 to 7.7: polygons in world space, objects (models),
//! materials, UV sets and hard edges. Everything else stays in the FbxSource of the scene. A geometry that
//! several models show is in the soup once for each; the file holds one map for all of them. The corner order
//! of mirrored models is reversed, so that their faces still point outwards. Sets of several objects belong
//! together by FbxUvSets. Points, lines, and faces that cannot be unwrapped are left out and mentioned in the
//! notes, as are UV sets whose data do not fit. \param stop ends the reading with an Error when it becomes
//! true; null: never
Result<Scene> readFbx(const QString &path, const std::atomic<bool> *stop = nullptr);

//! Reads from bytes in memory; `path` is used in messages and for Scene::path.
Result<Scene> parseFbx(QByteArray bytes, const QString &path, const std::atomic<bool> *stop = nullptr);

} // namespace autocuts
