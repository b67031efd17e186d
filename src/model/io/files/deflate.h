// Compression, and decompression with a limit on the size of the result.
#pragma once

#include <QByteArray>

#include <optional>

namespace autocuts {

//! Compresses the bytes to a zlib stream.
QByteArray deflated(QByteArrayView bytes);

//! True when a zlib stream of the given size can hold `size` bytes. Detects a damaged or forged size before
//! memory is allocated for it.
bool canInflateTo(qsizetype packedSize, qint64 size);

//! Decompresses a stream of deflated(); nothing when it is damaged or does not give exactly `size` bytes.
//! Allocates `size` bytes, whatever the stream contains.
std::optional<QByteArray> inflated(QByteArrayView packed, qint64 size);

} // namespace autocuts
