// MeshData::validate(): checks every invariant of the derived data against the polygons.
#include "model/plain/meshdata.h"

#include "model/plain/unionfind.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace autocuts {

namespace {

bool inRange(int index, int count)
{
    return index >= 0 && index < count;
}

std::string checkSizes(const MeshData &mesh)
{
    const auto triangles = mesh.triangles.size();
    if (mesh.faceStart.empty() || mesh.faceStart.front() != 0 ||
        mesh.faceStart.back() != mesh.cornerCount() ||
        static_cast<int>(mesh.faceObject.size()) != mesh.faceCount())
        return "the face arrays do not fit together";
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (mesh.faceStart[f + 1] > mesh.cornerCount() || mesh.faceStart[f + 1] < mesh.faceStart[f] + 3)
            return "a face has fewer than three corners";
    }
    for (int v : mesh.cornerVertex) {
        if (!inRange(v, mesh.vertexCount()))
            return "a corner's vertex is out of range";
    }
    if (mesh.triangleCount() != mesh.cornerCount() - 2 * mesh.faceCount())
        return "the number of triangles does not fit the polygons";
    if (static_cast<int>(mesh.faceTriangle.size()) != mesh.faceCount())
        return "faceTriangle has the wrong size";
    if (!mesh.texelWeight.empty() && static_cast<int>(mesh.texelWeight.size()) != mesh.faceCount())
        return "the texel weights do not fit the faces";
    if (mesh.triangleFace.size() != triangles || mesh.triangleArea.size() != triangles ||
        mesh.triangleDegenerate.size() != triangles || mesh.component.size() != triangles)
        return "an array over the triangles has the wrong size";
    return {};
}

std::string checkWelding(const MeshData &mesh)
{
    if (static_cast<int>(mesh.vertexWeld.size()) != mesh.vertexCount())
        return "vertexWeld has the wrong size";
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const int first = mesh.vertexWeld[v];
        if (!inRange(first, v + 1) || mesh.vertexWeld[first] != first)
            return "a vertex is not welded to a first one";
        if (mesh.positions.row(v) != mesh.positions.row(first))
            return "vertices at different positions are welded";
    }
    return {};
}

std::string checkTriangles(const MeshData &mesh)
{
    double area = 0;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        if (!inRange(face, mesh.faceCount()))
            return "a triangle's face is out of range";
        for (int k = 0; k < 3; ++k) {
            const int corner = mesh.triangles[t][k];
            if (corner < mesh.faceStart[face] || corner >= mesh.faceStart[face + 1])
                return "a triangle's corner is not in its face";
            if (corner == mesh.triangles[t][(k + 1) % 3])
                return "a triangle has a corner twice";
        }
        if (!std::isfinite(mesh.triangleArea[t]) || mesh.triangleArea[t] < 0)
            return "a triangle's area is not a number";
        area += mesh.triangleArea[t];
    }
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (const int t : mesh.trianglesOf(f)) {
            if (!inRange(t, mesh.triangleCount()) || mesh.triangleFace[t] != f)
                return "the triangles of a face do not follow each other";
        }
    }
    if (!(std::abs(area - mesh.area) <= 1e-9 * area))
        return "the area is not the sum of the triangles' areas";
    return {};
}

std::string checkPair(const MeshData &mesh, const EdgePair &pair)
{
    for (int which = 0; which < 2; ++which) {
        if (!inRange(pair.triangle[which], mesh.triangleCount()))
            return "an edge pair's triangle is out of range";
        for (int end = 0; end < 2; ++end) {
            if (pair.corner[end][which] < 0 || pair.corner[end][which] / 3 != pair.triangle[which])
                return "an edge pair's corner is not in its triangle";
        }
        if (pair.corner[0][which] == pair.corner[1][which])
            return "an edge pair has one corner at both ends";
    }
    if (pair.triangle[0] >= pair.triangle[1])
        return "an edge pair's triangles are not in order";
    const auto step = [&](int which) { return (pair.corner[1][which] - pair.corner[0][which] + 3) % 3; };
    if (step(0) != 1 || step(1) != 2)
        return "an edge pair's sides do not run against each other";
    for (const auto &corner : pair.corner) {
        if (mesh.vertexOfSoup(corner[0]) != mesh.vertexOfSoup(corner[1]))
            return "a corner pair joins two different vertices";
    }
    const int face = mesh.triangleFace[pair.triangle[0]];
    const int otherFace = mesh.triangleFace[pair.triangle[1]];
    if (mesh.faceObject[face] != mesh.faceObject[otherFace])
        return "an edge pair joins two objects";
    if (pair.diagonal != (face == otherFace))
        return "an edge pair is not marked as what it is, a diagonal or none";
    const double length = (mesh.cornerPosition(mesh.cornerOfSoup(pair.corner[0][0])) -
                           mesh.cornerPosition(mesh.cornerOfSoup(pair.corner[1][0])))
                              .norm();
    if (!(std::abs(length - pair.length) <= 1e-9 * length))
        return "an edge pair's length is wrong";
    return {};
}

std::string checkSides(const MeshData &mesh)
{
    // How often the side that starts at this soup corner is in a pair or on the boundary.
    std::vector<int> uses(mesh.soupCornerCount(), 0);
    const EdgePair *last = nullptr;
    for (const EdgePair &pair : mesh.edgePairs) {
        if (std::string problem = checkPair(mesh, pair); !problem.empty())
            return problem;
        if (last && last->corner[0][0] > pair.corner[0][0])
            return "the edge pairs are not in order";
        last = &pair;
        for (int which = 0; which < 2; ++which)
            ++uses[3 * pair.triangle[which] + pair.side(which)];
    }
    for (const BoundarySide &side : mesh.boundarySides) {
        if (!inRange(side.triangle, mesh.triangleCount()) || !inRange(side.side, 3))
            return "a boundary side is out of range";
        ++uses[3 * side.triangle + side.side];
    }
    if (std::any_of(uses.begin(), uses.end(), [](int n) { return n != 1; }))
        return "a triangle side is not in exactly one edge pair or boundary side";
    return {};
}

std::string checkComponents(const MeshData &mesh)
{
    UnionFind sets(mesh.triangleCount());
    for (const EdgePair &pair : mesh.edgePairs)
        sets.unite(pair.triangle[0], pair.triangle[1]);
    if (std::pair(mesh.component, mesh.componentCount) != sets.labels())
        return "the components are not those of the edge pairs";
    return {};
}

} // namespace

std::string MeshData::validate() const
{
    for (const auto check : {checkSizes, checkWelding, checkTriangles, checkSides, checkComponents}) {
        if (std::string problem = check(*this); !problem.empty())
            return problem;
    }
    return {};
}

} // namespace autocuts
