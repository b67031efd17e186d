#include "model/io/files/deflate.h"

#include <zlib.h>

namespace autocuts {

namespace {

//! The largest ratio of content to compressed size that a zlib stream can have (zlib technical details).
constexpr qint64 largestExpansion = 1032;
constexpr qint64 largestSize = qint64(4) << 30;

} // namespace

QByteArray deflated(QByteArrayView bytes)
{
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    QByteArray packed(static_cast<qsizetype>(size), Qt::Uninitialized);
    compress2(reinterpret_cast<Bytef *>(packed.data()), &size, reinterpret_cast<const Bytef *>(bytes.data()),
              static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION);
    packed.truncate(static_cast<qsizetype>(size));
    packed.squeeze();
    return packed;
}

bool canInflateTo(qsizetype packedSize, qint64 size)
{
    return size >= 0 && size <= largestSize && size / largestExpansion <= packedSize;
}

std::optional<QByteArray> inflated(QByteArrayView packed, qint64 size)
{
    if (!canInflateTo(packed.size(), size))
        return std::nullopt;
    QByteArray bytes(static_cast<qsizetype>(size), Qt::Uninitialized);
    uLongf got = static_cast<uLongf>(size);
    const int outcome =
        uncompress(reinterpret_cast<Bytef *>(bytes.data()), &got,
                   reinterpret_cast<const Bytef *>(packed.data()), static_cast<uLong>(packed.size()));
    if (outcome != Z_OK || got != static_cast<uLongf>(size))
        return std::nullopt;
    return bytes;
}

} // namespace autocuts
