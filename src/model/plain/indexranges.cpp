#include "model/plain/indexranges.h"

#include <algorithm>

namespace autocuts {

IndexRanges IndexRanges::all(int count)
{
    IndexRanges result;
    if (count > 0)
        result.append(IndexRange{0, count});
    return result;
}

void IndexRanges::append(int index)
{
    append(IndexRange{index, index + 1});
}

void IndexRanges::append(IndexRange range)
{
    if (!mRanges.empty() && mRanges.back().end == range.first)
        mRanges.back().end = range.end;
    else
        mRanges.push_back(range);
    mCount += range.end - range.first;
}

bool IndexRanges::contains(int index) const
{
    const auto after = std::upper_bound(mRanges.begin(), mRanges.end(), index,
                                        [](int i, const IndexRange &range) { return i < range.first; });
    return after != mRanges.begin() && index < std::prev(after)->end;
}

} // namespace autocuts
