#include "model/plain/tangents.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace autocuts {

namespace {

using Triple = std::array<int, 3>;

//! Larger UVs count as missing: products of two of them must be finite in single precision.
constexpr double maxUv = 1e15;

struct MikkTriangle
{
    Triple corner;                 //!< polygon corners
    Triple slot;                   //!< where its tangents go
    Triple vertex{};               //!< corners that are the same have the same number
    Triple neighbour{-1, -1, -1};  //!< the triangle across the side from corner k to the next
    Triple group{-1, -1, -1};      //!< of the corners that share a tangent
    int quadHalf = 0;              //!< 1 or 2 for the two halves of a quad
    float uvArea = 0;              //!< twice the signed area in the map
    Vec3 direction = Vec3::Zero(); //!< unit, of growing u
    bool collapsed = false;        //!< two of its positions are the same
    bool undefined = false;        //!< has no tangent of its own and takes that of any group
    bool preserving = false;       //!< the map is not mirrored
};

//! Corners around a vertex that share a tangent.
struct Group
{
    int vertex;
    bool preserving;
    Vec3 sum = Vec3::Zero();
};

//! Makes the tangents step by step; one object per call of mikkTangents().
class TangentMaker
{
public:
    TangentMaker(const MeshData &mesh, const UvMatrix &uv, const std::vector<Eigen::Vector3f> &normals)
        : mMesh(mesh), mNormals(normals), mUv(mesh.cornerCount()), mSlotStart(mesh.faceCount() + 1, 0)
    {
        readUvs(uv);
        cutPolygons();
        weldCorners();
        for (MikkTriangle &triangle : mTriangles)
            measure(triangle);
        alignQuads();
        findNeighbours();
        for (std::size_t t = 0; t < mTriangles.size(); ++t)
            growGroups(static_cast<int>(t));
        sumUp();
        mendCollapsed();
    }

    std::vector<Tangent> result() const;

private:
    void readUvs(const UvMatrix &uv);
    void cutPolygons();
    void addTriangle(int face, const Triple &local, int quadHalf);
    bool cutsFromFirst(int start) const;
    void weldCorners();
    void measure(MikkTriangle &triangle) const;
    void alignQuads();
    void findNeighbours();
    void growGroups(int triangle);
    void spread(int triangle, int group);
    Vec3 weighted(const MikkTriangle &triangle, int k) const;
    void sumUp();
    void mendCollapsed();
    void mendHalfCollapsedQuad(const MikkTriangle &good, const MikkTriangle &collapsed);
    int welded(int corner) const { return mMesh.vertexWeld[mMesh.cornerVertex[corner]]; }

