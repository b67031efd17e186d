#include "model/io/formats/uvcorners.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <tuple>

namespace autocuts {

std::vector<int> sharedUvCorners(std::span<const int> vertexOfCorner, int vertexCount, const UvMatrix &uv)
{
    // Corners grouped by vertex, in ascending order.
    const int cornerCount = static_cast<int>(vertexOfCorner.size());
    std::vector<int> start(vertexCount + 1, 0);
    for (int v : vertexOfCorner)
        ++start[v + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> corners(cornerCount);
    std::vector<int> fill(start.begin(), start.end() - 1);
    for (int c = 0; c < cornerCount; ++c)
        corners[fill[vertexOfCorner[c]]++] = c;

    const auto bits = [&uv](int corner) {
        std::array<std::uint64_t, 2> key;
        std::memcpy(key.data(), uv.data() + 2 * static_cast<std::ptrdiff_t>(corner), sizeof key);
        return key;
    };
    std::vector<int> shared(cornerCount, -1);
    for (int v = 0; v < vertexCount; ++v) {
        const auto begin = corners.begin() + start[v];
        const auto end = corners.begin() + start[v + 1];
        std::sort(begin, end, [&](int a, int b) { return std::tuple(bits(a), a) < std::tuple(bits(b), b); });
        for (auto it = begin; it != end; ++it) {
            if (!uv.row(*it).allFinite())
                continue;
            shared[*it] = it != begin && bits(*it) == bits(*(it - 1)) ? shared[*(it - 1)] : *it;
        }
    }
    return shared;
}

std::vector<int> sharedUvCorners(const MeshData &mesh, const UvMatrix &uv)
{
    std::vector<int> welded(mesh.cornerVertex.size());
    std::transform(mesh.cornerVertex.begin(), mesh.cornerVertex.end(), welded.begin(),
                   [&mesh](int v) { return mesh.vertexWeld[v]; });
    return sharedUvCorners(welded, mesh.vertexCount(), uv);
}

} // namespace autocuts
