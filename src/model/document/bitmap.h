// Arrays of bits packed into bytes, as session files and undo entries store them: the lowest bit of a byte
// comes first.
#pragma once

#include <QByteArray>

namespace autocuts {

inline qsizetype bitmapSize(qsizetype bits)
{
    return (bits + 7) / 8;
}

inline bool bitAt(const QByteArray &bitmap, qsizetype i)
{
    return (bitmap[i / 8] >> (i % 8) & 1) != 0;
}

inline void setBit(QByteArray &bitmap, qsizetype i)
{
    bitmap[i / 8] = static_cast<char>(bitmap[i / 8] | 1 << i % 8);
}

} // namespace autocuts
