#include "jobs/jobtexts.h"
#include "model/editing/edgechains.h"
#include "model/editing/uvgrid.h"
#include "model/plain/chart.h"
#include "solver/homotopy/localsolve.h"
#include "solver/packing/packmap.h"
#include "solver/unwrap/aligning.h"
#include "views/control/mapjobs/mapjobs.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace autocuts {

namespace {

//! The local problem in which pins hold their corners.
homotopy::LocalProblem localProblem(const Constraints &constraints, const UvTopology &topology)
{
    homotopy::LocalProblem problem;
    problem.pointOfCorner = topology.cornerRoot;
    for (const UvPin &pin : constraints.pins)
        problem.held.push_back(topology.cornerRoot[pin.corner]);
    return problem;
}

int faceOfCorner(const MeshData &mesh, int corner)
{
    const auto next = std::upper_bound(mesh.faceStart.begin(), mesh.faceStart.end(), corner);
    return static_cast<int>(next - mesh.faceStart.begin()) - 1;
}

//! All faces of those islands of the given faces that are not locked, ascending.
std::vector<int> freeIslands(const MeshData &mesh, const UvTopology &topology, const IslandMarks &marks,
                             const QList<int> &faces)
{
    const auto chartFaces = topology.charts.faces();
    std::vector<bool> wanted(chartFaces.size());
    for (int face : faces) {
        const int chart = topology.charts.faceChart[face];
        if (chart >= 0 && marks.flagsOf(chartFaces[chart]).locked == 0)
            wanted[chart] = true;
    }
    std::vector<int> result;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int chart = topology.charts.faceChart[face];
        if (chart >= 0 && wanted[chart])
            result.push_back(face);
    }
    return result;
}

homotopy::LocalSolution solved(const MapInput &input, const homotopy::LocalProblem &problem,
                               JobControl &control)
{
    return homotopy::solveLocally(
        input.mesh(), input.uv, problem,
        {&control.stop(), 1, [&](const JobProgress &done) { control.setProgress(done.fraction); }});
}

//! \param stuck the text for targets that cannot be reached
MapJobResult localResult(const homotopy::LocalSolution &solution, UvEdit edit, int count,
                         const char *stuck = "")
{
    MapJobResult result;
    result.edit = edit;
    result.count = count;
    switch (solution.outcome) {
    case homotopy::LocalSolution::Outcome::Solved:
        result.uv = solution.uv;
        break;
    case homotopy::LocalSolution::Outcome::Empty:
        result.problem = solution.foldedFaces > 0
                             ? JobTexts::tr("The faces are turned over in the map and cannot be solved")
                             : JobTexts::tr("Nothing can move: select more faces, or remove pins and locks");
        break;
    case homotopy::LocalSolution::Outcome::Stuck:
        result.problem = JobTexts::tr(stuck);
        break;
    case homotopy::LocalSolution::Outcome::Cancelled:
        result.problem = JobTexts::tr("Cancelled: the map stays as it was");
        break;
    }
    return result;
}

using Places = std::map<int, Vec2>; //!< of points

//! The grids among the selected faces that are not locked; those with a held point are left.
UvGrids freeGrids(const MapInput &input, const UvTopology &topology, const std::vector<int> &held)
{
    const MeshData &mesh = input.mesh();
    const std::vector<int> free = freeIslands(mesh, topology, input.marks, input.selectedFaces);
    std::vector<int> faces;
    for (const int face : input.selectedFaces) {
        if (std::binary_search(free.begin(), free.end(), face))
            faces.push_back(face);
    }
    UvGrids found = findUvGrids(mesh, topology, input.uv, faces);
    const std::set<int> heldPoints(held.begin(), held.end());
    std::erase_if(found.grids, [&](const UvGrid &grid) {
        const bool isHeld = std::any_of(grid.places.begin(), grid.places.end(),
                                        [&](const auto &place) { return heldPoints.count(place.first) > 0; });
        if (isHeld)
            found.left.insert(found.left.end(), grid.faces.begin(), grid.faces.end());
        return isHeld;
    });
    return found;
}

