#include "model/editing/edgechains.h"

#include "model/plain/chart.h"

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

//! For each point, its neighbours and the lengths of the edges to them.
using Neighbours = std::map<int, std::map<int, double>>;

Neighbours neighbours(const MeshData &mesh, const MeshAdjacency &adjacency, const UvTopology &topology,
                      const std::vector<int> &edges)
{
    Neighbours result;
    for (int edge : edges) {
        for (int face : adjacency.edgeFaces(edge)) {
            if (face < 0 || !topology.faceHasUv[face])
                continue;
            const int first = mesh.faceStart[face], end = mesh.faceStart[face + 1];
            for (int c = first; c < end; ++c) {
                if (adjacency.edgeOfCorner(c) != edge)
                    continue;
                const int a = topology.cornerRoot[c], b = topology.cornerRoot[c + 1 < end ? c + 1 : first];
                if (a != b)
                    result[a][b] = result[b][a] = adjacency.edgeLength(edge);
            }
        }
    }
    return result;
}

//! All points connected to the first one.
std::vector<int> connected(const Neighbours &all, int first, std::map<int, bool> &seen)
{
    std::vector<int> result{first};
    seen[first] = true;
    for (std::size_t i = 0; i < result.size(); ++i) {
        for (const auto &[next, length] : all.at(result[i])) {
            if (!std::exchange(seen[next], true))
                result.push_back(next);
        }
    }
    return result;
}

} // namespace

UvChains findUvChains(const MeshData &mesh, const MeshAdjacency &adjacency, const UvTopology &topology,
                      const std::vector<int> &edges)
{
    const Neighbours all = neighbours(mesh, adjacency, topology, edges);
    UvChains result;
    std::map<int, bool> seen;
    for (const auto &[first, around] : all) {
        if (seen[first])
            continue;
        const std::vector<int> points = connected(all, first, seen);
        std::vector<int> ends;
        bool forks = false;
        for (int point : points) {
            const std::size_t count = all.at(point).size();
            forks = forks || count > 2;
            if (count == 1)
                ends.push_back(point);
        }
        if (forks || ends.size() != 2 || points.size() < 3) {
            ++result.left;
            continue;
        }
        UvChain chain;
        int before = -1, at = std::min(ends[0], ends[1]);
        chain.points.push_back(at);
        while (chain.points.size() < points.size()) {
            const auto &next = all.at(at);
            const auto way = std::find_if(next.begin(), next.end(),
                                          [&](const auto &entry) { return entry.first != before; });
            chain.lengths.push_back(way->second);
            before = std::exchange(at, way->first);
            chain.points.push_back(at);
        }
        result.chains.push_back(std::move(chain));
    }
    return result;
}

std::vector<std::pair<int, Vec2>> straightened(const UvChain &chain, const UvMatrix &uv)
{
    const auto place = [&uv](int point) -> Vec2 { return uv.row(point).transpose(); };
    double length = 0, length3d = 0;
    for (std::size_t i = 0; i + 1 < chain.points.size(); ++i) {
        length += (place(chain.points[i + 1]) - place(chain.points[i])).norm();
        length3d += chain.lengths[i];
    }
    const Vec2 first = place(chain.points.front()), last = place(chain.points.back());
    if (!((last - first).norm() > 1e-6 * length) || !(length3d > 0))
        return {};
    const Vec2 along = (last - first).normalized();
    const Vec2 start = 0.5 * (first + last) - 0.5 * length * along;
    std::vector<std::pair<int, Vec2>> result;
    double way = 0;
    for (std::size_t i = 0; i < chain.points.size(); ++i) {
        result.emplace_back(chain.points[i], start + length * way / length3d * along);
        if (i < chain.lengths.size())
            way += chain.lengths[i];
    }
    return result;
}

} // namespace autocuts
