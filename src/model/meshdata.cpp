#include "model/meshdata.h"

#include "model/polygon.h"
#include "model/unionfind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <stdexcept>
#include <unordered_map>

namespace autocuts {

namespace {

//! One side of a triangle that is also a side of its polygon.
struct Side
{
    int object, low, high;    //!< welded vertices, low < high
    int triangle, side;
    bool forward;             //!< runs from low to high

    bool sameEdge(const Side &o) const { return object == o.object && low == o.low && high == o.high; }
};

void checkInput(const MeshData &mesh)
{
    if (!mesh.positions.allFinite())
        throw std::invalid_argument("MeshData::build: a position is not finite");
    if (mesh.faceObject.size() + 1 != mesh.faceStart.size() || mesh.faceStart.front() != 0
        || mesh.faceStart.back() != mesh.cornerCount())
        throw std::invalid_argument("MeshData::build: face arrays do not fit together");
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (mesh.faceStart[f + 1] - mesh.faceStart[f] < 3)
            throw std::invalid_argument("MeshData::build: a face has fewer than three corners");
    }
    for (int v : mesh.cornerVertex) {
        if (v < 0 || v >= mesh.vertexCount())
            throw std::invalid_argument("MeshData::build: a vertex index is out of range");
    }
}

struct PositionHash
{
    std::size_t operator()(const std::array<double, 3> &p) const
    {
        std::uint64_t h = 0;
        for (double d : p) {
            std::uint64_t bits;
            std::memcpy(&bits, &d, sizeof bits);
            h = (h ^ bits) * 0x9E3779B97F4A7C15ull;
            h ^= h >> 32;
        }
        return h;
    }
};

void weld(MeshData &mesh)
{
    std::unordered_map<std::array<double, 3>, int, PositionHash> first;
    first.reserve(mesh.vertexCount() * 2);
    mesh.vertexWeld.resize(mesh.vertexCount());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        // Adding zero turns -0 into +0.
        const std::array<double, 3> p{mesh.positions(v, 0) + 0.0, mesh.positions(v, 1) + 0.0,
                                      mesh.positions(v, 2) + 0.0};
        mesh.vertexWeld[v] = first.try_emplace(p, v).first->second;
    }
}

//! Splits the polygons and pairs the sides along the diagonals.
void triangulate(MeshData &mesh)
{
    std::vector<Vec3> points;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int start = mesh.faceStart[f];
        const int n = mesh.faceStart[f + 1] - start;
        points.clear();
        for (int i = 0; i < n; ++i)
            points.push_back(mesh.cornerPosition(start + i));
        if (n > 3) {
            ++mesh.report.polygons;
            if (fanApex(points) != 0)
                ++mesh.report.concavePolygons;
        }
        for (const auto &t : triangulatePolygon(points)) {
            mesh.triangles.push_back({start + t[0], start + t[1], start + t[2]});
            mesh.triangleFace.push_back(f);
        }
    }
    const int count = mesh.triangleCount();
    mesh.triangleArea.resize(count);
    mesh.triangleDegenerate.resize(count);
    for (int t = 0; t < count; ++t) {
        const Vec3 a = mesh.cornerPosition(mesh.triangles[t][0]);
        const Vec3 b = mesh.cornerPosition(mesh.triangles[t][1]);
        const Vec3 c = mesh.cornerPosition(mesh.triangles[t][2]);
        mesh.triangleArea[t] = 0.5 * (b - a).cross(c - a).norm();
        const double longest =
            std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
        mesh.triangleDegenerate[t] = !(mesh.triangleArea[t] > 1e-10 * longest);
        mesh.report.degenerateTriangles += mesh.triangleDegenerate[t];
        mesh.area += mesh.triangleArea[t];
    }
}

EdgePair makePair(const MeshData &mesh, int t0, int k0, int t1, int k1, bool diagonal)
{
    EdgePair pair;
    pair.triangle = {t0, t1};
    pair.corner[0] = {3 * t0 + k0, 3 * t1 + (k1 + 1) % 3};
    pair.corner[1] = {3 * t0 + (k0 + 1) % 3, 3 * t1 + k1};
    pair.length = (mesh.cornerPosition(mesh.triangles[t0][k0])
                   - mesh.cornerPosition(mesh.triangles[t0][(k0 + 1) % 3])).norm();
    pair.diagonal = diagonal;
    return pair;
}

