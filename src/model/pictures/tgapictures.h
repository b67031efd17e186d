// Pictures in TGA files: Qt reads only those without runs, and writes none.
#pragma once

#include "model/document/result.h"
#include "model/plain/picture.h"

#include <QByteArray>
#include <QByteArrayView>

namespace autocuts {

//! Whether the header is that of a TGA file that can be read. The format has no mark of its own at its front.
bool isTga(QByteArrayView bytes);

//! Reads grey pictures of 8 bits, colours of 15, 16, 24 and 32 bits and those with a palette, with runs or
//! without. Truevision TGA File Format Specification, version 2.0.
Result<Picture> readTga(QByteArrayView bytes, const QString &path);

//! The bytes of a file without runs. \param pixels rows from the top, R, G, B, A or fewer channels as in
//! Picture, 8 bits each
QByteArray tgaBytes(QByteArrayView pixels, int width, int height, int channels);

} // namespace autocuts
