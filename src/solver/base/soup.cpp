#include "solver/base/soup.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace autocuts {

namespace {

//! Stand-in shape of a triangle without area: its height relative to its longest edge; the longest edge
//! relative to the mean edge when all corners coincide; and its weight relative to a triangle of its area.
//! Chosen by hand.
constexpr double standInHeight = 1e-3;
constexpr double standInEdge = 1e-3;
constexpr double standInWeight = 1e-3;

//! Isometric copy of a 3D triangle in the plane: corner 0 at the origin, corner 1 on the u axis.
std::array<double, 6> flatten(const Vec3 &a, const Vec3 &b, const Vec3 &c)
{
    const Vec3 e1 = b - a;
    const Vec3 e2 = c - a;
    const double length = e1.norm();
    const double x = e1.dot(e2) / length;
    const double y = e1.cross(e2).norm() / length;
    return {0, 0, length, 0, x, y};
}

//! A thin triangle with nearly the edge lengths of a 3D triangle without area.
std::array<double, 6> standIn(const Vec3 &a, const Vec3 &b, const Vec3 &c, double meanEdge)
{
    const std::array<double, 3> length{(c - b).norm(), (a - c).norm(), (b - a).norm()}; // opposite to a, b, c
    const int apex = static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
    const double base = std::max(length[apex], standInEdge * meanEdge);
    // The corner opposite to the longest edge is placed above it, dividing it in the ratio of the other two
    // edges.
    const double before = length[(apex + 2) % 3]; // from corner apex to corner apex + 1
    const double after = length[(apex + 1) % 3];
    const double share = before + after > 0 ? before / (before + after) : 0.5;
    const Vec2 first(0, 0);     // corner apex + 1
    const Vec2 second(base, 0); // corner apex + 2
    const Vec2 top(base * std::clamp(share, 0.01, 0.99), base * standInHeight);
    std::array<double, 6> shape;
    const std::array<Vec2, 3> corner{top, first, second};
    for (int k = 0; k < 3; ++k) {
        shape[2 * ((apex + k) % 3)] = corner[k].x();
        shape[2 * ((apex + k) % 3) + 1] = corner[k].y();
    }
    return shape;
}

Soup::Basis basisOf(const std::array<double, 6> &s)
{
    const double a = s[2] - s[0], b = s[4] - s[0];
    const double c = s[3] - s[1], d = s[5] - s[1];
    const double det = a * d - b * c;
    // Rows of the inverse of [e1 e2]: gradients of the corners 1 and 2.
    const double g1x = d / det, g1y = -b / det;
    const double g2x = -c / det, g2y = a / det;
    return {-g1x - g2x, -g1y - g2y, g1x, g1y, g2x, g2y};
}

std::vector<CornerPartners> partnersOf(const MeshData &mesh)
{
    std::vector<CornerPartners> partners(mesh.soupCornerCount());
    for (int p = 0; p < mesh.cornerPairCount(); ++p) {
        const auto &corners = mesh.edgePairs[p / 2].corner[p % 2];
        for (int which = 0; which < 2; ++which) {
            CornerPartners &own = partners[corners[which]];
            const int place = own.pair[0] < 0 ? 0 : 1;
            own.corner[place] = corners[1 - which];
            own.pair[place] = p;
        }
    }
    return partners;
}

} // namespace

std::shared_ptr<const Soup> Soup::build(std::shared_ptr<const MeshData> mesh)
{
    if (!(mesh->area > 0) || !std::isfinite(mesh->area))
        throw std::invalid_argument("the mesh has no area");
    auto soup = std::make_shared<Soup>();
    soup->mesh = mesh;
    soup->scale = std::sqrt(std::numbers::pi / mesh->area);

    double lengthSum = 0;
    for (const EdgePair &pair : mesh->edgePairs) {
        for (int end = 0; end < 2; ++end) {
            soup->pairCorners.push_back(pair.corner[end]);
            soup->pairLength.push_back(pair.length * soup->scale);
        }
        lengthSum += pair.length * soup->scale;
    }
    soup->partners = partnersOf(*mesh);
    const int count = mesh->triangleCount();
    soup->meanEdgeLength = mesh->edgePairs.empty() ? std::sqrt(4 * std::numbers::pi / count)
                                                   : lengthSum / double(mesh->edgePairs.size());

    soup->basis.resize(count);
    soup->restShape.resize(count);
    soup->weight.resize(count);
    for (int t = 0; t < count; ++t) {
        const auto &corners = mesh->triangles[t];
        const Vec3 a = mesh->cornerPosition(corners[0]);
        const Vec3 b = (mesh->cornerPosition(corners[1]) - a) * soup->scale;
        const Vec3 c = (mesh->cornerPosition(corners[2]) - a) * soup->scale;
        if (mesh->triangleDegenerate[t]) {
            soup->restShape[t] = standIn(Vec3::Zero(), b, c, soup->meanEdgeLength);
            const auto &s = soup->restShape[t];
            soup->weight[t] =
                standInWeight * 0.5 *
                (s[2] * s[5] - s[3] * s[4] + s[4] * s[1] - s[5] * s[0] + s[0] * s[3] - s[1] * s[2]) /
                std::numbers::pi;
        } else {
            soup->restShape[t] = flatten(Vec3::Zero(), b, c);
            soup->weight[t] = mesh->triangleArea[t] * soup->scale * soup->scale / std::numbers::pi;
        }
        for (double &coordinate : soup->restShape[t])
            coordinate *= mesh->texelWeightOf(t);
        soup->basis[t] = basisOf(soup->restShape[t]);
    }
    if (!mesh->faceCopies.empty()) {
        double all = 0;
        for (int t = 0; t < count; ++t)
            all += mesh->copiesOf(t) * mesh->triangleArea[t];
        soup->perCopy = mesh->area / all;
        for (int t = 0; t < count; ++t)
            soup->weight[t] *= mesh->copiesOf(t) * soup->perCopy;
    }
    soup->componentShare.assign(mesh->componentCount, 0);
    for (int t = 0; t < count; ++t)
        soup->componentShare[mesh->component[t]] += soup->shareOfCopy(t);
    return soup;
}

std::shared_ptr<const Soup> Soup::shapedAs(const std::vector<double> &x, const std::vector<bool> &which) const
{
    auto shaped = std::make_shared<Soup>(*this);
    for (int t = 0; t < triangleCount(); ++t) {
        if (!which[t] || !(jacobianDeterminant(*this, x.data(), t) > 0))
            continue;
        std::copy_n(x.begin() + 6 * static_cast<std::ptrdiff_t>(t), 6, shaped->restShape[t].begin());
        shaped->basis[t] = basisOf(shaped->restShape[t]);
    }
    return shaped;
}

} // namespace autocuts