//! Sides along polygon edges; the sides along diagonals are paired at once.
std::vector<Side> collectSides(MeshData &mesh)
{
    std::vector<Side> sides;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        const int start = mesh.faceStart[face];
        const int n = mesh.faceStart[face + 1] - start;
        for (int k = 0; k < 3; ++k) {
            const int c = mesh.triangles[t][k];
            const int d = mesh.triangles[t][(k + 1) % 3];
            if ((c - start + 1) % n != d - start) {
                for (int other = t + 1; other < mesh.triangleCount() && mesh.triangleFace[other] == face;
                     ++other) {
                    for (int j = 0; j < 3; ++j) {
                        if (mesh.triangles[other][j] == d && mesh.triangles[other][(j + 1) % 3] == c)
                            mesh.edgePairs.push_back(makePair(mesh, t, k, other, j, true));
                    }
                }
                continue;
            }
            const int a = mesh.vertexWeld[mesh.cornerVertex[c]];
            const int b = mesh.vertexWeld[mesh.cornerVertex[d]];
            if (a == b) {
                mesh.boundarySides.push_back({t, k, OpenSide::Boundary});
                continue;
            }
            sides.push_back({mesh.faceObject[face], std::min(a, b), std::max(a, b), t, k, a < b});
        }
    }
    return sides;
}

//! Pairs the sides of one 3D edge: opposite directions only, smoothest continuation first.
void pairEdge(MeshData &mesh, const std::vector<Vec3> &normals, const Side *first, const Side *last)
{
    struct Candidate
    {
        double smoothness;
        const Side *forward, *backward;
    };
    std::vector<Candidate> candidates;
    for (const Side *a = first; a != last; ++a) {
        for (const Side *b = first; b != last; ++b) {
            if (!a->forward || b->forward || a->triangle == b->triangle)
                continue;
            // A triangle without area takes any neighbour gladly: it is only a bridge.
            const bool bridge = mesh.triangleDegenerate[a->triangle] || mesh.triangleDegenerate[b->triangle];
            candidates.push_back(
                {bridge ? 2.0 : normals[a->triangle].dot(normals[b->triangle]), a, b});
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate &a, const Candidate &b) { return a.smoothness > b.smoothness; });
    std::vector<bool> used(last - first, false);
    for (const Candidate &c : candidates) {
        if (used[c.forward - first] || used[c.backward - first])
            continue;
        used[c.forward - first] = used[c.backward - first] = true;
        const bool inOrder = c.forward->triangle < c.backward->triangle;
        const Side *a = inOrder ? c.forward : c.backward;
        const Side *b = inOrder ? c.backward : c.forward;
        mesh.edgePairs.push_back(makePair(mesh, a->triangle, a->side, b->triangle, b->side, false));
    }
    const auto sideCount = last - first;
    for (const Side *s = first; s != last; ++s) {
        if (used[s - first])
            continue;
        const OpenSide reason = sideCount == 1   ? OpenSide::Boundary
                                : sideCount == 2 ? OpenSide::Winding
                                                 : OpenSide::NonManifold;
        mesh.boundarySides.push_back({s->triangle, s->side, reason});
    }
    mesh.report.boundaryEdges += sideCount == 1;
    mesh.report.nonManifoldEdges += sideCount > 2;
    mesh.report.windingEdges += sideCount == 2 && !used[0];
}

void pairSides(MeshData &mesh)
{
    std::vector<Vec3> normals(mesh.triangleCount());
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Vec3 a = mesh.cornerPosition(mesh.triangles[t][0]);
        normals[t] = (mesh.cornerPosition(mesh.triangles[t][1]) - a)
                         .cross(mesh.cornerPosition(mesh.triangles[t][2]) - a)
                         .stableNormalized();
    }
    std::vector<Side> sides = collectSides(mesh);
    std::sort(sides.begin(), sides.end(), [](const Side &a, const Side &b) {
        return std::tie(a.object, a.low, a.high, a.triangle, a.side)
               < std::tie(b.object, b.low, b.high, b.triangle, b.side);
    });
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t j = i;
        while (j < sides.size() && sides[j].sameEdge(sides[i]))
            ++j;
        pairEdge(mesh, normals, sides.data() + i, sides.data() + j);
        i = j;
    }
    std::sort(mesh.edgePairs.begin(), mesh.edgePairs.end(), [](const EdgePair &a, const EdgePair &b) {
        return a.corner[0][0] != b.corner[0][0] ? a.corner[0][0] < b.corner[0][0]
                                                : a.corner[0][1] < b.corner[0][1];
    });
    std::sort(mesh.boundarySides.begin(), mesh.boundarySides.end(),
              [](const BoundarySide &a, const BoundarySide &b) {
                  return std::tie(a.triangle, a.side) < std::tie(b.triangle, b.side);
              });
}

