#include "model/editing/similarislands.h"

#include "model/document/islands.h"
#include "model/plain/copymatcher.h"

#include <algorithm>

namespace autocuts {

namespace {

//! The colours of an island's faces, sorted: equal for islands with the same neighbourhoods.
std::vector<std::uint64_t> sortedColours(CopyMatcher &matcher, int island)
{
    std::vector<std::uint64_t> colours = matcher.colours(island);
    std::sort(colours.begin(), colours.end());
    return colours;
}

} // namespace

std::vector<int> similarIslands(const MeshData &mesh, const MeshAdjacency &adjacency, const Islands &islands,
                                int island, Similarity similarity)
{
    CopyMatcher matcher(mesh, adjacency, islands.ofFaces(), islands.allFaces());
    const auto colours = sortedColours(matcher, island);
    const auto lengths = matcher.sideLengths(island);
    std::vector<int> result;
    for (int other = 0; other < islands.count(); ++other) {
        if (islands.faces(other).size() != islands.faces(island).size() ||
            sortedColours(matcher, other) != colours)
            continue;
        if (similarity == Similarity::Shape && !CopyMatcher::sameLengths(matcher.sideLengths(other), lengths))
            continue;
        result.push_back(other);
    }
    return result;
}

} // namespace autocuts
