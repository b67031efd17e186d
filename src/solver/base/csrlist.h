// Many short lists in one array. Plain: no Qt.
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace autocuts {

//! Lists of ints, one list per index, in one array (compressed sparse rows).
class CsrList
{
public:
    //! \param entries (index, value); every list keeps the order of the entries
    CsrList(int count, const std::vector<std::pair<int, int>> &entries);
    CsrList() = default;

    std::span<const int> operator[](int index) const
    {
        return {mValue.data() + mFirst[index], mValue.data() + mFirst[index + 1]};
    }
    //! Place of a value among all values of all lists, -1 when its list has no such value.
    //! \pre the list is sorted
    int find(int index, int value) const;
    int totalSize() const { return static_cast<int>(mValue.size()); }

private:
    std::vector<int> mFirst{0};
    std::vector<int> mValue;
};

} // namespace autocuts