//! All of these faces whose island has a point without a place.
std::vector<int> partlyPlaced(const MeshData &mesh, const UvTopology &topology, const std::vector<int> &faces,
                              const Places &places)
{
    std::set<int> charts;
    for (const int face : faces) {
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
            if (places.count(topology.cornerRoot[c]) == 0)
                charts.insert(topology.charts.faceChart[face]);
        }
    }
    std::vector<int> result;
    std::copy_if(faces.begin(), faces.end(), std::back_inserter(result),
                 [&](int face) { return charts.count(topology.charts.faceChart[face]) > 0; });
    return result;
}

} // namespace

MapJobResult relaxJob(const MapInput &input, JobControl &control)
{
    const MeshData &mesh = input.mesh();
    const UvTopology topology = findUvTopology(mesh, input.uv);
    homotopy::LocalProblem problem = localProblem(input.constraints, topology);
    const std::vector<int> islands = freeIslands(mesh, topology, input.marks, input.selectedFaces);
    problem.reference = islands;
    std::vector<bool> moves(mesh.faceCount());
    for (int face : input.selectedFaces)
        moves[face] = std::binary_search(islands.begin(), islands.end(), face);
    for (int face = 0; face < mesh.faceCount(); ++face) {
        if (moves[face]) {
            problem.faces.push_back(face);
            continue;
        }
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
            problem.held.push_back(topology.cornerRoot[c]);
    }
    const homotopy::LocalSolution solution = solved(input, problem, control);
    MapJobResult result = localResult(solution, UvEdit::Relax, static_cast<int>(problem.faces.size()));
    if (result.problem.isEmpty())
        result.message = JobTexts::tr("Relaxed: distortion of these faces %1 before, %2 now")
                             .arg(solution.before, 0, 'f', 4)
                             .arg(solution.after, 0, 'f', 4);
    if (result.uv.rows() > 0)
        tellNewOverlaps(input, control, result);
    return result;
}

MapJobResult straightenJob(const MapInput &input, JobControl &control)
{
    const MeshData &mesh = input.mesh();
    const UvTopology topology = findUvTopology(mesh, input.uv);
    const UvChains found = findUvChains(mesh, MeshAdjacency(mesh), topology, input.selectedEdges);
    homotopy::LocalProblem problem = localProblem(input.constraints, topology);
    QList<int> faces;
    for (const UvChain &chain : found.chains) {
        for (const auto &target : straightened(chain, input.uv))
            problem.targets.push_back(target);
        for (int point : chain.points)
            faces << faceOfCorner(mesh, point);
    }
    problem.faces = freeIslands(mesh, topology, input.marks, faces);
    if (problem.targets.empty() || problem.faces.empty()) {
        MapJobResult result;
        result.problem = JobTexts::tr("Select edges that follow each other: a loop without ends, a fork or "
                                      "a locked island cannot be straightened");
        return result;
    }
    const homotopy::LocalSolution solution = solved(input, problem, control);
    MapJobResult result =
        localResult(solution, UvEdit::Straighten, static_cast<int>(found.chains.size()),
                    QT_TRANSLATE_NOOP("autocuts::MapController",
                                      "The chain cannot be made straight without turning faces over"));
    if (result.problem.isEmpty())
        result.message =
            JobTexts::tr("Chains made straight: %1, distortion of their islands %2 before, %3 now")
                .arg(found.chains.size())
                .arg(solution.before, 0, 'f', 4)
                .arg(solution.after, 0, 'f', 4);
    if (result.uv.rows() > 0)
        tellNewOverlaps(input, control, result);
    return result;
}

