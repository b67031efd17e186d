// Sets of array indices stored as sorted ranges. Plain: no Qt.
#pragma once

#include <vector>

namespace autocuts {

//! The indices first, first + 1, ..., end - 1.
struct IndexRange
{
    int first = 0;
    int end = 0;
    bool operator==(const IndexRange &) const = default;
};

//! A set of indices, stored as ascending ranges that neither touch nor overlap.
class IndexRanges
{
public:
    IndexRanges() = default;
    //! The set 0, ..., count - 1.
    static IndexRanges all(int count);
    //! \pre sorted is strictly ascending
    template <typename Container>
    static IndexRanges fromSorted(const Container &sorted)
    {
        IndexRanges result;
        for (int index : sorted)
            result.append(index);
        return result;
    }

    //! \pre index is greater than every index in the set
    void append(int index);
    //! \pre range is not empty and begins after every index in the set
    void append(IndexRange range);

    bool isEmpty() const { return mRanges.empty(); }
    //! The number of indices.
    int count() const { return mCount; }
    const std::vector<IndexRange> &ranges() const { return mRanges; }
    bool contains(int index) const;
    //! Frees memory that was reserved for more ranges.
    void squeeze() { mRanges.shrink_to_fit(); }

    //! Calls visit(index) for each index in ascending order.
    template <typename Visit>
    void forEach(Visit visit) const
    {
        for (const IndexRange &range : mRanges) {
            for (int i = range.first; i < range.end; ++i)
                visit(i);
        }
    }

    bool operator==(const IndexRanges &) const = default;

private:
    std::vector<IndexRange> mRanges;
    int mCount = 0;
};

} // namespace autocuts
