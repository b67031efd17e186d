// Compression with a bound on what comes out.
#pragma once

#include <QByteArray>

#include <optional>

namespace autocuts {

//! The bytes as a zlib stream.
QByteArray deflated(QByteArrayView bytes);

//! True when a zlib stream of so many bytes can hold `size` bytes at all: a size that is damaged or made up
//! is found before memory is taken for it.
bool canInflateTo(qsizetype packedSize, qint64 size);

//! What deflated() was given; nothing when the stream is damaged or does not give exactly `size` bytes. Takes
//! `size` bytes of memory, whatever the stream holds.
std::optional<QByteArray> inflated(QByteArrayView packed, qint64 size);

} // namespace autocuts
