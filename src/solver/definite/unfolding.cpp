#include "solver/definite/unfolding.h"

#include "solver/base/cornerat.h"
#include "solver/homotopy/localsolve.h"
#include "solver/overlap/overlapfinder.h"
#include "solver/search/tutte.h"

#include <algorithm>

namespace autocuts::definite {

namespace {

bool keptTogether(const MeshData &mesh, const Snapshot &snapshot, const CutFlags &cut, std::size_t edge)
{
    return mesh.edgePairs[edge].diagonal || (!cut[edge] && snapshot.isJoined(edge));
}

//! True when every unit has a border: without one it cannot be mapped to the plane.
bool allHaveBorders(const CutMesh &units)
{
    std::vector<bool> open(units.chartCount, false);
    for (std::size_t side = 0; side < units.neighbour.size(); ++side) {
        if (units.neighbour[side] < 0)
            open[units.chart[side / 3]] = true;
    }
    return std::find(open.begin(), open.end(), false) == open.end();
}

//! Coordinates in which the folded units have new shapes of low distortion, at arbitrary positions.
std::vector<double> unfolded(const Soup &soup, const CutMesh &units, const std::vector<bool> &folded,
                             const JobContext &job)
{
    const MeshData &mesh = *soup.mesh;
    std::vector<double> x = search::tutteEmbedding(soup, units);
    UvMatrix uv(mesh.cornerCount(), 2);
    homotopy::LocalProblem problem;
    problem.pointOfCorner.resize(mesh.cornerCount());
    std::vector<int> firstCorner(units.uvVertexCount, -1);
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        const int corner = mesh.cornerOfSoup(c);
        int &first = firstCorner[units.uvVertex[c]];
        first = first < 0 ? corner : std::min(first, corner);
        uv.row(corner) = cornerAt(x, c).transpose();
    }
    for (int c = 0; c < mesh.soupCornerCount(); ++c)
        problem.pointOfCorner[mesh.cornerOfSoup(c)] = firstCorner[units.uvVertex[c]];
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        if (folded[units.chart[t]] && (problem.faces.empty() || problem.faces.back() != face))
            problem.faces.push_back(face);
    }
    std::sort(problem.faces.begin(), problem.faces.end());
    const homotopy::LocalSolution solution = homotopy::solveLocally(mesh, uv, problem, job.quiet());
    for (int c = 0; c < mesh.soupCornerCount(); ++c)
        cornerAt(x, c) = solution.uv.row(mesh.cornerOfSoup(c)).transpose();
    return x;
}

//! Per unit: true when two of its triangles overlap.
std::vector<bool> foldedOnes(const CutMesh &units, const std::vector<double> &x)
{
    std::vector<bool> folded(units.chartCount, false);
    overlap::visitOverlapsWithin(rowsOf(x), units.chart, {}, [&](int a, int, double) {
        folded[units.chart[a]] = true;
        return true;
    });
    return folded;
}

} // namespace

void unfoldUnits(const Soup &soup, const Snapshot &snapshot, SeamedMap &map, const JobContext &job)
{
    const MeshData &mesh = *soup.mesh;
    CutFlags apart(map.cut.size());
    for (std::size_t e = 0; e < apart.size(); ++e)
        apart[e] = !keptTogether(mesh, snapshot, map.cut, e);
    const CutMesh units(mesh, apart);
    std::vector<bool> folded = foldedOnes(units, map.x);
    if (std::find(folded.begin(), folded.end(), true) == folded.end() || !allHaveBorders(units))
        return;
    const std::vector<double> x = unfolded(soup, units, folded, job);
    std::vector<std::vector<int>> triangles(units.chartCount);
    for (int t = 0; t < mesh.triangleCount(); ++t)
        triangles[units.chart[t]].push_back(t);
    const UvMatrix uv = rowsOf(x);
    for (int unit = 0; unit < units.chartCount; ++unit) {
        folded[unit] = folded[unit] &&
                       std::all_of(triangles[unit].begin(), triangles[unit].end(),
                                   [&](int t) { return jacobianDeterminant(soup, x.data(), t) > 0; }) &&
                       overlap::findOverlapsAmong(uv, triangles[unit]).pairs.empty();
    }
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (folded[units.chart[t]])
            std::copy_n(x.begin() + 6 * static_cast<std::ptrdiff_t>(t), 6,
                        map.x.begin() + 6 * static_cast<std::ptrdiff_t>(t));
    }
    for (std::size_t e = 0; e < map.cut.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if (apart[e] && (folded[units.chart[pair.triangle[0]]] || folded[units.chart[pair.triangle[1]]]))
            map.cut[e] = true;
    }
}

} // namespace autocuts::definite
