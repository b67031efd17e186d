#include "model/io/gltf/gltfvertices.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string_view>
#include <unordered_set>

namespace autocuts {

namespace {

//! The first vertex with the same attributes, for each old vertex that is used.
std::vector<std::uint32_t> firstEqualVertices(const std::vector<std::uint32_t> &used,
                                              const std::vector<const GltfElements *> &kept)
{
    const auto hash = [&](std::uint32_t vertex) {
        std::size_t result = 0;
        for (const GltfElements *column : kept) {
            const std::string_view bytes(column->at(vertex), column->size);
            result = (result ^ std::hash<std::string_view>()(bytes)) * 0x9E3779B97F4A7C15ull;
        }
        return result;
    };
    const auto equal = [&](std::uint32_t a, std::uint32_t b) {
        return std::all_of(kept.begin(), kept.end(), [&](const GltfElements *column) {
            return std::memcmp(column->at(a), column->at(b), column->size) == 0;
        });
    };
    std::unordered_set<std::uint32_t, decltype(hash), decltype(equal)> known(used.size(), hash, equal);
    std::vector<std::uint32_t> first;
    for (const std::uint32_t vertex : used)
        first.push_back(*known.insert(vertex).first);
    return first;
}

//! A negative, zero or positive number as memcmp() does, for the new UVs of two corners.
int compareUvs(const std::vector<FileUvs> &uvs, std::uint32_t a, std::uint32_t b)
{
    for (const FileUvs &set : uvs) {
        if (const int order = std::memcmp(&set[a], &set[b], sizeof set[a]))
            return order;
    }
    return 0;
}

} // namespace

GltfVertexMap mapVertices(const std::vector<std::uint32_t> &corners,
                          const std::vector<const GltfElements *> &kept, const std::vector<FileUvs> &uvs)
{
    std::vector<std::uint32_t> used = corners;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    const std::vector<std::uint32_t> first = firstEqualVertices(used, kept);
    std::vector<std::uint32_t> of(corners.size()), order(corners.size());
    for (std::size_t c = 0; c < corners.size(); ++c)
        of[c] = first[static_cast<std::size_t>(std::lower_bound(used.begin(), used.end(), corners[c]) -
                                               used.begin())];

    // Corners of one new vertex become neighbours; the one that stands first in the file leads them.
    std::iota(order.begin(), order.end(), 0);
    const auto together = [&](std::uint32_t a, std::uint32_t b) {
        return of[a] == of[b] && compareUvs(uvs, a, b) == 0;
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (of[a] != of[b])
            return of[a] < of[b];
        const int uv = compareUvs(uvs, a, b);
        return uv != 0 ? uv < 0 : a < b;
    });
    std::vector<std::uint32_t> leader(corners.size()), leaders;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool leads = i == 0 || !together(order[i - 1], order[i]);
        leader[order[i]] = leads ? order[i] : leader[order[i - 1]];
        if (leads)
            leaders.push_back(order[i]);
    }

    // The new vertex that has the first corner of an old one takes its place, the others follow.
    std::vector<std::uint32_t> firstCorner(used.size(), static_cast<std::uint32_t>(corners.size()));
    const auto place = [&](std::uint32_t corner) {
        return static_cast<std::size_t>(std::lower_bound(used.begin(), used.end(), of[corner]) -
                                        used.begin());
    };
    for (const std::uint32_t corner : leaders)
        firstCorner[place(corner)] = std::min(firstCorner[place(corner)], corner);
    const auto isAdded = [&](std::uint32_t corner) { return firstCorner[place(corner)] != corner; };
    std::sort(leaders.begin(), leaders.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (isAdded(a) != isAdded(b))
            return isAdded(b);
        return isAdded(a) ? a < b : of[a] < of[b];
    });

    GltfVertexMap map;
    std::vector<std::uint32_t> number(corners.size());
    for (const std::uint32_t corner : leaders) {
        number[corner] = static_cast<std::uint32_t>(map.oldVertex.size());
        map.oldVertex.push_back(of[corner]);
        map.corner.push_back(corner);
    }
    for (std::size_t c = 0; c < corners.size(); ++c)
        map.cornerVertex.push_back(number[leader[c]]);
    map.same = leaders.size() == used.size() && std::equal(used.begin(), used.end(), map.oldVertex.begin());
    return map;
}

} // namespace autocuts
