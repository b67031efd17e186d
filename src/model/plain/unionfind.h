// Disjoint sets over 0, ..., n - 1. Plain: no Qt.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

namespace autocuts {

//! Disjoint sets. The root of a set is its smallest member, so results do not depend on the order of unions.
class UnionFind
{
public:
    explicit UnionFind(int size) : mParent(size) { std::iota(mParent.begin(), mParent.end(), 0); }

    int find(int item)
    {
        while (mParent[item] != item) {
            mParent[item] = mParent[mParent[item]];
            item = mParent[item];
        }
        return item;
    }

    //! Returns true when a and b were in different sets.
    bool unite(int a, int b)
    {
        a = find(a);
        b = find(b);
        if (a == b)
            return false;
        if (b < a)
            std::swap(a, b);
        mParent[b] = a;
        return true;
    }

    //! Numbers the sets 0, 1, ... by their smallest members. Returns the number of each item's set, and how
    //! many sets there are.
    std::pair<std::vector<int>, int> labels()
    {
        std::vector<int> label(mParent.size(), -1);
        int count = 0;
        for (int i = 0; i < static_cast<int>(mParent.size()); ++i) {
            const int root = find(i);
            if (root == i)
                label[i] = count++;
            else
                label[i] = label[root];
        }
        return {std::move(label), count};
    }

private:
    std::vector<int> mParent;
};

} // namespace autocuts
