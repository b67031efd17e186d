#include "model/plain/csrlist.h"

#include <algorithm>

namespace autocuts {

CsrList::CsrList(int count, const std::vector<std::pair<int, int>> &entries)
    : mFirst(count + 1, 0), mValue(entries.size())
{
    for (const auto &entry : entries)
        ++mFirst[entry.first + 1];
    for (int i = 0; i < count; ++i)
        mFirst[i + 1] += mFirst[i];
    std::vector<int> place(mFirst.begin(), mFirst.end() - 1);
    for (const auto &entry : entries)
        mValue[place[entry.first]++] = entry.second;
}

int CsrList::find(int index, int value) const
{
    const auto begin = mValue.begin() + mFirst[index];
    const auto end = mValue.begin() + mFirst[index + 1];
    const auto place = std::lower_bound(begin, end, value);
    return place != end && *place == value ? static_cast<int>(place - mValue.begin()) : -1;
}

} // namespace autocuts