MapJobResult gridJob(const MapInput &input, JobControl &control)
{
    const MeshData &mesh = input.mesh();
    const UvTopology topology = findUvTopology(mesh, input.uv);
    homotopy::LocalProblem problem = localProblem(input.constraints, topology);
    const UvGrids found = freeGrids(input, topology, problem.held);
    Places places;
    QList<int> gridFaces;
    for (const UvGrid &grid : found.grids) {
        places.insert(grid.places.begin(), grid.places.end());
        gridFaces.append(QList<int>(grid.faces.begin(), grid.faces.end()));
    }
    MapJobResult result;
    if (gridFaces.isEmpty()) {
        result.problem =
            JobTexts::tr("The selected faces are no grid: that needs quads in rows and columns, four "
                         "around every point inside, not closed around a tube and without pins");
        return result;
    }
    const int count = static_cast<int>(gridFaces.size());
    result.edit = UvEdit::Grid;
    result.count = count;
    result.uv = input.uv;
    // Islands that are grids as a whole are only placed; the rest of the others follows.
    problem.faces = partlyPlaced(mesh, topology, freeIslands(mesh, topology, input.marks, gridFaces), places);
    if (!problem.faces.empty()) {
        std::set<int> points;
        for (const int face : problem.faces) {
            for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
                points.insert(topology.cornerRoot[c]);
        }
        for (const auto &place : places) {
            if (points.count(place.first) > 0)
                problem.targets.push_back(place);
        }
        const homotopy::LocalSolution solution = solved(input, problem, control);
        MapJobResult local = localResult(
            solution, UvEdit::Grid, count,
            QT_TRANSLATE_NOOP("autocuts::MapController", "The faces around the grid cannot follow it without "
                                                         "turning over: cut it out first (rip, V)"));
        if (!local.problem.isEmpty())
            return local;
        result.uv = std::move(local.uv);
    }
    for (int c = 0; c < mesh.cornerCount(); ++c) {
        if (const auto place = places.find(topology.cornerRoot[c]); place != places.end())
            result.uv.row(c) = place->second.transpose();
    }
    result.message = JobTexts::tr("Faces in straight grids: %1").arg(count);
    tellNewOverlaps(input, control, result);
    if (!found.left.empty() && result.problem.isEmpty()) {
        result.problemItems.mode = SelectionMode::Faces;
        result.problemItems.faces = QList<int>(found.left.begin(), found.left.end());
        result.problemItems.normalize(mesh);
        result.problem =
            JobTexts::tr(
                "%1. Faces that stay, because they are no quads in rows and columns or are pinned: %2")
                .arg(result.message)
                .arg(found.left.size());
    }
    return result;
}

MapJobResult alignJob(const MapInput &input, const QList<int> &faces, JobControl &control)
{
    const MeshData &mesh = input.mesh();
    const UvTopology topology = findUvTopology(mesh, input.uv);
    const std::vector<int> islands = freeIslands(mesh, topology, input.marks, faces);
    MapJobResult result;
    result.edit = UvEdit::AlignToAxes;
    if (islands.empty()) {
        result.problem =
            JobTexts::tr("Locked islands are not aligned: select others, or unlock them (Ctrl+Shift+L)");
        return result;
    }
    std::set<int> charts;
    for (const int face : islands)
        charts.insert(topology.charts.faceChart[face]);
    result.count = static_cast<int>(charts.size());
    unwrap::AlignInput align;
    align.snapshot = input.snapshot;
    align.snapshot.scope = scopeOf(mesh, QList<int>(islands.begin(), islands.end()), true);
    align.maxDistortion = input.snapshot.settings.maxDistortion;
    align.packing = packing::tileOptions(input.packing);
    const unwrap::AlignResult made = unwrap::alignIslands(
        align, {&control.stop(), 1, [&](const JobProgress &done) { control.setProgress(done.fraction); }});
    result.uv = made.uv;
    if (made.uv.rows() > 0)
        result.flags = input.marks.faceFlags;
    for (std::size_t i = 0; !result.flags.empty() && i < islands.size(); ++i)
        result.flags[islands[i]].aligned = 1;
    if (made.nothingFree)
        result.problem = JobTexts::tr("Islands with pins and stacked or grouped ones are not aligned");
    else if (made.flipped)
        result.problem = JobTexts::tr("Triangles of these islands are flipped: unwrap them first");
    else if (made.uv.rows() == 0)
        result.problem = JobTexts::tr("Cancelled: the map stays as it was");
    else
        result.message = JobTexts::tr("Islands aligned: %1, distortion of these islands %2 before, %3 now")
                             .arg(charts.size())
                             .arg(made.before, 0, 'f', 4)
                             .arg(made.after, 0, 'f', 4);
    if (made.madeSmaller)
        result.problem =
            JobTexts::tr("%1. There was no room at their size: all islands of the tile are smaller now")
                .arg(result.message);
    if (made.noRoom)
        tellNewOverlaps(input, control, result);
    return result;
}

} // namespace autocuts
