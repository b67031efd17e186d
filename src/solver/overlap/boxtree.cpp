#include "solver/overlap/boxtree.h"

#include <algorithm>
#include <numeric>

namespace autocuts::overlap {

BoxTree::BoxTree(std::vector<Eigen::AlignedBox2d> boxes) : mBoxes(std::move(boxes)), mOrder(mBoxes.size())
{
    std::iota(mOrder.begin(), mOrder.end(), 0);
    if (!mOrder.empty()) {
        mNodes.reserve(mOrder.size());
        build(0, static_cast<int>(mOrder.size()));
    }
}

void BoxTree::build(int begin, int end)
{
    // Chosen by hand.
    constexpr int leafSize = 4;
    const std::size_t id = mNodes.size();
    mNodes.emplace_back();
    Eigen::AlignedBox2d box;
    for (int i = begin; i < end; ++i)
        box.extend(mBoxes[mOrder[i]]);
    mNodes[id].box = box;
    mNodes[id].first = begin;
    if (end - begin <= leafSize) {
        mNodes[id].count = end - begin;
        return;
    }
    const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
    const auto middle = [&](int item) { return mBoxes[item].min()[axis] + mBoxes[item].max()[axis]; };
    const int half = begin + (end - begin) / 2;
    std::nth_element(mOrder.begin() + begin, mOrder.begin() + half, mOrder.begin() + end,
                     [&](int a, int b) { return middle(a) != middle(b) ? middle(a) < middle(b) : a < b; });
    build(begin, half);
    mNodes[id].right = static_cast<int>(mNodes.size());
    build(half, end);
}

} // namespace autocuts::overlap
