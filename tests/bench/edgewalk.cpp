#include "edgewalk.h"

#include <algorithm>
#include <map>

namespace autocuts::bench {

std::vector<int> walkEdges(const MeshData &mesh, int first, int count,
                           const std::function<bool(int)> &isWanted)
{
    std::map<int, std::vector<int>> edgesAt;
    const auto vertex = [&](int e, int end) { return mesh.vertexOfSoup(mesh.edgePairs[e].corner[end][0]); };
    for (int e = 0; e < static_cast<int>(mesh.edgePairs.size()); ++e) {
        for (int end = 0; end < 2; ++end)
            edgesAt[vertex(e, end)].push_back(e);
    }
    std::vector<int> path{first};
    int at = vertex(first, 1);
    std::vector<int> seen{vertex(first, 0), at};
    while (static_cast<int>(path.size()) < count) {
        int next = -1, end = 0;
        for (const int e : edgesAt[at]) {
            for (int k = 0; k < 2; ++k) {
                const int other = vertex(e, k);
                if (other != at && isWanted(e) && std::find(seen.begin(), seen.end(), other) == seen.end()) {
                    next = e;
                    end = other;
                }
            }
        }
        if (next < 0)
            break;
        path.push_back(next);
        seen.push_back(end);
        at = end;
    }
    return path;
}

} // namespace autocuts::bench
