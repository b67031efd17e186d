// Finds outputs that would overwrite what a job reads, or each other.
#pragma once

#include "model/document/result.h"

#include <QStringList>

namespace autocuts {

struct DocumentState;
struct Scene;

//! The same for all paths that lead to one file, also by links. A file that is not there yet is known by its
//! folder and its name.
QByteArray fileKey(const QString &path);

//! An Error when a file that is to be written is one of those that must stay, or is written twice. Empty
//! paths count for nothing.
Result<Done> checkOutputs(const QStringList &written, const QStringList &kept);

//! The files that a model was read from besides its own one: buffers, material libraries and textures, as far
//! as they are there. \param onlyBaseColors leaves out textures that no bake reads, which may be its results
QStringList filesBeside(const DocumentState &model, bool onlyBaseColors = false);

//! The files that no output of the studio may replace: those of the session, of its model, and beside that
//! one. \param sessionPath empty when there is none
QStringList filesOfSession(const DocumentState &model, const QString &sessionPath,
                           bool onlyBaseColors = false);

//! The files that belong to a model or session that is written to a path: buffers, material libraries,
//! pictures, or backups. \param scene the model that is written
QStringList filesWrittenBeside(const QString &path, const Scene &scene);

//! A path of pictures that get the number of a tile before the suffix, with those that are there already.
QStringList withTiles(const QString &path);

} // namespace autocuts
