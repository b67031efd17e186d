#include "model/plain/rigidpieces.h"

#include "model/plain/unionfind.h"

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

//! The piece of each chart, and the number of pieces.
std::pair<std::vector<int>, int> pieceLabels(const std::vector<std::vector<int>> &chartFaces,
                                             const std::vector<IslandFlags> &faceFlags)
{
    UnionFind pieces(static_cast<int>(chartFaces.size()));
    std::map<int, int> firstOfStack, firstOfGroup;
    for (int c = 0; c < static_cast<int>(chartFaces.size()); ++c) {
        const IslandFlags flags = flagsOf(faceFlags, chartFaces[c]);
        if (flags.stack != 0)
            pieces.unite(c, firstOfStack.try_emplace(flags.stack, c).first->second);
        if (flags.group != 0)
            pieces.unite(c, firstOfGroup.try_emplace(flags.group, c).first->second);
    }
    return pieces.labels();
}

} // namespace

std::vector<int> stackOfCharts(const ChartMap &charts, const std::vector<IslandFlags> &faceFlags)
{
    std::vector<int> stacks(charts.count, 0);
    if (!faceFlags.empty()) {
        const auto chartFaces = charts.faces();
        for (int c = 0; c < charts.count; ++c)
            stacks[c] = flagsOf(faceFlags, chartFaces[c]).stack;
    }
    return stacks;
}

RigidPieces rigidPieces(const ChartMap &charts, const std::vector<IslandFlags> &faceFlags,
                        const std::vector<bool> &movable)
{
    const auto chartFaces = charts.faces();
    const auto [label, count] = pieceLabels(chartFaces, faceFlags);
    RigidPieces result{charts, std::vector<bool>(count), std::vector<bool>(count), std::vector<bool>(count)};
    result.pieces.count = count;
    for (int &chart : result.pieces.faceChart)
        chart = chart < 0 ? chart : label[chart];
    std::vector<bool> moves(count, movable.empty());
    for (std::size_t c = 0; c < chartFaces.size(); ++c) {
        const IslandFlags flags = flagsOf(faceFlags, chartFaces[c]);
        if (flags.locked != 0)
            result.locked[label[c]] = true;
        if (flags.upright != 0)
            result.upright[label[c]] = true;
        if (flags.aligned != 0)
            result.aligned[label[c]] = true;
        if (!movable.empty() &&
            std::any_of(chartFaces[c].begin(), chartFaces[c].end(), [&](int face) { return movable[face]; }))
            moves[label[c]] = true;
    }
    for (int p = 0; p < count; ++p)
        result.locked[p] = result.locked[p] || !moves[p];
    return result;
}

} // namespace autocuts