    const MeshData &mMesh;
    const std::vector<Eigen::Vector3f> &mNormals;
    std::vector<Eigen::Vector2f> mUv; //!< per corner
    std::vector<int> mSlotStart; //!< per face: a slot per corner, or three per triangle of larger polygons
    std::vector<MikkTriangle> mTriangles;
    std::vector<int> mVertex; //!< per corner
    std::vector<Group> mGroups;
    std::vector<int> mOpen;         //!< triangles that a group still has to reach
    std::vector<Tangent> mTangents; //!< per slot
};

void TangentMaker::readUvs(const UvMatrix &uv)
{
    for (int f = 0; f < mMesh.faceCount(); ++f) {
        const int start = mMesh.faceStart[f], count = mMesh.faceStart[f + 1] - start;
        const auto rows = uv.middleRows(start, count);
        const bool complete = rows.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() < maxUv;
        for (int i = 0; i < count; ++i)
            mUv[start + i] = complete ? Eigen::Vector2f(rows.row(i).cast<float>()) : Eigen::Vector2f(0, 0);
    }
}

//! True when a quad is cut between its first and third corner: along the shorter diagonal in the map, or on
//! the model where both are equal.
bool TangentMaker::cutsFromFirst(int start) const
{
    const float first = (mUv[start + 2] - mUv[start]).squaredNorm();
    const float second = (mUv[start + 3] - mUv[start + 1]).squaredNorm();
    if (first != second)
        return first < second;
    return (mMesh.cornerPosition(start + 2) - mMesh.cornerPosition(start)).stableNorm() <=
           (mMesh.cornerPosition(start + 3) - mMesh.cornerPosition(start + 1)).stableNorm();
}

//! \param local corners, counted from the first one of the face
void TangentMaker::addTriangle(int face, const Triple &local, int quadHalf)
{
    MikkTriangle triangle;
    for (int k = 0; k < 3; ++k) {
        triangle.corner[k] = mMesh.faceStart[face] + local[k];
        triangle.slot[k] = mSlotStart[face] + local[k];
    }
    triangle.quadHalf = quadHalf;
    mTriangles.push_back(triangle);
}

void TangentMaker::cutPolygons()
{
    mTriangles.reserve(mMesh.triangleCount());
    for (int f = 0; f < mMesh.faceCount(); ++f) {
        const int start = mMesh.faceStart[f], count = mMesh.faceStart[f + 1] - start;
        mSlotStart[f + 1] = mSlotStart[f] + (count <= 4 ? count : 3 * (count - 2));
        if (count == 3) {
            addTriangle(f, {0, 1, 2}, 0);
        } else if (count == 4) {
            const bool first = cutsFromFirst(start);
            addTriangle(f, first ? Triple{0, 1, 2} : Triple{0, 1, 3}, 1);
            addTriangle(f, first ? Triple{0, 2, 3} : Triple{1, 2, 3}, 2);
        } else {
            int slot = mSlotStart[f];
            for (const int t : mMesh.trianglesOf(f)) {
                addTriangle(f, {0, 0, 0}, 0);
                mTriangles.back().corner = mMesh.triangles[t];
                mTriangles.back().slot = {slot, slot + 1, slot + 2};
                slot += 3;
            }
        }
    }
}

void TangentMaker::weldCorners()
{
    std::vector<int> faceOf(mMesh.cornerCount());
    for (int f = 0; f < mMesh.faceCount(); ++f)
        std::fill(faceOf.begin() + mMesh.faceStart[f], faceOf.begin() + mMesh.faceStart[f + 1], f);
    const auto key = [&](int c) {
        return std::tuple(welded(c), mMesh.faceObject[faceOf[c]], mUv[c].x(), mUv[c].y(), mNormals[c].x(),
                          mNormals[c].y(), mNormals[c].z());
    };
    std::vector<int> order(mMesh.cornerCount());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    mVertex.resize(mMesh.cornerCount());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
        mVertex[order[i]] = same ? mVertex[order[i - 1]] : order[i];
    }
}

void TangentMaker::measure(MikkTriangle &triangle) const
{
    const auto &[a, b, c] = triangle.corner;
    triangle.vertex = {mVertex[a], mVertex[b], mVertex[c]};
    triangle.collapsed = welded(a) == welded(b) || welded(b) == welded(c) || welded(c) == welded(a);
    const Eigen::Vector2f s = mUv[b] - mUv[a], t = mUv[c] - mUv[a];
    triangle.uvArea = s.x() * t.y() - s.y() * t.x();
    triangle.preserving = triangle.uvArea > 0;
    triangle.undefined = true;
    if (!(std::abs(triangle.uvArea) > std::numeric_limits<float>::min()))
        return;
    const Vec3 p = mMesh.cornerPosition(b) - mMesh.cornerPosition(a);
    const Vec3 q = mMesh.cornerPosition(c) - mMesh.cornerPosition(a);
    const Vec3 growingU = (double(t.y()) * p - double(s.y()) * q).stableNormalized();
    const Vec3 growingV = double(s.x()) * q - double(t.x()) * p;
    triangle.direction = triangle.preserving ? growingU : Vec3(-growingU);
    triangle.undefined = growingU.isZero(0) || growingV.isZero(0);
}

