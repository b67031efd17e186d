#include "solver/unwrap/alikestacks.h"

#include "model/plain/chartcopies.h"

#include <algorithm>

namespace autocuts::unwrap {

namespace {

//! The charts that may lie in a new stack.
std::vector<int> freeCharts(const ChartMap &charts, const PackJob &pack)
{
    const auto isFree = [&](int face) {
        const IslandFlags &flags = pack.faceFlags[face];
        return flags.locked == 0 && flags.group == 0 && flags.stack == 0 &&
               (pack.movable.empty() || pack.movable[face]) && (pack.stays.empty() || !pack.stays[face]) &&
               std::none_of(pack.rectangles.begin(), pack.rectangles.end(),
                            [face](const PackRectangle &rectangle) { return rectangle.faces[face]; });
    };
    std::vector<int> free;
    const std::vector<std::vector<int>> faces = charts.faces();
    for (int chart = 0; chart < charts.count; ++chart) {
        if (std::all_of(faces[chart].begin(), faces[chart].end(), isFree))
            free.push_back(chart);
    }
    return free;
}

} // namespace

void stackAlike(const MeshData &mesh, const ChartMap &charts, PackJob &pack, UvMatrix &uv)
{
    pack.faceFlags.resize(mesh.faceCount());
    std::int32_t number = 0;
    for (const IslandFlags &flags : pack.faceFlags)
        number = std::max(number, flags.stack);
    std::vector<std::int32_t> stack(charts.count, 0); // per chart
    for (const AlikeCharts &kind :
         findAlikeCharts(mesh, MeshAdjacency(mesh), charts, freeCharts(charts, pack))) {
        stack[kind.original] = ++number;
        for (const ChartCopy &copy : kind.copies) {
            stack[copy.chart] = number;
            for (std::size_t c = 0; c < copy.corner.size(); ++c)
                uv.row(copy.corner[c]) = uv.row(copy.source[c]);
        }
    }
    for (int face = 0; face < mesh.faceCount(); ++face) {
        if (const int chart = charts.faceChart[face]; chart >= 0 && stack[chart] > 0)
            pack.faceFlags[face].stack = stack[chart];
    }
}

} // namespace autocuts::unwrap
