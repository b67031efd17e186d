#include "solver/preference/raytree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace autocuts::preference {

namespace {

// Chosen by hand.
constexpr int leafSize = 4;
constexpr int deepest = 64; // size of the stack; each level halves the triangles, so no mesh needs more

} // namespace

RayTree::RayTree(const MeshData &mesh)
{
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (mesh.triangleDegenerate[t])
            continue;
        const Vec3 a = mesh.cornerPosition(mesh.triangles[t][0]);
        mTriangles.push_back({a, mesh.cornerPosition(mesh.triangles[t][1]) - a,
                              mesh.cornerPosition(mesh.triangles[t][2]) - a});
    }
    if (!mTriangles.empty())
        build(0, static_cast<int>(mTriangles.size()));
}

void RayTree::build(int begin, int end)
{
    const std::size_t id = mNodes.size();
    mNodes.emplace_back();
    Vec3 low = mTriangles[begin].corner, high = low;
    for (int i = begin; i < end; ++i) {
        const Triangle &t = mTriangles[i];
        for (const Vec3 &p : {t.corner, Vec3(t.corner + t.toSecond), Vec3(t.corner + t.toThird)}) {
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
    const int half = begin + (end - begin) / 2;
    std::nth_element(
        mTriangles.begin() + begin, mTriangles.begin() + half, mTriangles.begin() + end,
        [axis](const Triangle &a, const Triangle &b) { return a.middle()[axis] < b.middle()[axis]; });
    build(begin, half);
    mNodes[id].right = static_cast<int>(mNodes.size());
    build(half, end);
}

bool RayTree::meets(const Triangle &triangle, const Vec3 &from, const Vec3 &direction)
{
    const Vec3 p = direction.cross(triangle.toThird);
    const double determinant = triangle.toSecond.dot(p);
    if (determinant == 0)
        return false;
    const Vec3 offset = from - triangle.corner;
    const double u = offset.dot(p) / determinant;
    const Vec3 q = offset.cross(triangle.toSecond);
    const double v = direction.dot(q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && triangle.toThird.dot(q) / determinant > 0;
}

bool RayTree::isHit(const Vec3 &from, const Vec3 &direction) const
{
    if (mNodes.empty())
        return false;
    const Vec3 inverse = direction.cwiseInverse();
    const auto enters = [&](const Node &node) {
        // A ray in the plane of one of the box's sides gives 0 * infinity, which is NaN; that side is then
        // ignored.
        double near = 0, far = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            const double a = (node.low[i] - from[i]) * inverse[i], b = (node.high[i] - from[i]) * inverse[i];
            near = std::max(near, std::min(a, b));
            far = std::min(far, std::max(a, b));
        }
        return near <= far;
    };
    std::array<int, deepest> stack;
    int size = 0;
    stack[size++] = 0;
    while (size > 0) {
        const int id = stack[--size];
        const Node &node = mNodes[id];
        if (!enters(node))
            continue;
        for (int i = node.first; i < node.first + node.count; ++i) {
            if (meets(mTriangles[i], from, direction))
                return true;
        }
        if (node.count == 0) {
            stack[size++] = node.right;
            stack[size++] = id + 1;
        }
    }
    return false;
}

} // namespace autocuts::preference
