// Writing a file so that a failure leaves the one that was there untouched.
#pragma once

#include "model/document/result.h"

#include <QByteArrayView>
#include <QString>

#include <functional>

namespace autocuts {

//! Writes the bytes to a temporary file beside the target and renames it over the target. On any error (no
//! such folder, no permission, disk full) an existing file keeps its content and no temporary file is left.
//! \param beforeReplacing called when the bytes are safe on disk and the old file is still in place
Result<Done> saveAtomically(const QString &path, QByteArrayView bytes,
                            const std::function<void()> &beforeReplacing = {});

//! The bytes of a regular file, or an Error that says why it cannot be read: missing, a folder, a device, no
//! permission, larger than `limit` bytes.
Result<QByteArray> loadFile(const QString &path, qint64 limit);

} // namespace autocuts
