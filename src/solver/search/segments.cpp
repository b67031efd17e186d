#include "solver/search/segments.h"

#include "solver/base/segmentcrossing.h"

#include <algorithm>

namespace autocuts::search {

void Segments::clear()
{
    mMoving.clear();
    mFixed.clear();
}

bool Segments::cross(const std::vector<double> &position, std::vector<int> *touched)
{
    const int moving = static_cast<int>(mMoving.size());
    mBoxes.clear();
    double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;
    const auto coordinates = [&](int s) -> Fixed {
        if (s >= moving)
            return mFixed[s - moving];
        const auto [a, b] = mMoving[s];
        return {position[2 * a], position[2 * a + 1], position[2 * b], position[2 * b + 1]};
    };
    const auto boxOf = [&](int s) -> Box {
        const Fixed f = coordinates(s);
        return {std::min(f.ax, f.bx), std::max(f.ax, f.bx), std::min(f.ay, f.by), std::max(f.ay, f.by), s};
    };
    for (int s = 0; s < moving; ++s) {
        mBoxes.push_back(boxOf(s));
        left = std::min(left, mBoxes.back().left);
        right = std::max(right, mBoxes.back().right);
        bottom = std::min(bottom, mBoxes.back().bottom);
        top = std::max(top, mBoxes.back().top);
    }
    for (int s = moving; s < moving + static_cast<int>(mFixed.size()); ++s) {
        const Box box = boxOf(s);
        if (box.left <= right && box.right >= left && box.bottom <= top && box.top >= bottom)
            mBoxes.push_back(box);
    }
    std::sort(mBoxes.begin(), mBoxes.end(), [](const Box &a, const Box &b) {
        return a.left != b.left ? a.left < b.left : a.segment < b.segment;
    });
    bool found = false;
    for (std::size_t i = 0; i < mBoxes.size(); ++i) {
        const Box &a = mBoxes[i];
        for (std::size_t j = i + 1; j < mBoxes.size() && mBoxes[j].left <= a.right; ++j) {
            const Box &b = mBoxes[j];
            if (a.bottom > b.top || b.bottom > a.top || (a.segment >= moving && b.segment >= moving))
                continue;
            const Fixed p = coordinates(a.segment), q = coordinates(b.segment);
            if (!segmentsCross({p.ax, p.ay}, {p.bx, p.by}, {q.ax, q.ay}, {q.bx, q.by}))
                continue;
            if (!touched)
                return true;
            found = true;
            for (const int s : {a.segment, b.segment}) {
                if (s < moving) {
                    touched->push_back(mMoving[s].first);
                    touched->push_back(mMoving[s].second);
                }
            }
        }
    }
    return found;
}

} // namespace autocuts::search
