#include "commands/xordelta.h"

#include "model/document/bitmap.h"
#include "model/document/undostack.h"

#include <QtEndian>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

//! Compressed bits, in blocks from a pool. The pool keeps them away from the megabytes that each edit
//! allocates and frees: with plain allocations the heap grew to ten times the size of its contents.
struct XorDelta::PackedBits
{
    PackedBits(std::shared_ptr<std::pmr::memory_resource> p, std::span<const int> o)
        : pool(std::move(p)), blocks(pool.get()), order(o)
    {}

    std::shared_ptr<std::pmr::memory_resource> pool;
    std::pmr::vector<std::pmr::vector<char>> blocks;
    std::span<const int> order; //!< the order in which the elements were packed
};

namespace {

//! Bytes; smaller deltas are not packed. Chosen by hand; its effect has not been measured.
constexpr qsizetype packThreshold = 1024;
//! Of zlib. Higher levels hardly make the byte planes smaller; no figures were kept.
constexpr int deflateLevel = 1;

//! Positions in the delta (0, ..., count - 1) in the order of packing.
std::vector<int> packingOrder(const IndexRanges &indices, std::span<const int> order)
{
    std::vector<int> positions;
    positions.reserve(indices.count());
    if (order.empty()) {
        for (int i = 0; i < indices.count(); ++i)
            positions.push_back(i);
        return positions;
    }
    std::vector<int> positionOf(order.size(), -1);
    int next = 0;
    indices.forEach([&](int index) { positionOf[index] = next++; });
    for (int index : order) {
        if (positionOf[index] >= 0)
            positions.push_back(positionOf[index]);
    }
    return positions;
}

//! A bitmap of the elements that differ from the one before, then the byte planes of these elements.
QByteArray packedBits(const QByteArray &bits, int size, const std::vector<int> &order)
{
    std::vector<const char *> kept;
    QByteArray result(bitmapSize(std::ssize(order)), '\0');
    for (qsizetype i = 0; i < std::ssize(order); ++i) {
        const char *element = bits.constData() + qsizetype(size) * order[i];
        if (!kept.empty() && std::memcmp(element, kept.back(), size) == 0)
            continue;
        setBit(result, i);
        kept.push_back(element);
    }
    qsizetype at = result.size();
    result.resize(at + size * static_cast<qsizetype>(kept.size()));
    for (int plane = 0; plane < size; ++plane) {
        for (const char *element : kept)
            result[at++] = element[plane];
    }
    return result;
}

//! The inverse of packedBits(); nothing when the data are inconsistent.
std::optional<QByteArray> unpackedBits(const QByteArray &packed, int size, const std::vector<int> &order)
{
    const qsizetype planes = bitmapSize(std::ssize(order));
    if (packed.size() < planes)
        return {};
    qsizetype kept = 0;
    for (qsizetype i = 0; i < std::ssize(order); ++i)
        kept += bitAt(packed, i);
    if (packed.size() != planes + kept * size || (!order.empty() && !bitAt(packed, 0)))
        return {};
    QByteArray bits(static_cast<qsizetype>(size * order.size()), Qt::Uninitialized);
    qsizetype current = -1;
    for (qsizetype i = 0; i < std::ssize(order); ++i) {
        current += bitAt(packed, i);
        char *element = bits.data() + qsizetype(size) * order[i];
        for (int plane = 0; plane < size; ++plane)
            element[plane] = packed[planes + plane * kept + current];
    }
    return bits;
}

} // namespace

void XorDelta::append(int index, const char *before, const char *after)
{
    if (std::memcmp(before, after, mElementSize) == 0)
        return;
    mIndices.append(index);
    std::array<char, maxElementSize> bits;
    for (int i = 0; i < mElementSize; ++i)
        bits[i] = static_cast<char>(before[i] ^ after[i]);
    mBits.append(bits.data(), mElementSize);
}

QByteArray XorDelta::bits() const
{
    if (!mPacked)
        return mBits;
    QByteArray deflated;
    for (const auto &block : mPacked->blocks)
        deflated.append(block.data(), static_cast<qsizetype>(block.size()));
    // Only pack() makes packed bits, so unpacking cannot fail.
    return *unpackedBits(qUncompress(deflated), mElementSize, packingOrder(mIndices, mPacked->order));
}

