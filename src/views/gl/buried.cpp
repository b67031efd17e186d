#include "views/gl/buried.h"

#include "model/plain/uvlayout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace autocuts {

namespace {

constexpr int cellsPerSide = 128; // chosen by hand

using Corners = std::array<Vec2, 3>;

double doubleArea(const Corners &p)
{
    const Vec2 a = p[1] - p[0], b = p[2] - p[0];
    return a.x() * b.y() - a.y() * b.x();
}

//! The part of a row, at height y, that lies inside a triangle; empty: low above high.
struct Reach
{
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

Reach reachAt(const Corners &p, double y)
{
    Reach reach;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 &a = p[k], &b = p[(k + 1) % 3];
        if (std::min(a.y(), b.y()) > y || std::max(a.y(), b.y()) < y || a.y() == b.y())
            continue;
        const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        reach.low = std::min(reach.low, x);
        reach.high = std::max(reach.high, x);
    }
    return reach;
}

//! Counts layers at the middles of the cells of a grid.
class LayerGrid
{
public:
    explicit LayerGrid(const Eigen::AlignedBox2d &box)
        : mOrigin(box.min()), mCell(box.sizes() / cellsPerSide), mLayers(rowLength * cellsPerSide, 0),
          mNextOpen(mLayers.size())
    {
        for (std::size_t i = 0; i < mNextOpen.size(); ++i)
            mNextOpen[i] = static_cast<int>(i % rowLength);
    }

    //! Puts a triangle below those before. \returns false when nothing of it is seen
    bool add(const Corners &p)
    {
        const auto [low, high] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
        bool seen = false, sampled = false;
        for (int row = rowOf(low); row <= rowOf(high); ++row) {
            const Reach reach = reachAt(p, mOrigin.y() + (row + 0.5) * mCell.y());
            if (!(reach.low <= reach.high))
                continue;
            // The cells whose middles are inside.
            const int first =
                static_cast<int>(std::max(0.0, std::ceil((reach.low - mOrigin.x()) / mCell.x() - 0.5)));
            const int last = static_cast<int>(
                std::min(cellsPerSide - 1.0, std::floor((reach.high - mOrigin.x()) / mCell.x() - 0.5)));
            sampled = sampled || first <= last;
            for (int column = openFrom(row, first); column <= last; column = openFrom(row, column + 1)) {
                seen = true;
                if (++mLayers[cell(row, column)] == drawnLayers)
                    mNextOpen[cell(row, column)] = column + 1;
            }
        }
        return seen || !sampled;
    }

private:
    static constexpr int rowLength = cellsPerSide + 1; // with an end

    static std::size_t cell(int row, int column)
    {
        return static_cast<std::size_t>(row) * rowLength + static_cast<std::size_t>(column);
    }
    int rowOf(double y) const
    {
        return std::clamp(static_cast<int>((y - mOrigin.y()) / mCell.y()), 0, cellsPerSide - 1);
    }
    //! The first cell of a row, from a column on, that has room for a further layer. However many triangles
    //! lie on each other, a full cell is looked at only once or twice.
    int openFrom(int row, int column)
    {
        int open = column;
        while (mNextOpen[cell(row, open)] != open)
            open = mNextOpen[cell(row, open)];
        while (column != open)
            column = std::exchange(mNextOpen[cell(row, column)], open);
        return open;
    }

    Vec2 mOrigin, mCell;
    std::vector<quint8> mLayers;
    std::vector<int> mNextOpen; //!< per cell: itself while it has room, else one further on
};

} // namespace

void markBuried(const UvMatrix &soupUv, std::vector<FaceTexel> &texels)
{
    const int count = static_cast<int>(texels.size());
    const auto corners = [&](int t) {
        return Corners{Vec2(soupUv.row(3 * t)), Vec2(soupUv.row(3 * t + 1)), Vec2(soupUv.row(3 * t + 2))};
    };
    const auto isDrawn = [&](int t) {
        return (texels[t].marks & (FaceTexel::Hidden | FaceTexel::WithoutUv)) == 0;
    };
    const Eigen::AlignedBox2d box = layoutBox(soupUv);
    double area = 0;
    for (int t = 0; t < count; ++t)
        area += isDrawn(t) ? 0.5 * std::abs(doubleArea(corners(t))) : 0;
    if (box.isEmpty() || !(box.volume() > 0) || area < drawnLayers * box.volume())
        return;
    LayerGrid grid(box);
    // As soup.vert lays them: what is marked lies above what is not, later triangles above earlier ones.
    constexpr int above = FaceTexel::Selected | FaceTexel::Overlapping | FaceTexel::Flipped;
    for (int height = above; height >= 0; --height) {
        for (int t = count - 1; t >= 0; --t) {
            if ((texels[t].marks & above) == height && isDrawn(t) && !grid.add(corners(t)))
                texels[t].marks |= FaceTexel::Buried;
        }
    }
}

} // namespace autocuts
