#include "solver/straight/chosenchains.h"

#include <algorithm>

namespace autocuts::straight {

namespace {

//! Adds an edge to a chain that it continues. \returns false when it does not
bool continues(Chain &chain, int one, int other, double length)
{
    std::vector<int> &points = chain.points;
    if (points.size() == 2 && points.back() != one && points.back() != other)
        std::reverse(points.begin(), points.end());
    if (points.back() != one && points.back() != other)
        return false;
    points.push_back(points.back() == one ? other : one);
    chain.length += length;
    return true;
}

//! Joins chains of one loop that meet at their ends: a closed loop may begin in the middle of one.
void joinMeeting(std::vector<Chain> &chains, std::size_t first)
{
    for (std::size_t i = first; i < chains.size(); ++i) {
        for (std::size_t k = i + 1; k < chains.size(); ++k) {
            std::vector<int> &one = chains[i].points, &other = chains[k].points;
            if (one.front() == one.back() || other.front() == other.back())
                continue;
            if (one.front() == other.front() || one.front() == other.back())
                std::reverse(one.begin(), one.end());
            if (one.back() == other.back())
                std::reverse(other.begin(), other.end());
            if (one.back() != other.front())
                continue;
            one.insert(one.end(), other.begin() + 1, other.end());
            chains[i].length += chains[k].length;
            chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(k));
            k = i;
        }
    }
}

} // namespace

std::vector<std::vector<Chain>> chosenChains(const Soup &soup, const CutMesh &charts,
                                             const std::vector<Island> &islands,
                                             const std::vector<std::vector<int>> &loops)
{
    std::vector<std::vector<Chain>> chains(islands.size());
    if (loops.empty())
        return chains;
    const MeshData &mesh = *soup.mesh;
    std::vector<int> place(mesh.triangleCount()); // in its island
    for (const Island &island : islands) {
        for (std::size_t t = 0; t < island.triangles.size(); ++t)
            place[island.triangles[t]] = static_cast<int>(t);
    }
    for (const std::vector<int> &loop : loops) {
        std::vector<std::size_t> begun(islands.size());
        for (std::size_t i = 0; i < islands.size(); ++i)
            begun[i] = chains[i].size();
        for (const int edge : loop) {
            const EdgePair &pair = mesh.edgePairs[edge];
            const bool isOpen = charts.neighbour[3 * pair.triangle[0] + pair.side(0)] < 0;
            for (int which = 0; which < (isOpen ? 2 : 1); ++which) {
                const int t = pair.triangle[which], i = charts.chart[t];
                const std::array<int, 3> &points = islands[i].points[place[t]];
                const int one = points[pair.corner[0][which] % 3], other = points[pair.corner[1][which] % 3];
                const double length = soup.pairLength[2 * edge];
                std::vector<Chain> &own = chains[i];
                const auto first = own.begin() + static_cast<std::ptrdiff_t>(begun[i]);
                if (std::none_of(first, own.end(),
                                 [&](Chain &chain) { return continues(chain, one, other, length); }))
                    own.push_back({{one, other}, length, true});
            }
        }
        for (std::size_t i = 0; i < islands.size(); ++i)
            joinMeeting(chains[i], begun[i]);
    }
    return chains;
}

} // namespace autocuts::straight
