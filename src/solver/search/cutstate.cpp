#include "solver/search/cutstate.h"

#include "model/plain/unionfind.h"
#include "solver/base/alignedborder.h"
#include "solver/base/constant.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/search/trianglekernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace autocuts::search {

namespace {

//! Room between charts in solver units, so that they do not meet while they unfold. The whole mesh has an
//! area of pi. Raised from 1 to 30 when charts came to be relaxed one by one; chosen by hand.
AUTOCUTS_CONSTANT(double, chartGap, 30);

} // namespace

CutState CutState::from(std::shared_ptr<const SeamGraph> graph, const SeamedMap &map, bool inPlace)
{
    CutState state;
    state.graph = std::move(graph);
    state.anchored = inPlace && !state.graph->anchors.empty();
    state.pinReached.assign(state.graph->anchors.all().size(), 0);
    state.cut.assign(map.cut.begin(), map.cut.end());
    state.x = map.x;
    state.updateTopology();
    state.updateEnergy();
    state.spreadCharts();
    state.chartsMayMeet = state.anchored && state.boundariesOverlap();
    return state;
}

SeamedMap CutState::map() const
{
    return {CutFlags(cut.begin(), cut.end()), x};
}

void CutState::setCut(int e, bool isCut)
{
    const int change = int(isCut) - int(cut[e]);
    cut[e] = isCut;
    for (const int v : graph->ends[e])
        cutsAt[v] += change;
}

void CutState::updateTopology()
{
    const int sides = 3 * graph->triangleCount();
    UnionFind pieces(graph->triangleCount());
    boundary.clear();
    for (int side = 0; side < sides; ++side) {
        if (isCutSide(side))
            boundary.push_back(side);
        else if (graph->across[side] > side)
            pieces.unite(side / 3, graph->across[side] / 3);
    }
    int charts = 0;
    std::tie(chart, charts) = pieces.labels();
    chartArea.assign(charts, 0);
    for (int t = 0; t < graph->triangleCount(); ++t)
        chartArea[chart[t]] += graph->soup->shareOfCopy(t);
    cutsAt.assign(graph->vertexCount, 0);
    cost = length = 0;
    for (std::size_t e = 0; e < cut.size(); ++e) {
        if (cut[e]) {
            cost += graph->cost[e];
            length += graph->length[e];
            for (const int v : graph->ends[e])
                ++cutsAt[v];
        }
    }
    crooked = 0;
    updateCrooked();
    countSmallParts();
}

void CutState::countSmallParts()
{
    std::vector<char> isSmall(chartCount(), 0);
    for (const int side : boundary) {
        const int own = chart[side / 3], other = graph->across[side];
        if (other >= 0 && chart[other / 3] != own && chartArea[own] < smallestChart(*graph->soup, side / 3) &&
            graph->rule[graph->edgeOf[side]] != SeamGraph::Rule::AlwaysCut)
            isSmall[own] = 1;
    }
    smallParts = static_cast<int>(std::count(isSmall.begin(), isSmall.end(), 1));
}

void CutState::updateCrooked()
{
    if (!graph->aligned)
        return;
    cost -= crooked;
    crooked = alignmentCost * crookedBorder(*graph->soup, *graph->aligned, boundary, chart, chartCount(), x);
    cost += crooked;
}

void CutState::updateEnergy()
{
    const Soup &soup = *graph->soup;
    triangleEnergy.resize(soup.triangleCount());
    energy = 0;
    for (int t = 0; t < soup.triangleCount(); ++t) {
        triangleEnergy[t] = energyOf(t, &x[6 * static_cast<std::size_t>(t)]);
        energy += triangleEnergy[t];
    }
    distortion = energy;
    updateCrooked();
    if (graph->hasPlainEnergy())
        return;
    distortion = 0;
    for (int t = 0; t < soup.triangleCount(); ++t)
        distortion += distortionOf(t, &x[6 * static_cast<std::size_t>(t)]);
}

