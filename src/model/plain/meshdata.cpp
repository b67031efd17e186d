#include "model/plain/meshdata.h"

#include "model/plain/polygon.h"
#include "model/plain/spatialorder.h"
#include "model/plain/unionfind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <compare>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <tuple>
#include <unordered_map>

namespace autocuts {

namespace {

//! A side of a triangle that is also a side of its polygon.
struct Side
{
    int object, low, high; //!< welded vertices, low < high
    int triangle, side;
    bool forward; //!< runs from low to high

    bool sameEdge(const Side &o) const { return object == o.object && low == o.low && high == o.high; }
};

//! Soup corners are numbered by int, and a polygon with n corners has 3 (n - 2) soup corners: less than three
//! times as many.
constexpr std::size_t maxCorners = std::numeric_limits<int>::max() / 3;

void checkInput(const MeshData &mesh)
{
    if (!mesh.positions.allFinite())
        throw std::invalid_argument("a position is not finite");
    // Areas are products of two lengths. This bound keeps them and their sums finite.
    if (mesh.positions.size() > 0 && mesh.positions.cwiseAbs().maxCoeff() > 1e150)
        throw std::invalid_argument("a position is larger than 1e150");
    if (mesh.cornerVertex.size() > maxCorners)
        throw std::invalid_argument("too many face corners");
    if (mesh.faceObject.size() + 1 != mesh.faceStart.size() || mesh.faceStart.front() != 0 ||
        mesh.faceStart.back() != mesh.cornerCount())
        throw std::invalid_argument("face arrays do not fit together");
    for (int f = 0; f < mesh.faceCount(); ++f) {
        if (mesh.faceStart[f + 1] > mesh.cornerCount())
            throw std::invalid_argument("face arrays do not fit together");
        if (mesh.faceStart[f + 1] < mesh.faceStart[f] + 3)
            throw std::invalid_argument("a face has fewer than three corners");
    }
    for (int v : mesh.cornerVertex) {
        if (v < 0 || v >= mesh.vertexCount())
            throw std::invalid_argument("a vertex index is out of range");
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
        // Adding zero turns -0 into +0, so that both give the same vertex.
        const std::array<double, 3> p{mesh.positions(v, 0) + 0.0, mesh.positions(v, 1) + 0.0,
                                      mesh.positions(v, 2) + 0.0};
        mesh.vertexWeld[v] = first.try_emplace(p, v).first->second;
    }
}

//! The length of a vector, also where its square would overflow or underflow a double.
double safeNorm(const Vec3 &v)
{
    const double norm = v.norm();
    return norm > 1e-140 && norm < 1e140 ? norm : v.stableNorm();
}

void measureTriangles(MeshData &mesh)
{
    const int count = mesh.triangleCount();
    mesh.triangleArea.resize(count);
    mesh.triangleDegenerate.resize(count);
    for (int t = 0; t < count; ++t) {
        const Vec3 a = mesh.cornerPosition(mesh.triangles[t][0]);
        const Vec3 b = mesh.cornerPosition(mesh.triangles[t][1]);
        const Vec3 c = mesh.cornerPosition(mesh.triangles[t][2]);
        mesh.triangleArea[t] = 0.5 * safeNorm((b - a).cross(c - a));
        const double longest =
            std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
        mesh.triangleDegenerate[t] = !(mesh.triangleArea[t] > 1e-10 * longest);
        mesh.report.degenerateTriangles += mesh.triangleDegenerate[t];
        mesh.area += mesh.triangleArea[t];
    }
}

std::vector<int> orderOfFaces(const MeshData &mesh)
{
    if (mesh.faceCount() >= spatiallyNumberedFaces) {
        PositionMatrix first(mesh.faceCount(), 3);
        for (int f = 0; f < mesh.faceCount(); ++f)
            first.row(f) = mesh.cornerPosition(mesh.faceStart[f]);
        return spatialOrder(first);
    }
    std::vector<int> order(mesh.faceCount());
    std::iota(order.begin(), order.end(), 0);
    return order;
}

void triangulate(MeshData &mesh)
{
    mesh.faceTriangle.resize(mesh.faceCount());
    mesh.triangles.reserve(mesh.cornerCount() - 2 * mesh.faceCount());
    mesh.triangleFace.reserve(mesh.triangles.capacity());
    std::vector<Vec3> points;
    for (const int f : orderOfFaces(mesh)) {
        mesh.faceTriangle[f] = mesh.triangleCount();
        const int start = mesh.faceStart[f];
        const int n = mesh.faceStart[f + 1] - start;
        if (n == 3) {
            mesh.triangles.push_back({start, start + 1, start + 2});
            mesh.triangleFace.push_back(f);
            continue;
        }
        points.clear();
        for (int i = 0; i < n; ++i)
            points.push_back(mesh.cornerPosition(start + i));
        const int apex = fanApex(points);
        ++mesh.report.polygons;
        mesh.report.concavePolygons += apex != 0;
        for (const auto &t : triangulatePolygon(points, apex)) {
            mesh.triangles.push_back({start + t[0], start + t[1], start + t[2]});
            mesh.triangleFace.push_back(f);
        }
    }
}

//! The edge pair of side k0 of triangle t0 and side k1 of triangle t1. \pre t0 < t1
EdgePair makePair(const MeshData &mesh, int t0, int k0, int t1, int k1)
{
    EdgePair pair;
    pair.triangle = {t0, t1};
    pair.corner[0] = {3 * t0 + k0, 3 * t1 + (k1 + 1) % 3};
    pair.corner[1] = {3 * t0 + (k0 + 1) % 3, 3 * t1 + k1};
    pair.length =
        (mesh.cornerPosition(mesh.triangles[t0][k0]) - mesh.cornerPosition(mesh.triangles[t0][(k0 + 1) % 3]))
            .norm();
    // A polygon may also meet itself along two of its own sides, at a bridge to a hole.
    pair.diagonal = mesh.triangleFace[t0] == mesh.triangleFace[t1];
    return pair;
}

//! A side of a triangle inside a polygon, given by the corners at its ends.
struct DiagonalSide
{
    int low, high, triangle, side;
};

//! Pairs the two sides along every diagonal of one polygon.
void pairDiagonals(MeshData &mesh, std::vector<DiagonalSide> &sides)
{
    std::sort(sides.begin(), sides.end(), [](const DiagonalSide &a, const DiagonalSide &b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        const DiagonalSide &a = sides[i];
        const DiagonalSide &b = sides[i + 1];
        mesh.edgePairs.push_back(makePair(mesh, a.triangle, a.side, b.triangle, b.side));
    }
    sides.clear();
}

//! A polygon in which a vertex may come back. Successive corners at one vertex are one turn.
class TurningPolygon
{
public:
    TurningPolygon(const MeshData &mesh, int face)
        : mMesh(mesh), mFace(face), mStart(mesh.faceStart[face]), mCorners(mesh.faceStart[face + 1] - mStart)
    {
        for (int i = 0; i < mCorners; ++i) {
            if (mVertex.empty() || vertexAt(i) != mVertex.back())
                mVertex.push_back(vertexAt(i));
            mTurn.push_back(static_cast<int>(mVertex.size()) - 1);
        }
        while (mVertex.size() > 1 && mVertex.back() == mVertex.front()) {
            std::replace(mTurn.begin(), mTurn.end(), static_cast<int>(mVertex.size()) - 1, 0);
            mVertex.pop_back();
        }
        for (const int v : mVertex)
            ++mUses[v];
    }

    bool comesBack() const { return mUses.size() < mVertex.size(); }
    //! True when the polygon comes back to the vertex of this corner.
    bool comesBackTo(int i) const { return mUses.at(vertexAt(i)) > 1; }

    //! True when the polygon can be laid flat with those of its sides stitched that lie on each other: a disk
    //! with holes, such as a polygon with a bridge to its hole.
    bool canBeLaidFlat() const
    {
        for (const int t : mMesh.trianglesOf(mFace)) {
            for (int k = 0; k < 3; ++k) {
                const int a = mTurn[mMesh.triangles[t][k] - mStart];
                const int b = mTurn[mMesh.triangles[t][(k + 1) % 3] - mStart];
                if (a != b && mVertex[a] == mVertex[b])
                    return false;
            }
        }
        const int sides = static_cast<int>(mVertex.size());
        const auto next = [sides](int i) { return (i + 1) % sides; };
        std::map<std::pair<int, int>, int> waiting; // sides without a partner, by their vertices
        std::vector<bool> open(sides, true);
        UnionFind turns(sides); // stitched to each other
        int stitched = 0;
        for (int i = 0; i < sides; ++i) {
            const auto partner = waiting.find({mVertex[next(i)], mVertex[i]});
            if (partner == waiting.end()) {
                waiting.insert_or_assign({mVertex[i], mVertex[next(i)]}, i);
                continue;
            }
            const int j = partner->second;
            waiting.erase(partner);
            open[i] = open[j] = false;
            turns.unite(i, next(j));
            turns.unite(next(i), j);
            ++stitched;
        }
        const auto [point, points] = turns.labels();
        std::vector<int> openSides(points, 0);
        UnionFind loops(points);
        for (int i = 0; i < sides; ++i) {
            if (open[i]) {
                loops.unite(point[i], point[next(i)]);
                ++openSides[point[i]];
            }
        }
        // On such a disk every point is on one boundary loop.
        if (std::any_of(openSides.begin(), openSides.end(), [](int count) { return count != 1; }))
            return false;
        const int euler = points - (sides - stitched) + 1;
        return euler + loops.labels().second == 2;
    }

private:
    int vertexAt(int i) const { return mMesh.vertexWeld[mMesh.cornerVertex[mStart + i]]; }

    const MeshData &mMesh;
    int mFace, mStart, mCorners;
    std::vector<int> mVertex; //!< per turn
    std::vector<int> mTurn;   //!< per corner
    std::map<int, int> mUses; //!< number of turns at each vertex
};

bool repeatsVertices(const MeshData &mesh, int face, std::vector<int> &vertices)
{
    vertices.clear();
    for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c)
        vertices.push_back(mesh.vertexWeld[mesh.cornerVertex[c]]);
    std::sort(vertices.begin(), vertices.end());
    return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

//! Per corner: true when the side that starts there stays open because its polygon meets itself. Empty when
//! there is no such polygon. Their faces go into the report.
std::vector<bool> findSelfContacts(MeshData &mesh)
{
    std::vector<bool> contacts;
    std::vector<int> vertices;
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int start = mesh.faceStart[f], n = mesh.faceStart[f + 1] - start;
        if (n == 3 || !repeatsVertices(mesh, f, vertices))
            continue;
        const TurningPolygon polygon(mesh, f);
        if (!polygon.comesBack() || polygon.canBeLaidFlat())
            continue;
        mesh.report.selfContactFaces.push_back(f);
        contacts.resize(mesh.cornerCount(), false);
        for (int i = 0; i < n; ++i)
            contacts[start + i] = polygon.comesBackTo(i) || polygon.comesBackTo((i + 1) % n);
    }
    return contacts;
}

//! Returns the sides along polygon edges. Sides along diagonals are paired here and not returned.
std::vector<Side> collectSides(MeshData &mesh)
{
    const std::vector<bool> contacts = findSelfContacts(mesh);
    std::vector<Side> sides;
    sides.reserve(mesh.cornerCount());
    std::vector<DiagonalSide> diagonals;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const int face = mesh.triangleFace[t];
        const int start = mesh.faceStart[face];
        const int n = mesh.faceStart[face + 1] - start;
        for (int k = 0; k < 3; ++k) {
            const int c = mesh.triangles[t][k];
            const int d = mesh.triangles[t][(k + 1) % 3];
            if ((c - start + 1) % n != d - start) {
                diagonals.push_back({std::min(c, d), std::max(c, d), t, k});
                continue;
            }
            const int a = mesh.vertexWeld[mesh.cornerVertex[c]];
            const int b = mesh.vertexWeld[mesh.cornerVertex[d]];
            const bool contact = !contacts.empty() && contacts[c];
            if (a == b || contact) {
                mesh.boundarySides.push_back({t, k, contact ? OpenSide::SelfContact : OpenSide::Boundary});
                continue;
            }
            sides.push_back({mesh.faceObject[face], std::min(a, b), std::max(a, b), t, k, a < b});
        }
        if (t + 1 == mesh.triangleCount() || mesh.triangleFace[t + 1] != face)
            pairDiagonals(mesh, diagonals);
    }
    return sides;
}

//! Two sides of one 3D edge that could become an edge pair.
struct Candidate
{
    double smoothness;
    const Side *forward, *backward;
};

//! Returns all pairs of sides that run in opposite directions, the smoothest continuation first (largest dot
//! product of the normals).
std::vector<Candidate> findCandidates(const MeshData &mesh, const std::vector<Vec3> &normals,
                                      const Side *first, const Side *last)
{
    std::vector<const Side *> forward, backward;
    for (const Side *s = first; s != last; ++s)
        (s->forward ? forward : backward).push_back(s);
    // On an edge with hundreds of faces no choice of partners is meaningful, and storing all candidates could
    // exhaust the memory. The limit was chosen by hand: an edge reaches it with 256 sides in each direction.
    const bool crowded = forward.size() * backward.size() > 65536;
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < forward.size(); ++i) {
        const std::size_t end = crowded ? std::min(i + 1, backward.size()) : backward.size();
        for (std::size_t j = crowded ? i : 0; j < end; ++j) {
            const int a = forward[i]->triangle;
            const int b = backward[j]->triangle;
            if (a == b)
                continue;
            // A triangle without area has no normal: it only connects its neighbours, so its pairs are made
            // first.
            const bool bridge = mesh.triangleDegenerate[a] || mesh.triangleDegenerate[b];
            candidates.push_back({bridge ? 2.0 : normals[a].dot(normals[b]), forward[i], backward[j]});
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate &a, const Candidate &b) { return a.smoothness > b.smoothness; });
    return candidates;
}

