// Formats that only Assimp writes get more from a model that our own readers read: the same file as Assimp
// reads it, with the UVs of the scene.
#pragma once

#include "model/document/scene.h"
#include "model/io/assimp/assimpreader.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace autocuts {

//! The scene as Assimp reads a file of these bytes, with the UV sets of `scene`. Faces are matched by their
//! places. Nothing when Assimp does not read the file, or a face of `scene` is not among those of the other;
//! that may have more, such as faces without area. Waits for the program that reads it; not for the GUI
//! thread. Materials are those of `scene`. \param suffix of the format of the bytes \param placement of what
//! Assimp reads, to metres with y up \param complete as for readWithAssimp()
std::optional<Scene> asAssimpReads(const Scene &scene, const QByteArray &bytes, const QString &suffix,
                                   const Eigen::Matrix4d &placement = Eigen::Matrix4d::Identity(),
                                   const CompleteScene &complete = {});

} // namespace autocuts