void findComponents(MeshData &mesh)
{
    UnionFind sets(mesh.triangleCount());
    for (const EdgePair &pair : mesh.edgePairs)
        sets.unite(pair.triangle[0], pair.triangle[1]);
    std::tie(mesh.component, mesh.componentCount) = sets.labels();
}

int countDuplicateFaces(const MeshData &mesh)
{
    std::set<std::vector<int>> seen;
    int duplicates = 0;
    std::vector<int> key;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        key.assign(1, mesh.faceObject[f]);
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            key.push_back(mesh.vertexWeld[mesh.cornerVertex[c]]);
        std::sort(key.begin() + 1, key.end());
        duplicates += !seen.insert(key).second;
    }
    return duplicates;
}

void fillReport(MeshData &mesh)
{
    MeshReport &report = mesh.report;
    report.vertices = mesh.vertexCount();
    report.faces = mesh.faceCount();
    std::vector<bool> usedVertex(mesh.vertexCount(), false);
    for (int v : mesh.cornerVertex)
        usedVertex[v] = true;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        report.weldedVertices += mesh.vertexWeld[v] != v;
        report.isolatedVertices += !usedVertex[v];
    }
    const std::set<int> objects(mesh.faceObject.begin(), mesh.faceObject.end());
    report.objects = static_cast<int>(objects.size());
    report.components = mesh.componentCount;
    report.duplicateFaces = countDuplicateFaces(mesh);
    report.area = mesh.area;
    if (mesh.vertexCount() > 0) {
        const Vec3 low = mesh.positions.colwise().minCoeff();
        const Vec3 high = mesh.positions.colwise().maxCoeff();
        report.boxDiagonal = (high - low).norm();
        report.distanceFromOrigin = (0.5 * (low + high)).norm();
    }
}

} // namespace

std::shared_ptr<const MeshData> MeshData::build(PositionMatrix positions, std::vector<int> faceStart,
                                                std::vector<int> cornerVertex, std::vector<int> faceObject)
{
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = std::move(positions);
    mesh->faceStart = std::move(faceStart);
    mesh->cornerVertex = std::move(cornerVertex);
    mesh->faceObject = std::move(faceObject);
    checkInput(*mesh);
    weld(*mesh);
    triangulate(*mesh);
    pairSides(*mesh);
    findComponents(*mesh);
    fillReport(*mesh);
    return mesh;
}

std::string MeshData::validate() const
{
    if (static_cast<int>(vertexWeld.size()) != vertexCount())
        return "vertexWeld has the wrong size";
    if (triangleCount() != cornerCount() - 2 * faceCount())
        return "the number of triangles does not fit the polygons";
    std::vector<int> uses(soupCornerCount(), 0);    // of the side that starts at this soup corner
    for (const EdgePair &pair : edgePairs) {
        if (pair.triangle[0] >= pair.triangle[1])
            return "an edge pair's triangles are not in order";
        for (int end = 0; end < 2; ++end) {
            for (int which = 0; which < 2; ++which) {
                if (pair.corner[end][which] / 3 != pair.triangle[which])
                    return "an edge pair's corner is not in its triangle";
            }
            if (vertexOfSoup(pair.corner[end][0]) != vertexOfSoup(pair.corner[end][1]))
                return "a corner pair joins two different vertices";
        }
        for (int which = 0; which < 2; ++which) {
            const int face = triangleFace[pair.triangle[which]];
            if (faceObject[face] != faceObject[triangleFace[pair.triangle[0]]])
                return "an edge pair joins two objects";
            ++uses[3 * pair.triangle[which] + pair.side(which)];
        }
        if (pair.diagonal != (triangleFace[pair.triangle[0]] == triangleFace[pair.triangle[1]]))
            return "a diagonal joins two faces, or an edge pair joins a face to itself";
        if (component[pair.triangle[0]] != component[pair.triangle[1]])
            return "an edge pair joins two components";
    }
    for (const BoundarySide &side : boundarySides)
        ++uses[3 * side.triangle + side.side];
    if (std::any_of(uses.begin(), uses.end(), [](int n) { return n != 1; }))
        return "a triangle side is not in exactly one edge pair or boundary side";
    return {};
}

} // namespace autocuts
