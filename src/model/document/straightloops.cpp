#include "model/document/straightloops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace autocuts {

namespace {

//! Least share of half the angle around a vertex that lies between two edges that continue each other: more
//! than that of the three edges at the corner of a box. Chosen by hand.
constexpr double leastShare = 0.7;

//! Two edges at a vertex, and how nearly one continues the other: 1 when exactly.
struct Pairing
{
    double straightness;
    int one, other;
};

class LoopFinder
{
public:
    explicit LoopFinder(const Document &document)
        : mMesh(document.mesh()), mAdjacency(document.adjacency()), mStraight(document.seams().straight)
    {}

    std::vector<std::vector<int>> find()
    {
        std::map<int, std::vector<int>> marked; // per vertex
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            const auto [a, b] = mAdjacency.edgeVertices(static_cast<int>(e));
            if (mStraight[2 * e] == 0 || a == b)
                continue;
            mNext[static_cast<int>(e)] = {-1, -1};
            marked[a].push_back(static_cast<int>(e));
            marked[b].push_back(static_cast<int>(e));
        }
        for (const auto &[vertex, edges] : marked) {
            if (edges.size() > 1)
                connect(vertex, edges);
        }
        return traced();
    }

private:
    //! An edge next to another one at a vertex, and the angle of the face between them.
    struct Neighbour
    {
        int edge;
        double angle;
    };

    double angleAt(int corner) const
    {
        const int face = mAdjacency.faceOfCorner(corner);
        const int first = mMesh.faceStart[face], last = mMesh.faceStart[face + 1] - 1;
        const Vec3 at = mMesh.cornerPosition(corner);
        const Vec3 next = mMesh.cornerPosition(corner == last ? first : corner + 1) - at;
        const Vec3 before = mMesh.cornerPosition(corner == first ? last : corner - 1) - at;
        return std::atan2(next.cross(before).norm(), next.dot(before));
    }

    int edgeBefore(int corner) const
    {
        const int face = mAdjacency.faceOfCorner(corner);
        return mAdjacency.edgeOfCorner(corner == mMesh.faceStart[face] ? mMesh.faceStart[face + 1] - 1
                                                                       : corner - 1);
    }

    int &next(int edge, int vertex) { return mNext[edge][mAdjacency.edgeVertices(edge)[1] == vertex]; }

    //! Pairs the edges at a vertex, those first that continue each other best.
    void connect(int vertex, const std::vector<int> &edges)
    {
        std::map<int, std::vector<Neighbour>> around;
        for (const int corner : mAdjacency.vertexCorners(vertex)) {
            const int after = mAdjacency.edgeOfCorner(corner), before = edgeBefore(corner);
            if (after < 0 || before < 0)
                continue;
            const double angle = angleAt(corner);
            around[after].push_back({before, angle});
            around[before].push_back({after, angle});
        }
        std::vector<Pairing> pairings;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t k = i + 1; k < edges.size(); ++k) {
                const double straightness = straightnessOf(around, edges[i], edges[k]);
                if (straightness >= leastShare)
                    pairings.push_back({straightness, edges[i], edges[k]});
            }
        }
        std::stable_sort(pairings.begin(), pairings.end(),
                         [](const Pairing &a, const Pairing &b) { return a.straightness > b.straightness; });
        for (const Pairing &pairing : pairings) {
            int &one = next(pairing.one, vertex), &other = next(pairing.other, vertex);
            if (one < 0 && other < 0) {
                one = pairing.other;
                other = pairing.one;
            }
        }
    }

    static double straightnessOf(const std::map<int, std::vector<Neighbour>> &around, int one, int other)
    {
        std::vector<double> angles; // from one edge to the other, on its sides
        const auto begin = around.find(one);
        for (std::size_t way = 0; begin != around.end() && way < begin->second.size(); ++way) {
            double angle = begin->second[way].angle;
            int before = one, at = begin->second[way].edge;
            for (std::size_t steps = 0; at != other && at != one && steps < around.size(); ++steps) {
                const std::vector<Neighbour> &sides = around.at(at);
                const auto onward = std::find_if(sides.begin(), sides.end(),
                                                 [&](const Neighbour &side) { return side.edge != before; });
                if (onward == sides.end())
                    break;
                angle += onward->angle;
                before = at;
                at = onward->edge;
            }
            if (at == other)
                angles.push_back(angle);
        }
        if (angles.size() == 1) // at a border of the mesh
            return 1 - std::abs(angles[0] - std::numbers::pi) / std::numbers::pi;
        return angles.size() == 2 ? 2 * std::min(angles[0], angles[1]) / (angles[0] + angles[1]) : 0;
    }

    std::vector<std::vector<int>> traced()
    {
        std::vector<std::vector<int>> loops;
        std::map<int, bool> seen;
        const auto trace = [&](int edge, int vertex) {
            std::vector<int> &loop = loops.emplace_back();
            while (edge >= 0 && !std::exchange(seen[edge], true)) {
                loop.push_back(edge);
                vertex = mAdjacency.otherEnd(edge, vertex);
                edge = next(edge, vertex);
            }
        };
        for (const auto &[edge, nexts] : mNext) {
            for (int end = 0; end < 2; ++end) {
                if (nexts[end] < 0 && !seen[edge])
                    trace(edge, mAdjacency.edgeVertices(edge)[end]);
            }
        }
        for (const auto &[edge, nexts] : mNext) {
            if (!seen[edge]) // a closed loop
                trace(edge, mAdjacency.edgeVertices(edge)[0]);
        }
        return loops;
    }

    const MeshData &mMesh;
    const MeshAdjacency &mAdjacency;
    const std::vector<std::uint8_t> &mStraight;
    std::map<int, std::array<int, 2>> mNext; //!< per edge: the one that follows at its first and second end
};

} // namespace

std::vector<std::vector<int>> straightLoops(const Document &document)
{
    const std::vector<std::uint8_t> &straight = document.seams().straight;
    if (std::none_of(straight.begin(), straight.end(), [](std::uint8_t mark) { return mark != 0; }))
        return {};
    return LoopFinder(document).find();
}

} // namespace autocuts
