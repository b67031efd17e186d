#include "solver/overlap/boxtree.h"

#include <algorithm>
#include <numeric>

namespace autocuts::overlap {

void Box2::add(const Vec2 &point)
{
    left = std::min(left, point.x());
    right = std::max(right, point.x());
    bottom = std::min(bottom, point.y());
    top = std::max(top, point.y());
}

void Box2::add(const Box2 &box)
{
    left = std::min(left, box.left);
    right = std::max(right, box.right);
    bottom = std::min(bottom, box.bottom);
    top = std::max(top, box.top);
}

double Box2::squaredDistance(const Box2 &other) const
{
    const double x = std::max({0.0, left - other.right, other.left - right});
    const double y = std::max({0.0, bottom - other.top, other.bottom - top});
    return x * x + y * y;
}

BoxTree::BoxTree(std::vector<Box2> boxes) : mBoxes(std::move(boxes)), mOrder(mBoxes.size())
{
    std::iota(mOrder.begin(), mOrder.end(), 0);
    if (!mOrder.empty()) {
        mNodes.reserve(mOrder.size());
        build(0, static_cast<int>(mOrder.size()));
    }
}

void BoxTree::build(int begin, int end)
{
    constexpr int leafSize = 4;
    const std::size_t id = mNodes.size();
    mNodes.emplace_back();
    Box2 box;
    for (int i = begin; i < end; ++i)
        box.add(mBoxes[mOrder[i]]);
    mNodes[id].box = box;
    mNodes[id].first = begin;
    if (end - begin <= leafSize) {
        mNodes[id].count = end - begin;
        return;
    }
    const bool wide = box.width() >= box.height();
    const auto middle = [&](int item) {
        const Box2 &b = mBoxes[item];
        return wide ? b.left + b.right : b.bottom + b.top;
    };
    const int half = begin + (end - begin) / 2;
    std::nth_element(mOrder.begin() + begin, mOrder.begin() + half, mOrder.begin() + end,
                     [&](int a, int b) { return middle(a) != middle(b) ? middle(a) < middle(b) : a < b; });
    build(begin, half);
    mNodes[id].right = static_cast<int>(mNodes.size());
    build(half, end);
}

} // namespace autocuts::overlap
