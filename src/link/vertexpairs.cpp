#include "link/vertexpairs.h"

#include "model/plain/polygonsides.h"

#include <algorithm>

namespace autocuts::link {

VertexPairs::VertexPairs(const MeshData &mesh)
{
    std::vector<int> next(static_cast<std::size_t>(mesh.cornerCount()));
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int first = mesh.faceStart[face], end = mesh.faceStart[face + 1];
        for (int c = first; c < end; ++c)
            next[c] = c + 1 < end ? c + 1 : first;
    }
    for (int pair = 0; pair < static_cast<int>(mesh.edgePairs.size()); ++pair) {
        if (mesh.edgePairs[pair].diagonal)
            continue;
        for (const int corner : sidePair(mesh, pair).startCorner) {
            const auto [low, high] = std::minmax(mesh.cornerVertex[corner], mesh.cornerVertex[next[corner]]);
            mEntries.push_back({{low, high}, pair});
        }
    }
    std::sort(mEntries.begin(), mEntries.end());
    mEntries.erase(std::unique(mEntries.begin(), mEntries.end()), mEntries.end());
}

std::vector<int> VertexPairs::edgePairs(const std::vector<VertexPair> &names) const
{
    std::vector<int> found;
    auto at = mEntries.begin();
    for (const VertexPair &name : names) {
        at = std::lower_bound(at, mEntries.end(), name,
                              [](const Entry &entry, const VertexPair &key) { return entry.name < key; });
        for (auto same = at; same != mEntries.end() && same->name == name; ++same)
            found.push_back(same->edgePair);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::vector<VertexPair> VertexPairs::names(const std::vector<bool> &chosen) const
{
    std::vector<VertexPair> result;
    for (const Entry &entry : mEntries) {
        if (chosen[entry.edgePair] && (result.empty() || result.back() != entry.name))
            result.push_back(entry.name);
    }
    return result;
}

} // namespace autocuts::link
