#include "api/mapoutput.h"

#include "model/plain/chart.h"
#include "model/plain/uvseams.h"

#include <algorithm>

namespace autocuts::api {

namespace {

//! Per corner: the side that starts there is a seam or a border.
std::vector<std::uint8_t> seamsOf(const MeshData &mesh, const UvMatrix &uv)
{
    const UvTopology topology = findUvTopology(mesh, uv);
    // The sides by the UV vertices at their ends: stitched sides have the same.
    std::vector<std::pair<std::pair<int, int>, int>> sides;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int first = mesh.faceStart[std::size_t(face)], end = mesh.faceStart[std::size_t(face) + 1];
        for (int c = first; c < end; ++c) {
            const int from = topology.cornerRoot[std::size_t(c)];
            const int to = topology.cornerRoot[std::size_t(c + 1 < end ? c + 1 : first)];
            if (topology.faceHasUv[std::size_t(face)])
                sides.push_back({std::minmax(from, to), c});
        }
    }
    std::ranges::sort(sides);
    std::vector<std::uint8_t> seams(std::size_t(mesh.cornerCount()), 1);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        if (sides[i].first == sides[i - 1].first)
            seams[std::size_t(sides[i].second)] = seams[std::size_t(sides[i - 1].second)] = 0;
    }
    return seams;
}

} // namespace

std::unique_ptr<autocuts_map> mapOf(const Snapshot &snapshot, const packing::PackOptions &packing,
                                    UvMatrix uv)
{
    auto map = std::make_unique<autocuts_map>();
    map->mesh = snapshot.mesh;
    map->uv = std::move(uv);
    map->textureSize = packing.textureSize;
    map->tileHeight = snapshot.tileHeight;
    map->given.reserve(2 * std::size_t(map->uv.rows()));
    for (Eigen::Index c = 0; c < map->uv.rows(); ++c) {
        map->given.push_back(map->uv(c, 0));
        map->given.push_back(map->uv(c, 1) / snapshot.tileHeight);
    }
    const ChartMap charts = findCharts(*map->mesh, map->uv);
    map->islands.assign(charts.faceChart.begin(), charts.faceChart.end());
    map->islandCount = std::size_t(charts.count);
    map->seams = seamsOf(*map->mesh, map->uv);
    return map;
}

void setUnmet(const unwrap::UnmetSteering &unmet, autocuts_outcome &outcome)
{
    outcome.unmet_pins = std::ssize(unmet.pins);
    outcome.unmet_joins = std::ssize(unmet.joins);
    outcome.missing_seams = std::ssize(unmet.missingSeams);
}

} // namespace autocuts::api
