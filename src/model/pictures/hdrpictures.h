// Pictures in Radiance HDR files (RGBE).
#pragma once

#include "model/document/result.h"
#include "model/plain/picture.h"

#include <QByteArrayView>

namespace autocuts {

//! Whether the bytes begin as a Radiance HDR file does.
bool isHdr(QByteArrayView bytes);

//! Reads RGBE colours: plain ones and both kinds of runs. Greg Ward, "Real Pixels", Graphics Gems II, 1991,
//! and the description of the format by Radiance (RGBE files, "picture" file format).
Result<Picture> readHdr(QByteArrayView bytes, const QString &path);

} // namespace autocuts
