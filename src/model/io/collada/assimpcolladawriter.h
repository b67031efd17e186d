// Writes new Collada files by Assimp.
#pragma once

#include "model/document/result.h"
#include "model/document/scene.h"

#include <QStringList>

namespace autocuts {

//! Writes a scene that was not read from a Collada file, or from one whose text is not understood.
Result<Done> writeNewCollada(const Scene &scene, const QString &path);

//! The pictures that go with it.
QStringList filesBesideCollada(const Scene &scene, const QString &path);

} // namespace autocuts
