// Tree of bounding boxes in the plane, for finding pairs of overlapping boxes and nearest items.
#pragma once

#include "model/plain/types.h"

#include <Eigen/Geometry>

#include <vector>

namespace autocuts::overlap {

//! True when the interiors of two boxes intersect; boxes that only touch do not overlap.
inline bool interiorsMeet(const Eigen::AlignedBox2d &a, const Eigen::AlignedBox2d &b)
{
    return a.min().x() < b.max().x() && b.min().x() < a.max().x() && a.min().y() < b.max().y() &&
           b.min().y() < a.max().y();
}

//! Binary tree over boxes, split at the median of the longer side. The order of all visits depends only on
//! the boxes.
class BoxTree
{
public:
    struct Node
    {
        Eigen::AlignedBox2d box;
        int first = 0, count = 0; //!< range in order(); count > 0 in leaves only
        int right = 0;            //!< second child; the first one follows its parent directly
    };

    //! \param boxes one box per item
    explicit BoxTree(std::vector<Eigen::AlignedBox2d> boxes);

    const std::vector<Node> &nodes() const { return mNodes; }
    //! Items in the order of the leaves.
    const std::vector<int> &order() const { return mOrder; }
    const Eigen::AlignedBox2d &box(int item) const { return mBoxes[item]; }

    //! Calls visit(a, b) once for every two items whose boxes overlap, until it returns false.
    //! \return false when visit returned false
    template <typename Visit>
    bool visitOverlappingPairs(Visit &&visit) const
    {
        if (mNodes.empty())
            return true;
        std::vector<std::pair<int, int>> stack{{0, 0}};
        while (!stack.empty()) {
            const auto [a, b] = stack.back();
            stack.pop_back();
            const Node &first = mNodes[a];
            const Node &second = mNodes[b];
            if (a != b && !interiorsMeet(first.box, second.box))
                continue;
            if (first.count > 0 && second.count > 0) {
                if (!visitLeaves(first, second, a == b, visit))
                    return false;
            } else if (a == b) {
                stack.insert(stack.end(), {{a + 1, a + 1}, {first.right, first.right}, {a + 1, first.right}});
            } else if (second.count > 0 || (first.count == 0 && size(first) >= size(second))) {
                stack.insert(stack.end(), {{a + 1, b}, {first.right, b}});
            } else {
                stack.insert(stack.end(), {{a, b + 1}, {a, second.right}});
            }
        }
        return true;
    }

private:
    static double size(const Node &node) { return node.box.sizes().sum(); }

    template <typename Visit>
    bool visitLeaves(const Node &first, const Node &second, bool same, Visit &&visit) const
    {
        for (int i = first.first; i < first.first + first.count; ++i) {
            for (int j = same ? i + 1 : second.first; j < second.first + second.count; ++j) {
                const int a = mOrder[i];
                const int b = mOrder[j];
                if (interiorsMeet(mBoxes[a], mBoxes[b]) && !visit(a, b))
                    return false;
            }
        }
        return true;
    }

    void build(int begin, int end);

    std::vector<Eigen::AlignedBox2d> mBoxes;
    std::vector<int> mOrder;
    std::vector<Node> mNodes;
};

} // namespace autocuts::overlap
