#include "solver/straight/island.h"

#include "solver/base/cornerat.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/search/trianglekernel.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace autocuts::straight {

namespace {

//! The angle of a triangle on the model at corner k.
double restAngle(const Soup &soup, int corner)
{
    const std::array<double, 6> &shape = soup.restShape[corner / 3];
    const auto at = [&](int k) { return Vec2(shape[2 * (k % 3)], shape[2 * (k % 3) + 1]); };
    const int k = corner % 3;
    const Vec2 a = at(k + 1) - at(k), b = at(k + 2) - at(k);
    return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
}

} // namespace

double Island::area() const
{
    return std::numbers::pi * std::accumulate(weight.begin(), weight.end(), 0.0);
}

double Island::energy(const Positions &at) const
{
    double sum = 0;
    for (std::size_t t = 0; t < points.size(); ++t) {
        const auto &[a, b, c] = points[t];
        const double p[6] = {at[a].x(), at[a].y(), at[b].x(), at[b].y(), at[c].x(), at[c].y()};
        sum += 4 * weight[t] + stiffWeight(t) * (search::triangleEnergy(p, basis[t]) - 4);
    }
    return sum;
}

bool Island::coversItself(const Positions &at, const JobContext &job) const
{
    UvMatrix uv(3 * static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t t = 0; t < points.size(); ++t) {
        for (int k = 0; k < 3; ++k)
            uv.row(3 * static_cast<Eigen::Index>(t) + k) = at[points[t][k]].transpose();
    }
    overlap::OverlapOptions options;
    options.job = job;
    return !overlap::visitOverlaps(uv, options, [](int, int, double) { return false; });
}

std::vector<Island> islandsOf(const Soup &soup, const CutMesh &charts, const std::vector<double> &x)
{
    std::vector<Island> islands(charts.chartCount);
    std::vector<int> pointOf(charts.uvVertexCount, -1);
    std::vector<double> angle(charts.uvVertexCount, 0); // on the model, around the point
    for (int t = 0; t < soup.triangleCount(); ++t) {
        Island &island = islands[charts.chart[t]];
        std::array<int, 3> points;
        for (int k = 0; k < 3; ++k) {
            const int vertex = charts.uvVertex[3 * t + k];
            angle[vertex] += restAngle(soup, 3 * t + k);
            if (pointOf[vertex] < 0) {
                pointOf[vertex] = island.pointCount();
                island.position.push_back(cornerAt(x, 3 * t + k));
            }
            points[k] = pointOf[vertex];
        }
        island.triangles.push_back(t);
        island.points.push_back(points);
        island.basis.push_back(soup.basis[t]);
        island.weight.push_back(soup.weight[t]);
    }
    for (const std::vector<int> &sides : charts.boundaryLoops()) {
        Island::Loop loop;
        for (const int side : sides) {
            const std::array<double, 6> &shape = soup.restShape[side / 3];
            const int k = side % 3, next = (k + 1) % 3, vertex = charts.uvVertex[side];
            loop.point.push_back(pointOf[vertex]);
            loop.length.push_back(
                std::hypot(shape[2 * next] - shape[2 * k], shape[2 * next + 1] - shape[2 * k + 1]));
            loop.turn.push_back(std::numbers::pi - angle[vertex]);
        }
        islands[charts.chart[sides.front() / 3]].loops.push_back(std::move(loop));
    }
    return islands;
}

void store(const Island &island, const Positions &at, std::vector<double> &x)
{
    for (std::size_t t = 0; t < island.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k)
            cornerAt(x, 3 * island.triangles[t] + k) = at[island.points[t][k]];
    }
}

} // namespace autocuts::straight