//! Both halves of a quad are mirrored, or none: as the one that is larger in the map.
void TangentMaker::alignQuads()
{
    for (std::size_t t = 0; t + 1 < mTriangles.size(); ++t) {
        MikkTriangle &first = mTriangles[t], &second = mTriangles[t + 1];
        if (first.quadHalf != 1 || first.collapsed || second.collapsed)
            continue;
        if (second.undefined || std::abs(first.uvArea) >= std::abs(second.uvArea))
            second.preserving = first.preserving;
        else
            first.preserving = second.preserving;
    }
}

//! Joins the sides on each edge that run in opposite directions, in the order of the triangles.
void TangentMaker::findNeighbours()
{
    struct Side
    {
        int low, high, triangle, side;
        bool forward;
    };
    std::vector<Side> sides;
    sides.reserve(3 * mTriangles.size());
    for (std::size_t t = 0; t < mTriangles.size(); ++t) {
        for (int k = 0; k < 3 && !mTriangles[t].collapsed; ++k) {
            const int a = mTriangles[t].vertex[k], b = mTriangles[t].vertex[(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), k, a < b});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side &a, const Side &b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    std::vector<const Side *> waiting; // all in one direction
    std::size_t next = 0;              // the first of them without a partner
    for (const Side &side : sides) {
        if (next == waiting.size() || waiting[next]->low != side.low || waiting[next]->high != side.high) {
            waiting.clear();
            next = 0;
        }
        if (waiting.empty() || waiting[next]->forward == side.forward) {
            waiting.push_back(&side);
            continue;
        }
        const Side &partner = *waiting[next++];
        mTriangles[side.triangle].neighbour[side.side] = partner.triangle;
        mTriangles[partner.triangle].neighbour[partner.side] = side.triangle;
    }
}

//! Starts a group at each corner that has none, and lets it grow around the vertex.
void TangentMaker::growGroups(int triangle)
{
    for (int k = 0; k < 3; ++k) {
        MikkTriangle &start = mTriangles[triangle];
        if (start.collapsed || start.undefined || start.group[k] >= 0)
            continue;
        const int group = static_cast<int>(mGroups.size());
        mGroups.push_back({start.vertex[k], start.preserving});
        mOpen.push_back(triangle);
        while (!mOpen.empty()) {
            const int next = mOpen.back();
            mOpen.pop_back();
            spread(next, group);
        }
    }
}

//! Takes a triangle into a group, where it fits, and opens its neighbours at the vertex of the group.
void TangentMaker::spread(int triangle, int group)
{
    MikkTriangle &own = mTriangles[triangle];
    const int vertex = mGroups[group].vertex;
    const int k = own.vertex[0] == vertex ? 0 : own.vertex[1] == vertex ? 1 : 2;
    if (own.group[k] >= 0)
        return;
    // The first group that reaches a triangle without a tangent decides whether it counts as mirrored.
    if (own.undefined && own.group == Triple{-1, -1, -1})
        own.preserving = mGroups[group].preserving;
    if (own.preserving != mGroups[group].preserving)
        return;
    own.group[k] = group;
    for (const int side : {(k + 2) % 3, k}) {
        if (own.neighbour[side] >= 0)
            mOpen.push_back(own.neighbour[side]);
    }
}

//! A direction in the plane at right angles to a unit normal; zero where there is none.
Vec3 inPlane(const Vec3 &direction, const Vec3 &normal)
{
    return (direction - normal.dot(direction) * normal).stableNormalized();
}

//! The tangent of a triangle at its corner k, weighted by the angle at the corner in the plane of its normal.
Vec3 TangentMaker::weighted(const MikkTriangle &triangle, int k) const
{
    const int corner = triangle.corner[k];
    const Vec3 normal = mNormals[corner].cast<double>();
    const Vec3 p = mMesh.cornerPosition(corner);
    const Vec3 next = inPlane(mMesh.cornerPosition(triangle.corner[(k + 1) % 3]) - p, normal);
    const Vec3 previous = inPlane(mMesh.cornerPosition(triangle.corner[(k + 2) % 3]) - p, normal);
    return std::acos(std::clamp(next.dot(previous), -1.0, 1.0)) * inPlane(triangle.direction, normal);
}

void TangentMaker::sumUp()
{
    for (const MikkTriangle &triangle : mTriangles) {
        for (int k = 0; k < 3; ++k) {
            if (triangle.group[k] >= 0 && !triangle.undefined)
                mGroups[triangle.group[k]].sum += weighted(triangle, k);
        }
    }
    mTangents.resize(mSlotStart.back());
    std::vector<bool> filled(mTangents.size(), false);
    for (const MikkTriangle &triangle : mTriangles) {
        for (int k = 0; k < 3; ++k) {
            if (triangle.group[k] < 0)
                continue;
            const Group &group = mGroups[triangle.group[k]];
            Tangent &tangent = mTangents[triangle.slot[k]];
            Vec3 direction = group.sum.normalized();
            // The corners of a quad at its cut take the mean of both halves.
            if (filled[triangle.slot[k]])
                direction = (tangent.direction.cast<double>() + direction).normalized();
            if (!direction.isZero(0))
                tangent.direction = direction.cast<float>();
            tangent.sign = group.preserving ? 1.f : -1.f;
            filled[triangle.slot[k]] = true;
        }
    }
}

//! Collapsed triangles take the tangents of others at their corners.
void TangentMaker::mendCollapsed()
{
    std::vector<int> slotOfVertex(mMesh.cornerCount(), -1);
    for (const MikkTriangle &triangle : mTriangles) {
        for (int k = 0; k < 3 && !triangle.collapsed; ++k) {
            int &slot = slotOfVertex[triangle.vertex[k]];
            if (slot < 0)
                slot = triangle.slot[k];
        }
    }
    for (std::size_t t = 0; t < mTriangles.size(); ++t) {
        const MikkTriangle &triangle = mTriangles[t];
        if (!triangle.collapsed)
            continue;
        const MikkTriangle *half = triangle.quadHalf == 1   ? &mTriangles[t + 1]
                                   : triangle.quadHalf == 2 ? &mTriangles[t - 1]
                                                            : nullptr;
        if (half && !half->collapsed) {
            mendHalfCollapsedQuad(*half, triangle);
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            const int slot = slotOfVertex[triangle.vertex[k]];
            if (slot >= 0)
                mTangents[triangle.slot[k]] = mTangents[slot];
        }
    }
}

//! The corner that is only in the collapsed half takes the tangent of the corner at the same position.
void TangentMaker::mendHalfCollapsedQuad(const MikkTriangle &good, const MikkTriangle &collapsed)
{
    for (int k = 0; k < 3; ++k) {
        if (std::find(good.corner.begin(), good.corner.end(), collapsed.corner[k]) != good.corner.end())
            continue;
        for (int i = 0; i < 3; ++i) {
            if (welded(good.corner[i]) == welded(collapsed.corner[k]))
                mTangents[collapsed.slot[k]] = mTangents[good.slot[i]];
        }
    }
}

std::vector<Tangent> TangentMaker::result() const
{
    std::vector<Tangent> tangents(mMesh.soupCornerCount());
    for (int f = 0; f < mMesh.faceCount(); ++f) {
        const int start = mMesh.faceStart[f];
        const bool large = mMesh.faceStart[f + 1] - start > 4;
        const auto own = mMesh.soupCornersOf(f);
        for (const int s : own)
            tangents[s] =
                mTangents[mSlotStart[f] + (large ? s - *own.begin() : mMesh.cornerOfSoup(s) - start)];
    }
    return tangents;
}

} // namespace

std::vector<Tangent> mikkTangents(const MeshData &mesh, const UvMatrix &uv,
                                  const std::vector<Eigen::Vector3f> &normals)
{
    return TangentMaker(mesh, uv, normals).result();
}

} // namespace autocuts
