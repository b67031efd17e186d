// The difference between two versions of an array, small enough to keep thousands of them.
#pragma once

#include "model/document/cborvalues.h"
#include "model/plain/indexranges.h"

#include <QByteArray>

#include <cstring>
#include <memory>
#include <memory_resource>
#include <span>
#include <type_traits>
#include <vector>

namespace autocuts {

//! The exclusive or of the bits of two versions, for the elements that differ. Applying it to either version
//! gives exactly the other one, so undo and redo are the same operation and one of the versions is enough.
//!
//! Large deltas can be packed: an element equal to the one before it, in a given order, takes one bit (UVs
//! are equal at all corners of a UV vertex); the others are split into byte planes and compressed.
class XorDelta
{
public:
    static constexpr int maxElementSize = 16;

    explicit XorDelta(int elementSize = 1) : mElementSize(elementSize) {}

    //! The delta from the current values to the given ones at the given indices; equal elements are left out.
    //! \pre values has one element per index
    template <typename T>
    static XorDelta between(const T *current, const IndexRanges &indices, std::span<const T> values)
    {
        static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= maxElementSize);
        XorDelta delta(sizeof(T));
        std::size_t next = 0;
        indices.forEach([&](int i) { delta.append(i, bytesOf(current + i), bytesOf(&values[next++])); });
        return delta;
    }

    bool isEmpty() const { return mIndices.isEmpty(); }
    const IndexRanges &indices() const { return mIndices; }

    //! The values of the other version at indices(). \param current the array in either version
    template <typename T>
    std::vector<T> applied(const T *current) const
    {
        std::vector<T> values(mIndices.count());
        apply(bytesOf(current), reinterpret_cast<char *>(values.data()));
        return values;
    }

    //! Appends a newer delta: the result leads from the old version of this one to the new version of that
    //! one.
    void combine(const XorDelta &newer);

    //! Packs the bits when that saves memory.
    //! \param pool the memory for the packed bits
    //! \param order all indices of the array, in an order in which equal elements often follow each other;
    //! empty: by index. Must stay valid until the delta is unpacked
    void pack(const std::shared_ptr<std::pmr::memory_resource> &pool, std::span<const int> order = {});
    //! Bytes used.
    qint64 byteCount() const;

    //! The same differences at other indices. \param indices one per index of indices(), all different
    XorDelta renumbered(std::span<const int> indices) const;

    //! Writes "ranges" and "bits", not compressed: the caller compresses the whole.
    void write(QCborMap &map, std::span<const int> order = {}) const;
    //! Reads what write() wrote. \pre order is empty or a permutation of 0, ..., elementCount - 1
    static XorDelta read(CborReader &reader, int elementSize, int elementCount,
                         std::span<const int> order = {});

private:
    struct PackedBits;

    template <typename T>
    static const char *bytesOf(const T *values)
    {
        return reinterpret_cast<const char *>(values);
    }

    void append(int index, const char *before, const char *after);
    void apply(const char *current, char *result) const;
    QByteArray bits() const;

    int mElementSize;
    IndexRanges mIndices;
    QByteArray mBits; //!< empty when packed
    std::shared_ptr<const PackedBits> mPacked;
};

} // namespace autocuts
