// Pictures in OpenEXR files.
#pragma once

#include "model/document/result.h"
#include "model/plain/picture.h"

#include <QByteArray>
#include <QByteArrayView>

namespace autocuts {

//! Whether the bytes begin as an OpenEXR file does.
bool isExr(QByteArrayView bytes);

//! Reads the first part, scan lines or the largest level of tiles, without any exception of the library. The
//! colours are those of the layer without a name, or else of the first one that has some: channels whose
//! names end in R, G, B, A, or Y. A file with no such channel gives its first one as grey. Pixels of the
//! display window that have no data are 0.
Result<Picture> readExr(QByteArrayView bytes, const QString &path);

//! The bytes of a file. \param half numbers of 16 bits instead of 32
Result<QByteArray> exrBytes(const Picture &picture, bool half, const QString &path);

} // namespace autocuts
