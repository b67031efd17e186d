#include "solver/search/tutte.h"

#include "solver/linear/cholmodsolver.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace autocuts::search {

namespace {

double sideLength(const Soup &soup, int side)
{
    const auto &s = soup.restShape[side / 3];
    const int a = side % 3, b = (side + 1) % 3;
    return std::hypot(s[2 * a] - s[2 * b], s[2 * a + 1] - s[2 * b + 1]);
}

double loopLength(const Soup &soup, const std::vector<int> &loop)
{
    double sum = 0;
    for (const int side : loop)
        sum += sideLength(soup, side);
    return sum;
}

} // namespace

std::vector<double> tutteEmbedding(const Soup &soup, const CutMesh &cut)
{
    const std::vector<std::vector<int>> loops = cut.boundaryLoops();
    std::vector<int> outer(cut.chartCount, -1);
    std::vector<double> outerLength(cut.chartCount, 0);
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const int chart = cut.chart[loops[i].front() / 3];
        const double length = loopLength(soup, loops[i]);
        if (outer[chart] < 0 || length > outerLength[chart]) {
            outer[chart] = static_cast<int>(i);
            outerLength[chart] = length;
        }
    }
    std::vector<double> chartArea(cut.chartCount, 0);
    for (int t = 0; t < soup.triangleCount(); ++t)
        chartArea[cut.chart[t]] += soup.weight[t] * std::numbers::pi;

    // Unknowns: UV vertices off the outer loops, then one virtual vertex per inner loop.
    std::vector<Vec2> position(cut.uvVertexCount, Vec2::Zero());
    std::vector<bool> fixed(cut.uvVertexCount, false);
    for (int chart = 0; chart < cut.chartCount; ++chart) {
        if (outer[chart] < 0)
            throw std::invalid_argument("tutteEmbedding: a chart has no boundary");
        const double radius = std::sqrt(chartArea[chart] / std::numbers::pi);
        double walked = 0;
        for (const int side : loops[outer[chart]]) {
            const double angle = 2 * std::numbers::pi * walked / outerLength[chart];
            position[cut.uvVertex[side]] = radius * Vec2(std::cos(angle), std::sin(angle));
            fixed[cut.uvVertex[side]] = true;
            walked += sideLength(soup, side);
        }
    }
    std::vector<int> unknown(cut.uvVertexCount, -1);
    int count = 0;
    for (int v = 0; v < cut.uvVertexCount; ++v) {
        if (!fixed[v])
            unknown[v] = count++;
    }

    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> diagonal(count, 0.0);
    Eigen::VectorXd right[2] = {Eigen::VectorXd::Zero(count + static_cast<int>(loops.size())),
                                Eigen::VectorXd::Zero(count + static_cast<int>(loops.size()))};
    const auto connect = [&](int a, int b, double w) { // pulls vertex a towards vertex b
        const int i = unknown[a];
        if (i < 0)
            return;
        diagonal[i] += w;
        if (fixed[b]) {
            right[0][i] += w * position[b].x();
            right[1][i] += w * position[b].y();
        } else if (unknown[b] < i) {
            entries.emplace_back(i, unknown[b], -w);
        }
    };
    for (int side = 0; side < static_cast<int>(cut.neighbour.size()); ++side) {
        if (cut.neighbour[side] >= 0 && cut.neighbour[side] < side)
            continue; // each edge once
        const int a = cut.uvVertex[side];
        const int b = cut.uvVertex[side / 3 * 3 + (side + 1) % 3];
        const double w = 1 / std::max(sideLength(soup, side), 1e-3 * soup.meanEdgeLength);
        connect(a, b, w);
        connect(b, a, w);
    }
    int total = count;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (outer[cut.chart[loops[i].front() / 3]] == static_cast<int>(i))
            continue;
        const int hub = total++;
        double sum = 0;
        for (const int side : loops[i]) {
            const double w = 1 / std::max(sideLength(soup, side), 1e-3 * soup.meanEdgeLength);
            const int v = unknown[cut.uvVertex[side]];
            diagonal[v] += w;
            sum += w;
            entries.emplace_back(hub, v, -w);
        }
        entries.emplace_back(hub, hub, sum);
    }
    for (int i = 0; i < count; ++i)
        entries.emplace_back(i, i, diagonal[i]);
    if (total > 0) {
        linear::LinearSolver::Matrix matrix(total, total);
        matrix.setFromTriplets(entries.begin(), entries.end());
        linear::CholmodSolver solver;
        solver.analyze(matrix, linear::LinearSolver::Order::FillReducing);
        if (!solver.factorize(matrix))
            throw std::runtime_error("tutteEmbedding: the system could not be solved");
        Eigen::VectorXd solution[2];
        for (int axis = 0; axis < 2; ++axis) {
            right[axis].conservativeResize(total);
            solver.solve(right[axis], solution[axis]);
        }
        for (int v = 0; v < cut.uvVertexCount; ++v) {
            if (unknown[v] >= 0)
                position[v] = Vec2(solution[0][unknown[v]], solution[1][unknown[v]]);
        }
    }
    std::vector<double> x(soup.coordinateCount());
    for (std::size_t c = 0; c < cut.uvVertex.size(); ++c) {
        x[2 * c] = position[cut.uvVertex[c]].x();
        x[2 * c + 1] = position[cut.uvVertex[c]].y();
    }
    return x;
}

} // namespace autocuts::search
