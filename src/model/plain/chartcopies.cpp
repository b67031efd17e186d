#include "model/plain/chartcopies.h"

#include "model/plain/copymatcher.h"

#include <algorithm>

namespace autocuts {

namespace {

//! What copies have in common, quick to compare.
struct Kind
{
    int chart;
    std::vector<std::uint64_t> colours, sorted; //!< of its faces
    std::vector<double> lengths;                //!< of its polygon sides
    AlikeCharts alike;
};

//! Matches a chart with the original of a kind. \returns false when it is no copy
bool matches(CopyMatcher &matcher, const Kind &kind, const Kind &chart, ChartCopy &copy)
{
    if (kind.sorted != chart.sorted || !CopyMatcher::sameLengths(kind.lengths, chart.lengths))
        return false;
    for (const bool mirrored : {false, true}) {
        copy.mirrored = mirrored;
        if (matcher.match(kind.chart, chart.chart, mirrored, kind.colours, chart.colours))
            return true;
    }
    return false;
}

} // namespace

std::vector<AlikeCharts> findAlikeCharts(const MeshData &mesh, const MeshAdjacency &adjacency,
                                         const ChartMap &charts, const std::vector<int> &candidates)
{
    const std::vector<std::vector<int>> faces = charts.faces();
    CopyMatcher matcher(mesh, adjacency, charts.faceChart, faces);
    std::vector<Kind> kinds;
    for (const int chart : candidates) {
        Kind own{chart, matcher.colours(chart), {}, matcher.sideLengths(chart), {chart, {}}};
        own.sorted = own.colours;
        std::sort(own.sorted.begin(), own.sorted.end());
        ChartCopy copy{chart, false, {}, {}};
        const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                       [&](const Kind &other) { return matches(matcher, other, own, copy); });
        if (kind == kinds.end()) {
            kinds.push_back(std::move(own));
            continue;
        }
        for (const int face : faces[chart]) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
                copy.corner.push_back(c);
                copy.source.push_back(matcher.sourceCorner(c));
            }
        }
        kind->alike.copies.push_back(std::move(copy));
    }
    std::vector<AlikeCharts> found;
    for (Kind &kind : kinds) {
        if (!kind.alike.copies.empty())
            found.push_back(std::move(kind.alike));
    }
    return found;
}

} // namespace autocuts