double CutState::anchorEnergy(int t, const double *p) const
{
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        for (const int i : graph->anchors.at(3 * t + k)) {
            const Anchor &anchor = graph->anchors.all()[i];
            const double stiffness = anchor.isHardPin ? pinStiffness : anchor.stiffness;
            sum += stiffness * anchor.outside({p[2 * k], p[2 * k + 1]}).squaredNorm();
        }
    }
    return sum;
}

void CutState::addAnchorDerivatives(int t, const double *p, double *gradient, double *hessian) const
{
    static constexpr int diagonal[6] = {0, 2, 5, 9, 14, 20}; // in the packed lower triangle
    for (int k = 0; k < 3; ++k) {
        for (const int i : graph->anchors.at(3 * t + k)) {
            const Anchor &anchor = graph->anchors.all()[i];
            const double stiffness = anchor.isHardPin ? pinStiffness : anchor.stiffness;
            const Vec2 outside = anchor.outside({p[2 * k], p[2 * k + 1]});
            for (int axis = 0; axis < 2; ++axis) {
                if (outside[axis] == 0 && anchor.isBox)
                    continue;
                gradient[2 * k + axis] += 2 * stiffness * outside[axis];
                hessian[diagonal[2 * k + axis]] += 2 * stiffness;
            }
        }
    }
}

int CutState::anchorFaults() const
{
    int faults = chartsMayMeet;
    for (std::size_t i = 0; i < pinReached.size(); ++i)
        faults += graph->anchors.all()[i].isHardPin && !pinReached[i];
    return faults;
}

std::vector<char> CutState::chartsWithAnchors() const
{
    std::vector<char> found(chartCount(), 0);
    for (int t = 0; anchored && t < graph->triangleCount(); ++t)
        found[chart[t]] |= graph->anchors.onTriangle(t);
    return found;
}

//! The boundary sides of the charts at a place.
std::vector<int> CutState::boundaryAt(const MapPlace &place) const
{
    std::vector<int> sides;
    if (place.wholeCharts) {
        for (const int t : place.triangles) {
            for (int side = 3 * t; side < 3 * t + 3; ++side) {
                if (isCutSide(side))
                    sides.push_back(side);
            }
        }
        return sides;
    }
    std::vector<char> isThere(chartCount(), place.triangles.empty());
    for (const int t : place.triangles)
        isThere[chart[t]] = 1;
    for (const int side : boundary) {
        if (isThere[chart[side / 3]])
            sides.push_back(side);
    }
    return sides;
}

bool CutState::loopsAreInOrder(const MapPlace &place) const
{
    std::vector<char> outer(chartCount(), 0);
    std::vector<char> seen(3 * static_cast<std::size_t>(graph->triangleCount()), 0);
    for (const int first : boundaryAt(place)) {
        if (seen[first])
            continue;
        double area = 0;
        for (int side = first; !seen[side];) {
            seen[side] = 1;
            int next = side / 3 * 3 + (side + 1) % 3;
            const Vec2 a = at(side) - at(first), b = at(next) - at(first);
            area += a.x() * b.y() - a.y() * b.x();
            while (!isCutSide(next)) {
                next = graph->across[next];
                next = next / 3 * 3 + (next + 1) % 3;
            }
            side = next;
        }
        char &found = outer[chart[first / 3]];
        if (area > 0 && found)
            return false;
        found |= area > 0;
    }
    return true;
}

