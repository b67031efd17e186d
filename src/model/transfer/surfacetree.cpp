#include "model/transfer/surfacetree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace autocuts::transfer {

namespace {

// Chosen by hand.
constexpr int leafSize = 4;
constexpr double facingCosine = 0.17; // about 80 degrees
constexpr int deepest = 64;           // size of the stack; each level halves the triangles

//! The nearest point on the side from corner k to the next one.
NearPoint nearestOnSide(const Triangle3 &triangle, int k, const Vec3 &point)
{
    const Vec3 along = triangle[(k + 1) % 3] - triangle[k];
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((point - triangle[k]).dot(along) / squared, 0.0, 1.0) : 0;
    NearPoint result;
    result.weights[k] = 1 - t;
    result.weights[(k + 1) % 3] = t;
    result.squared = (triangle[k] + t * along - point).squaredNorm();
    return result;
}

double squaredDistance(const Vec3 &low, const Vec3 &high, const Vec3 &point)
{
    return (low - point).cwiseMax(point - high).cwiseMax(0).squaredNorm();
}

} // namespace

std::optional<Vec3> weightsInPlane(const Triangle3 &triangle, const Vec3 &point)
{
    const Vec3 a = triangle[1] - triangle[0], b = triangle[2] - triangle[0], p = point - triangle[0];
    const double aa = a.squaredNorm(), ab = a.dot(b), bb = b.squaredNorm();
    const double determinant = aa * bb - ab * ab;
    if (!(determinant > 1e-14 * aa * bb))
        return std::nullopt;
    const double second = (bb * a.dot(p) - ab * b.dot(p)) / determinant;
    const double third = (aa * b.dot(p) - ab * a.dot(p)) / determinant;
    return Vec3(1 - second - third, second, third);
}

NearPoint nearestOnTriangle(const Triangle3 &triangle, const Vec3 &point)
{
    if (const auto weights = weightsInPlane(triangle, point); weights && weights->minCoeff() >= 0) {
        NearPoint inside;
        inside.weights = *weights;
        inside.squared =
            (weights->x() * triangle[0] + weights->y() * triangle[1] + weights->z() * triangle[2] - point)
                .squaredNorm();
        return inside;
    }
    NearPoint best = nearestOnSide(triangle, 0, point);
    for (int k = 1; k < 3; ++k) {
        if (const NearPoint other = nearestOnSide(triangle, k, point); other.squared < best.squared)
            best = other;
    }
    return best;
}

SurfaceTree::SurfaceTree(std::vector<Triangle3> triangles) : mTriangles(std::move(triangles))
{
    mNormals.reserve(mTriangles.size());
    for (const Triangle3 &t : mTriangles) {
        const Vec3 cross = (t[1] - t[0]).cross(t[2] - t[0]);
        const double length = cross.stableNorm();
        mNormals.push_back(length > 0 ? Vec3(cross / length) : Vec3(Vec3::Zero()));
    }
    mOrder.resize(mTriangles.size());
    std::iota(mOrder.begin(), mOrder.end(), 0);
    if (!mOrder.empty())
        build(0, static_cast<int>(mOrder.size()));
}

void SurfaceTree::build(int begin, int end)
{
    const std::size_t id = mNodes.size();
    mNodes.emplace_back();
    Vec3 low = mTriangles[mOrder[begin]][0], high = low;
    for (int i = begin; i < end; ++i) {
        for (const Vec3 &p : mTriangles[mOrder[i]]) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    }
    mNodes[id].low = low;
    mNodes[id].high = high;
    mNodes[id].first = begin;
    if (end - begin <= leafSize) {
        mNodes[id].count = end - begin;
        return;
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const auto middle = [&](int t) {
        return mTriangles[t][0][axis] + mTriangles[t][1][axis] + mTriangles[t][2][axis];
    };
    const int half = begin + (end - begin) / 2;
    std::nth_element(mOrder.begin() + begin, mOrder.begin() + half, mOrder.begin() + end,
                     [&](int a, int b) { return std::pair(middle(a), a) < std::pair(middle(b), b); });
    build(begin, half);
    mNodes[id].right = static_cast<int>(mNodes.size());
    build(half, end);
}

NearPoint SurfaceTree::nearest(const Vec3 &point, double squared) const
{
    return search(point, nullptr, squared);
}

NearPoint SurfaceTree::nearestFacing(const Vec3 &point, const Vec3 &facing, double squared) const
{
    return search(point, &facing, squared);
}

NearPoint SurfaceTree::search(const Vec3 &point, const Vec3 *facing, double squared) const
{
    NearPoint best;
    best.squared = squared;
    if (mNodes.empty())
        return best;
    std::array<std::pair<double, int>, deepest> stack;
    int size = 0;
    stack[size++] = {squaredDistance(mNodes[0].low, mNodes[0].high, point), 0};
    while (size > 0) {
        const auto [distance, id] = stack[--size];
        if (distance > best.squared)
            continue;
        const Node &node = mNodes[id];
        for (int i = node.first; i < node.first + node.count; ++i) {
            const int t = mOrder[i];
            if (facing && mNormals[t].dot(*facing) < facingCosine)
                continue;
            NearPoint near = nearestOnTriangle(mTriangles[t], point);
            if (near.squared < best.squared ||
                (near.squared == best.squared && (best.triangle < 0 || t < best.triangle))) {
                near.triangle = t;
                best = near;
            }
        }
        if (node.count > 0)
            continue;
        const int left = id + 1, right = node.right;
        const double toLeft = squaredDistance(mNodes[left].low, mNodes[left].high, point);
        const double toRight = squaredDistance(mNodes[right].low, mNodes[right].high, point);
        const bool leftFirst = toLeft <= toRight;
        stack[size++] = leftFirst ? std::pair(toRight, right) : std::pair(toLeft, left);
        stack[size++] = leftFirst ? std::pair(toLeft, left) : std::pair(toRight, right);
    }
    return best;
}

} // namespace autocuts::transfer
