// How files of each format are read and written: the functions of the formats, one row for each.
#pragma once

#include "model/io/formats/filesource.h"

#include <atomic>

namespace autocuts {

struct FormatCalls
{
    QString suffix; //!< in lower case
    Result<Scene> (*read)(const QString &path, const std::atomic<bool> *stop);
    //! A new file, of a scene from another format; null: none is written.
    SceneWriter write = nullptr;
    //! It is of what Assimp reads of the scene's file: with nodes, bones and animations.
    bool takesNodes = false;
    //! The files that are written besides the path; null: none.
    QStringList (*filesBeside)(const Scene &scene, const QString &path) = nullptr;
};

//! The calls for a format; those of Assimp's reader where it has no row. \param suffix lower-case
const FormatCalls &callsOf(const QString &suffix);

} // namespace autocuts
