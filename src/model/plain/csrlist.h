// Lists of ints stored one after another in one array (compressed sparse rows). Plain: no Qt.
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace autocuts {

//! One list of ints per index, all stored in one array.
class CsrList
{
public:
    //! \param count number of lists
    //! \param entries (index, value); every list keeps the order of the entries
    CsrList(int count, const std::vector<std::pair<int, int>> &entries);
    CsrList() = default;

    std::span<const int> operator[](int index) const
    {
        return {mValue.data() + mFirst[index], mValue.data() + mFirst[index + 1]};
    }
    //! Position of a value in the array of all lists, in [0, totalSize()); -1 when the list at `index` does
    //! not contain it.
    //! \pre the list is sorted
    int find(int index, int value) const;
    int size() const { return static_cast<int>(mFirst.size()) - 1; }
    int totalSize() const { return static_cast<int>(mValue.size()); }
    //! The values of all lists, one list after another.
    const std::vector<int> &values() const { return mValue; }

private:
    std::vector<int> mFirst{0};
    std::vector<int> mValue;
};

} // namespace autocuts
