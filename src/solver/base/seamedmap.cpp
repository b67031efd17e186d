#include "solver/base/seamedmap.h"

#include "model/plain/unionfind.h"
#include "model/plain/uvseams.h"
#include "solver/base/cornerat.h"

#include <cmath>
#include <numbers>

namespace autocuts {

double SeamedMap::distortion(const Soup &soup) const
{
    return distortion(soup, {});
}

double SeamedMap::distortion(const Soup &soup, const std::vector<double> &stiffness) const
{
    // With the map scaled by s the mean is (s^2 P + Q / s^2) / W. Its least value over s is 2 sqrt(P Q) / W.
    double p = 0, q = 0, w = 0, stiff = 0;
    for (int t = 0; t < soup.triangleCount(); ++t) {
        if (soup.mesh->triangleDegenerate[t])
            continue;
        const double *c = &x[6 * static_cast<std::size_t>(t)];
        const Soup::Basis &b = soup.basis[t];
        const double j00 = c[0] * b[0] + c[2] * b[2] + c[4] * b[4];
        const double j01 = c[0] * b[1] + c[2] * b[3] + c[4] * b[5];
        const double j10 = c[1] * b[0] + c[3] * b[2] + c[5] * b[4];
        const double j11 = c[1] * b[1] + c[3] * b[3] + c[5] * b[5];
        const double squares = j00 * j00 + j01 * j01 + j10 * j10 + j11 * j11;
        const double det = j00 * j11 - j01 * j10;
        const double factor = stiffness.empty() ? 1 : stiffness[t];
        p += soup.weight[t] * factor * squares;
        q += soup.weight[t] * factor * squares / (det * det);
        w += soup.weight[t];
        stiff += soup.weight[t] * factor;
    }
    return stiffness.empty() ? 2 * std::sqrt(p * q) / w : 4 + (2 * std::sqrt(p * q) - 4 * stiff) / w;
}

double SeamedMap::seamLength(const Soup &soup) const
{
    double sum = 0;
    for (std::size_t e = 0; e < cut.size(); ++e) {
        if (cut[e])
            sum += soup.pairLength[2 * e];
    }
    return sum;
}

double windingSeamLength(const MeshData &mesh)
{
    double both = 0; // sides of each edge
    for (const BoundarySide &open : mesh.boundarySides) {
        if (open.reason != OpenSide::Winding)
            continue;
        const std::array<int, 3> &corners = mesh.triangles[open.triangle];
        both += (mesh.cornerPosition(corners[open.side]) - mesh.cornerPosition(corners[(open.side + 1) % 3]))
                    .norm();
    }
    return both > 0 ? 0.5 * both / std::sqrt(mesh.area / std::numbers::pi) : 0;
}

double SeamedMap::seamCost(const Soup &soup, const Snapshot &snapshot) const
{
    const bool counts = snapshot.settings.weighting == SeamWeighting::Count;
    double sum = 0;
    for (std::size_t e = 0; e < cut.size(); ++e) {
        if (cut[e])
            sum += snapshot.edgeWeight(e) * (counts ? soup.meanEdgeLength : soup.pairLength[2 * e]);
    }
    return sum;
}

std::string SeamedMap::validate(const Soup &soup) const
{
    const MeshData &mesh = *soup.mesh;
    if (cut.size() != mesh.edgePairs.size() || static_cast<int>(x.size()) != soup.coordinateCount())
        return "the map does not fit the mesh";
    for (std::size_t e = 0; e < cut.size(); ++e) {
        if (cut[e] && mesh.edgePairs[e].diagonal)
            return "a polygon is split";
    }
    const CutMesh state(mesh, cut);
    std::vector<int> first(state.uvVertexCount, -1);
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        int &f = first[state.uvVertex[c]];
        if (f < 0)
            f = c;
        if (cornerAt(x, c) != cornerAt(x, f))
            return "two corners of one UV vertex are apart";
    }
    for (int t = 0; t < soup.triangleCount(); ++t) {
        if (!(jacobianDeterminant(soup, x.data(), t) > 0))
            return "a triangle is flipped or has no area";
    }
    return {};
}

std::optional<SeamedMap> seamedMapOf(const Soup &soup, const UvMatrix &uv, const CutFlags &alwaysCut)
{
    const MeshData &mesh = *soup.mesh;
    if (!uv.allFinite())
        return std::nullopt;
    SeamedMap map;
    map.cut = alwaysCut;
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    for (std::size_t e = 0; e < map.cut.size(); ++e)
        map.cut[e] = !mesh.edgePairs[e].diagonal && (map.cut[e] || open[2 * e] || open[2 * e + 1]);
    // Equal UVs in the file may differ by rounding.
    const CutMesh state(mesh, map.cut);
    std::vector<int> first(state.uvVertexCount, -1);
    map.x.resize(soup.coordinateCount());
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        int &f = first[state.uvVertex[c]];
        if (f < 0)
            f = c;
        cornerAt(map.x, c) = uv.row(mesh.cornerOfSoup(f)).transpose();
    }
    if (!map.validate(soup).empty())
        return std::nullopt;
    return map;
}

std::vector<bool> heldCharts(const Snapshot &snapshot, const CutMesh &charts)
{
    if (snapshot.steering->pins.empty())
        return {};
    std::vector<bool> held(charts.chartCount, false);
    for (const Pin &pin : snapshot.steering->pins)
        held[charts.chart[pin.soupCorner / 3]] = true;
    return held;
}

UvMatrix cornerUv(const Soup &soup, const SeamedMap &map)
{
    const MeshData &mesh = *soup.mesh;
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.soupCornerCount(); ++c)
        uv.row(mesh.cornerOfSoup(c)) = cornerAt(map.x, c).transpose();
    return uv;
}

ChartMap chartsOf(const MeshData &mesh, const CutMesh &state)
{
    // The triangles of a polygon that meets itself may lie in several charts: as an island, these are one.
    std::vector<int> first(static_cast<std::size_t>(mesh.faceCount()), -1);
    UnionFind islands(state.chartCount);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        int &chart = first[mesh.triangleFace[t]];
        if (chart < 0)
            chart = state.chart[t];
        islands.unite(chart, state.chart[t]);
    }
    const auto [label, count] = islands.labels();
    ChartMap charts;
    charts.count = count;
    for (const int chart : first)
        charts.faceChart.push_back(chart < 0 ? -1 : label[chart]);
    return charts;
}

} // namespace autocuts