void XorDelta::apply(const char *current, char *result) const
{
    const QByteArray all = bits();
    const char *bit = all.constData();
    mIndices.forEach([&](int index) {
        const char *element = current + qsizetype(mElementSize) * index;
        for (int i = 0; i < mElementSize; ++i)
            *result++ = static_cast<char>(*element++ ^ *bit++);
    });
}

void XorDelta::combine(const XorDelta &newer)
{
    // Lists are used instead of ranges, because a merge visits every element anyway.
    const auto listOf = [](const IndexRanges &indices) {
        std::vector<int> list;
        list.reserve(indices.count());
        indices.forEach([&](int i) { list.push_back(i); });
        return list;
    };
    const std::vector<int> mine = listOf(mIndices);
    const std::vector<int> theirs = listOf(newer.mIndices);
    const QByteArray myBits = bits();
    const QByteArray theirBits = newer.bits();
    const QByteArray zero(mElementSize, '\0');
    XorDelta result(mElementSize);
    result.mBits.reserve(std::max(myBits.size(), theirBits.size()));
    std::size_t a = 0;
    std::size_t b = 0;
    while (a < mine.size() || b < theirs.size()) {
        const bool takeMine = b == theirs.size() || (a < mine.size() && mine[a] <= theirs[b]);
        const bool takeTheirs = a == mine.size() || (b < theirs.size() && theirs[b] <= mine[a]);
        const int index = takeMine ? mine[a] : theirs[b];
        const char *x = takeMine ? myBits.constData() + qsizetype(mElementSize) * a++ : zero.constData();
        const char *y = takeTheirs ? theirBits.constData() + qsizetype(mElementSize) * b++ : zero.constData();
        result.append(index, x, y);
    }
    *this = std::move(result);
}

void XorDelta::pack(const std::shared_ptr<std::pmr::memory_resource> &pool, std::span<const int> order)
{
    mIndices.squeeze();
    mBits.squeeze();
    if (mBits.size() < packThreshold)
        return;
    const QByteArray deflated =
        qCompress(packedBits(mBits, mElementSize, packingOrder(mIndices, order)), deflateLevel);
    if (deflated.size() >= mBits.size())
        return;
    mBits = {};
    auto packed = std::make_shared<PackedBits>(pool, order);
    for (qsizetype at = 0; at < deflated.size(); at += UndoStack::poolBlockSize) {
        const char *block = deflated.constData() + at;
        packed->blocks.emplace_back(block, block + std::min(UndoStack::poolBlockSize, deflated.size() - at));
    }
    mPacked = std::move(packed);
}

qint64 XorDelta::byteCount() const
{
    qint64 bytes = mBits.capacity() + static_cast<qint64>(mIndices.ranges().capacity() * sizeof(IndexRange));
    if (mPacked) {
        for (const auto &block : mPacked->blocks)
            bytes += static_cast<qint64>(block.capacity());
    }
    return bytes;
}

XorDelta XorDelta::renumbered(std::span<const int> indices) const
{
    std::vector<std::size_t> rising(indices.size());
    std::iota(rising.begin(), rising.end(), std::size_t(0));
    std::sort(rising.begin(), rising.end(),
              [&](std::size_t a, std::size_t b) { return indices[a] < indices[b]; });
    const QByteArray all = bits();
    XorDelta result(mElementSize);
    result.mBits.reserve(all.size());
    for (std::size_t i : rising) {
        result.mIndices.append(indices[i]);
        result.mBits.append(all.constData() + qsizetype(mElementSize) * static_cast<qsizetype>(i),
                            mElementSize);
    }
    return result;
}

void XorDelta::write(QCborMap &map, std::span<const int> order) const
{
    map["ranges"_L1] = packedRanges(mIndices);
    map["bits"_L1] = packedBits(bits(), mElementSize, packingOrder(mIndices, order));
}

XorDelta XorDelta::read(CborReader &reader, int elementSize, int elementCount, std::span<const int> order)
{
    XorDelta delta(elementSize);
    delta.mIndices = reader.ranges("ranges"_L1, elementCount);
    const auto bits = unpackedBits(reader.bytes("bits"_L1), elementSize, packingOrder(delta.mIndices, order));
    if (!bits || reader.failed()) {
        reader.fail();
        return XorDelta(elementSize);
    }
    delta.mBits = *bits;
    delta.combine(XorDelta(elementSize)); // removes elements that do not differ
    return delta;
}

} // namespace autocuts
