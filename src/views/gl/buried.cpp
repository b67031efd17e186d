#include "views/gl/buried.h"

#include "model/plain/uvlayout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace autocuts {

namespace {

constexpr int cellsPerSide = 128; // chosen by hand

using Corners = std::array<Vec2, 3>;

double doubleArea(const Corners &p)
{
    const Vec2 a = p[1] - p[0], b = p[2] - p[0];
    return a.x() * b.y() - a.y() * b.x();
}

bool isInside(const Corners &p, double orientation, const Vec2 &place)
{
    for (std::size_t k = 0; k < 3; ++k) {
        if (orientation * doubleArea({p[k], p[(k + 1) % 3], place}) < 0)
            return false;
    }
    return true;
}

//! Counts layers at the middles of the cells of a grid.
class LayerGrid
{
public:
    explicit LayerGrid(const Eigen::AlignedBox2d &box)
        : mOrigin(box.min()), mCell(box.sizes() / cellsPerSide), mLayers(cellsPerSide * cellsPerSide, 0)
    {}

    //! Puts a triangle below those before. \returns false when nothing of it is seen
    bool add(const Corners &p)
    {
        const double orientation = doubleArea(p);
        const auto [firstColumn, lastColumn] = range(p, 0);
        const auto [firstRow, lastRow] = range(p, 1);
        mUnder.clear();
        bool seen = false;
        for (int row = firstRow; row <= lastRow; ++row) {
            for (int column = firstColumn; column <= lastColumn; ++column) {
                const int cell = row * cellsPerSide + column;
                const Vec2 middle = mOrigin + mCell.cwiseProduct(Vec2(column + 0.5, row + 0.5));
                if (!isInside(p, orientation, middle))
                    continue;
                mUnder.push_back(cell);
                seen = seen || mLayers[cell] < drawnLayers;
            }
        }
        if (mUnder.empty())
            return true;
        for (const int cell : mUnder)
            mLayers[cell] = static_cast<quint8>(std::min(mLayers[cell] + 1, drawnLayers));
        return seen;
    }

private:
    std::pair<int, int> range(const Corners &p, int axis) const
    {
        const auto [low, high] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
        const auto cellOf = [&](double place) {
            return std::clamp(static_cast<int>((place - mOrigin[axis]) / mCell[axis]), 0, cellsPerSide - 1);
        };
        return {cellOf(low), cellOf(high)};
    }

    Vec2 mOrigin, mCell;
    std::vector<quint8> mLayers;
    std::vector<int> mUnder; //!< cells of the last triangle
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
