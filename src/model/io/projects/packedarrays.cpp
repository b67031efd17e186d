#include "model/io/projects/packedarrays.h"

#include <cstring>

namespace autocuts {

namespace {

//! \tparam Bits unsigned integer of the size of T
template <typename Bits, typename T>
QByteArray packed(std::span<const T> values)
{
    static_assert(sizeof(Bits) == sizeof(T));
    const std::size_t count = values.size();
    QByteArray bytes(static_cast<qsizetype>(count * sizeof(T)), Qt::Uninitialized);
    char *out = bytes.data();
    for (std::size_t i = 0; i < count; ++i) {
        Bits bits;
        std::memcpy(&bits, &values[i], sizeof bits);
        for (std::size_t plane = 0; plane < sizeof(T); ++plane)
            out[plane * count + i] = static_cast<char>(bits >> (8 * plane));
    }
    return bytes;
}

template <typename Bits, typename T>
std::optional<std::vector<T>> unpacked(const QByteArray &bytes, qsizetype count)
{
    if (count < 0 || bytes.size() / qsizetype(sizeof(T)) != count || bytes.size() % qsizetype(sizeof(T)) != 0)
        return std::nullopt;
    std::vector<T> values(static_cast<std::size_t>(count));
    const char *in = bytes.constData();
    for (qsizetype i = 0; i < count; ++i) {
        Bits bits = 0;
        for (qsizetype plane = 0; plane < qsizetype(sizeof(T)); ++plane)
            bits |= static_cast<Bits>(static_cast<unsigned char>(in[plane * count + i])) << (8 * plane);
        std::memcpy(&values[static_cast<std::size_t>(i)], &bits, sizeof bits);
    }
    return values;
}

qsizetype countOf(const QByteArray &bytes, qsizetype size)
{
    return bytes.size() % size == 0 ? bytes.size() / size : -1;
}

} // namespace

QByteArray packedArray(std::span<const int> values)
{
    return packed<quint32>(values);
}

QByteArray packedArray(std::span<const double> values)
{
    return packed<quint64>(values);
}

std::optional<std::vector<int>> unpackedIntegers(const QByteArray &bytes, qsizetype count)
{
    return unpacked<quint32, int>(bytes, count);
}

std::optional<std::vector<double>> unpackedDoubles(const QByteArray &bytes, qsizetype count)
{
    return unpacked<quint64, double>(bytes, count);
}

qsizetype packedIntegerCount(const QByteArray &bytes)
{
    return countOf(bytes, sizeof(int));
}

qsizetype packedDoubleCount(const QByteArray &bytes)
{
    return countOf(bytes, sizeof(double));
}

} // namespace autocuts
