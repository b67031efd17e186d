// Saves files atomically: a failure leaves the existing file unchanged.
#pragma once

#include "model/document/result.h"

#include <QByteArrayView>
#include <QString>

#include <functional>

namespace autocuts {

//! Writes the bytes to a temporary file beside the target and renames it to the target. On any error (missing
//! folder, no permission, disk full) an existing file keeps its content and no temporary file is left.
//! \param beforeReplacing called when the bytes are safely on disk and the old file is still in place
Result<Done> saveAtomically(const QString &path, QByteArrayView bytes,
                            const std::function<void()> &beforeReplacing = {});

//! The bytes of a regular file, or an Error that says why it cannot be read: it is missing, a folder, a
//! device, not readable, or larger than `limit` bytes.
Result<QByteArray> loadFile(const QString &path, qint64 limit);

//! What a reader says that was told to stop.
Error readingCancelled(const QString &path);

} // namespace autocuts
