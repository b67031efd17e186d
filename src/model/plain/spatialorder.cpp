#include "model/plain/spatialorder.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace autocuts {

namespace {

constexpr int bitsPerAxis = 21;

//! Inserts two zero bits before each bit of a number.
std::uint64_t spread(std::uint32_t number)
{
    std::uint64_t result = 0;
    for (int bit = 0; bit < bitsPerAxis; ++bit)
        result |= std::uint64_t(number >> bit & 1) << 3 * bit;
    return result;
}

} // namespace

std::vector<int> spatialOrder(const PositionMatrix &points)
{
    std::vector<int> order(points.rows());
    std::iota(order.begin(), order.end(), 0);
    if (points.rows() == 0)
        return order;
    const Vec3 low = points.colwise().minCoeff();
    const double extent = (points.colwise().maxCoeff().transpose() - low).maxCoeff();
    const double scale = extent > 0 ? ((1 << bitsPerAxis) - 1) / extent : 0;
    std::vector<std::uint64_t> place(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        for (int axis = 0; axis < 3; ++axis)
            place[i] |= spread(static_cast<std::uint32_t>((points(i, axis) - low[axis]) * scale)) << axis;
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return place[a] < place[b]; });
    return order;
}

} // namespace autocuts