bool CutState::boundariesOverlap(const MapPlace &place, const JobContext &job) const
{
    Vec2 low = Vec2::Constant(-1e300), high = Vec2::Constant(1e300);
    if (!place.triangles.empty()) {
        std::swap(low, high);
        for (const int t : place.triangles) {
            for (int c = 3 * t; c < 3 * t + 3; ++c) {
                low = low.cwiseMin(at(c));
                high = high.cwiseMax(at(c));
            }
        }
    }
    // Triangles at boundary points whose bounding boxes meet the box of the given triangles.
    std::vector<int> near;
    for (const int start : chartsAreAlone() ? boundaryAt(place) : boundary) {
        for (int side = start;;) {
            const int t = side / 3;
            const Vec2 a = at(3 * t), b = at(3 * t + 1), c = at(3 * t + 2);
            if ((a.cwiseMin(b).cwiseMin(c).array() <= high.array()).all() &&
                (a.cwiseMax(b).cwiseMax(c).array() >= low.array()).all())
                near.push_back(t);
            const int back = 3 * t + (side + 2) % 3;
            if (isCutSide(back))
                break;
            side = graph->across[back];
        }
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    const std::vector<const Obstacle *> obstacles = obstaclesAt(low, high);
    const int own = static_cast<int>(near.size());
    UvMatrix uv(3 * (near.size() + obstacles.size()), 2);
    for (std::size_t i = 0; i < near.size(); ++i) {
        for (int k = 0; k < 3; ++k)
            uv.row(3 * i + k) = at(3 * near[i] + k).transpose();
    }
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        for (int k = 0; k < 3; ++k)
            uv.row(3 * (near.size() + i) + k) = obstacles[i]->corner[k].transpose();
    }
    overlap::OverlapOptions options;
    options.totalArea = std::numbers::pi;
    options.job = job.quiet();
    // a < b: an obstacle is always the second one.
    return !overlap::visitOverlaps(uv, options, [&](int a, int b, double) {
        if (a >= own)
            return true;
        return chartsMayMeet && (b >= own || chart[near[a]] != chart[near[b]]);
    });
}

std::vector<const Obstacle *> CutState::obstaclesAt(const Vec2 &low, const Vec2 &high) const
{
    std::vector<const Obstacle *> found;
    if (!anchored || !graph->obstacles)
        return found;
    for (const Obstacle &obstacle : *graph->obstacles) {
        const auto &[a, b, c] = obstacle.corner;
        if ((a.cwiseMin(b).cwiseMin(c).array() <= high.array()).all() &&
            (a.cwiseMax(b).cwiseMax(c).array() >= low.array()).all())
            found.push_back(&obstacle);
    }
    return found;
}

void CutState::spreadCharts()
{
    chartsAreApart = true;
    if (chartCount() < 2 && !graph->obstacles)
        return;
    struct Box
    {
        Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
    };
    const std::vector<char> stays = chartsWithAnchors();
    std::vector<Box> boxes(chartCount());
    for (int c = 0; c < 3 * graph->triangleCount(); ++c) {
        Box &box = boxes[chart[c / 3]];
        box.low = box.low.cwiseMin(at(c));
        box.high = box.high.cwiseMax(at(c));
    }
    // The row width makes the whole about as wide as high.
    double area = 0;
    Vec2 origin = Vec2::Zero(); // beyond the charts that stay, and obstacles
    for (const Obstacle *obstacle : obstaclesAt(Vec2::Constant(-1e300), Vec2::Constant(1e300))) {
        for (const Vec2 &corner : obstacle->corner)
            origin = origin.cwiseMax(corner + Vec2::Constant(chartGap));
    }
    for (int i = 0; i < chartCount(); ++i) {
        area += (boxes[i].high - boxes[i].low + Vec2::Constant(chartGap)).prod();
        if (stays[i])
            origin = origin.cwiseMax(boxes[i].high + Vec2::Constant(chartGap));
    }
    const double rowWidth = std::sqrt(area);
    std::vector<Vec2> shift(chartCount(), Vec2::Zero());
    Vec2 cursor = origin;
    double rowHeight = 0;
    for (int i = 0; i < chartCount(); ++i) {
        if (stays[i])
            continue;
        if (cursor.x() - origin.x() > rowWidth) {
            cursor = Vec2(origin.x(), cursor.y() + rowHeight);
            rowHeight = 0;
        }
        const Vec2 size = boxes[i].high - boxes[i].low + Vec2::Constant(chartGap);
        shift[i] = cursor - boxes[i].low;
        cursor.x() += size.x();
        rowHeight = std::max(rowHeight, size.y());
    }
    for (int c = 0; c < 3 * graph->triangleCount(); ++c)
        cornerAt(x, c) += shift[chart[c / 3]];
}

} // namespace autocuts::search