//! Pairs the sides of one 3D edge that run in opposite directions, the smoothest continuation first.
void pairEdge(MeshData &mesh, const std::vector<Vec3> &normals, const Side *first, const Side *last)
{
    const auto count = last - first;
    std::vector<bool> used(count, false);
    for (const Candidate &c : findCandidates(mesh, normals, first, last)) {
        if (used[c.forward - first] || used[c.backward - first])
            continue;
        used[c.forward - first] = used[c.backward - first] = true;
        const bool inOrder = c.forward->triangle < c.backward->triangle;
        const Side *a = inOrder ? c.forward : c.backward;
        const Side *b = inOrder ? c.backward : c.forward;
        mesh.edgePairs.push_back(makePair(mesh, a->triangle, a->side, b->triangle, b->side));
    }
    // Two sides of one triangle cannot form a pair, but their winding is not wrong.
    const bool windingDisagrees = count == 2 && first[0].forward == first[1].forward;
    const OpenSide reason = count > 2          ? OpenSide::NonManifold
                            : windingDisagrees ? OpenSide::Winding
                                               : OpenSide::Boundary;
    for (const Side *s = first; s != last; ++s) {
        if (!used[s - first])
            mesh.boundarySides.push_back({s->triangle, s->side, reason});
    }
    mesh.report.boundaryEdges += count <= 2 && !used[0] && reason == OpenSide::Boundary;
    mesh.report.nonManifoldEdges += count > 2;
    mesh.report.windingEdges += windingDisagrees;
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
        return std::tie(a.object, a.low, a.high, a.triangle, a.side) <
               std::tie(b.object, b.low, b.high, b.triangle, b.side);
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

//! Counts faces that have the same object and the same welded vertices as an earlier face, in any order.
int countDuplicateFaces(const MeshData &mesh)
{
    std::vector<int> vertices(mesh.cornerCount());
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (int c = mesh.faceStart[f]; c < mesh.faceStart[f + 1]; ++c)
            vertices[c] = mesh.vertexWeld[mesh.cornerVertex[c]];
        std::sort(vertices.begin() + mesh.faceStart[f], vertices.begin() + mesh.faceStart[f + 1]);
    }
    const auto compare = [&](int f, int g) {
        if (mesh.faceObject[f] != mesh.faceObject[g])
            return mesh.faceObject[f] <=> mesh.faceObject[g];
        const auto begin = vertices.begin();
        return std::lexicographical_compare_three_way(
            begin + mesh.faceStart[f], begin + mesh.faceStart[f + 1], begin + mesh.faceStart[g],
            begin + mesh.faceStart[g + 1]);
    };
    std::vector<int> order(mesh.faceCount());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int f, int g) { return compare(f, g) < 0; });
    int duplicates = 0;
    for (std::size_t i = 1; i < order.size(); ++i)
        duplicates += compare(order[i - 1], order[i]) == 0;
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
    measureTriangles(*mesh);
    pairSides(*mesh);
    findComponents(*mesh);
    fillReport(*mesh);
    return mesh;
}

bool samePolygons(const MeshData &a, const MeshData &b)
{
    // Everything else, but the texel weights, is derived from these.
    return &a == &b || (a.positions.rows() == b.positions.rows() && a.faceStart == b.faceStart &&
                        a.cornerVertex == b.cornerVertex && a.faceObject == b.faceObject &&
                        (a.positions.size() == 0 || std::memcmp(a.positions.data(), b.positions.data(),
                                                                a.positions.size() * sizeof(double)) == 0));
}

} // namespace autocuts
