#include "solver/multires/edgecollapses.h"

#include "solver/base/constant.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>

#include <OpenMesh/Core/Geometry/QuadricT.hh> // must come last: the header does not include what it needs

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

namespace autocuts::multires {

namespace {

//! Least cosine of the angle by which a collapse may rotate a triangle. This limit and the four below were
//! chosen by hand.
constexpr double smallestTurn = 0.3;
//! Least area of a triangle over its squared longest edge; 0.43 in an equilateral one.
constexpr double thinnest = 0.02;
//! Most triangles around a point.
constexpr int largestFan = 14;
//! Weight of squared edge lengths compared with squared distances to planes: keeps triangles regular in flat
//! regions.
AUTOCUTS_CONSTANT(double, evenness, 2e-3);
//! Weight of the planes that keep borders in place.
constexpr double borderWeight = 3;

struct Traits : OpenMesh::DefaultTraitsDouble
{
    VertexTraits
    {
    public:
        //! Sum of squared distances to the planes of all triangles merged into this point.
        OpenMesh::Geometry::Quadricd quadric;
        int triangles = 0; //!< number of triangles around the point
    };
};

//! The surface in OpenMesh. Points keep their numbers.
class HalfEdgeMesh : public OpenMesh::TriMesh_ArrayKernelT<Traits>
{
public:
    //! The decimater asks this for each edge around each change: checks the limits, then the topology.
    bool is_collapse_ok(HalfedgeHandle h) const
    {
        const HalfedgeHandle back = opposite_halfedge_handle(h);
        const int removed = data(to_vertex_handle(back)).triangles,
                  kept = data(to_vertex_handle(h)).triangles;
        const int shared = !is_boundary(h) + !is_boundary(back);
        return removed <= largestFan && removed + kept - 2 * shared <= largestFan && apexStays(h) &&
               apexStays(back) && keepsTopology(h);
    }

private:
    //! What OpenMesh tests in its is_collapse_ok(), in a tenth of the time: that one marks all points around
    //! both ends. \pre at most largestFan triangles around the result
    bool keepsTopology(HalfedgeHandle h) const
    {
        const HalfedgeHandle back = opposite_halfedge_handle(h);
        const VertexHandle removed = to_vertex_handle(back), kept = to_vertex_handle(h);
        const VertexHandle left = apexOf(h), right = apexOf(back);
        if (left == right || hangsBy(h) || hangsBy(back) ||
            (left.is_valid() && right.is_valid() && is_boundary(removed) && is_boundary(kept)))
            return false;
        // No other point may be next to both ends.
        std::array<int, largestFan + 5> around;
        std::size_t count = 0;
        for (HalfedgeHandle side = back; count < around.size(); ++count) {
            around[count] = to_vertex_handle(side).idx();
            side = next_halfedge_handle(opposite_halfedge_handle(side));
            if (side == back)
                break;
        }
        const auto last = around.begin() + static_cast<std::ptrdiff_t>(std::min(count + 1, around.size()));
        for (HalfedgeHandle side = next_halfedge_handle(back); side != h;
             side = next_halfedge_handle(opposite_halfedge_handle(side))) {
            const VertexHandle point = to_vertex_handle(side);
            if (point != left && point != right && std::find(around.begin(), last, point.idx()) != last)
                return false;
        }
        return true;
    }

    //! The third corner of the triangle at a side; not valid at a border.
    VertexHandle apexOf(HalfedgeHandle h) const
    {
        return is_boundary(h) ? VertexHandle() : to_vertex_handle(next_halfedge_handle(h));
    }

    //! True when the triangle at a side has no other neighbour.
    bool hangsBy(HalfedgeHandle h) const
    {
        if (is_boundary(h))
            return false;
        const HalfedgeHandle next = next_halfedge_handle(h);
        return is_boundary(opposite_halfedge_handle(next)) &&
               is_boundary(opposite_halfedge_handle(next_halfedge_handle(next)));
    }

    //! True when the point opposite to an edge can lose its triangle at that edge.
    bool apexStays(HalfedgeHandle h) const
    {
        if (is_boundary(h))
            return true;
        const VertexHandle apex = to_vertex_handle(next_halfedge_handle(h));
        return data(apex).triangles >= (is_boundary(apex) ? 2 : 4);
    }
};

using Point = HalfEdgeMesh::Point;

//! The cost of a collapse and the limits on the shapes of triangles.
class CollapseCost : public OpenMesh::Decimater::ModBaseT<HalfEdgeMesh>
{
public:
    explicit CollapseCost(HalfEdgeMesh &surface) : ModBaseT(surface, false) {}

    void initialize() override;
    float collapse_priority(const CollapseInfo &info) override;
    void preprocess_collapse(const CollapseInfo &info) override;

    std::vector<HalfEdgeCollapse> collapses; //!< collapses so far, in order

private:
    bool keepsShape(const Point &p, const Point &q, const Point &from, const Point &to) const;
};

//! Adds to each point the planes of its triangles and, at borders, planes through the border perpendicular to
//! them. The mesh is scaled to a mean triangle area of 1.
void CollapseCost::initialize()
{
    for (const auto face : mesh().faces()) {
        Point corners[3];
        int k = 0;
        for (const auto vertex : mesh().fv_range(face))
            corners[k++] = mesh().point(vertex);
        const Point cross = (corners[1] - corners[0]) % (corners[2] - corners[0]);
        const double area = cross.norm();
        if (!(area > 0))
            continue;
        const Point n = cross / area;
        const OpenMesh::Geometry::Quadricd plane(n, corners[0]);
        for (const auto side : mesh().fh_range(face)) {
            const auto from = mesh().from_vertex_handle(side), to = mesh().to_vertex_handle(side);
            mesh().data(to).quadric += plane * area;
            if (!mesh().is_boundary(mesh().opposite_halfedge_handle(side)))
                continue;
            const Point outward = (mesh().point(to) - mesh().point(from)) % n;
            const double length = outward.norm();
            if (!(length > 0))
                continue;
            OpenMesh::Geometry::Quadricd wall(outward / length, mesh().point(from));
            wall *= borderWeight * length * length;
            mesh().data(from).quadric += wall;
            mesh().data(to).quadric += wall;
        }
    }
}

//! True when a triangle keeps its shape within the limits while one corner moves.
bool CollapseCost::keepsShape(const Point &p, const Point &q, const Point &from, const Point &to) const
{
    const Point before = (p - from) % (q - from), after = (p - to) % (q - to);
    const double size = after.norm();
    const double longest = std::max({(p - to).sqrnorm(), (q - to).sqrnorm(), (p - q).sqrnorm()});
    return size > 2 * thinnest * longest && (before | after) >= smallestTurn * before.norm() * size;
}

float CollapseCost::collapse_priority(const CollapseInfo &info)
{
    for (const auto side : mesh().voh_range(info.v0)) {
        const auto face = mesh().face_handle(side);
        if (!face.is_valid() || face == info.fl || face == info.fr)
            continue;
        const Point &p = mesh().point(mesh().to_vertex_handle(side));
        const Point &q = mesh().point(mesh().to_vertex_handle(mesh().next_halfedge_handle(side)));
        if (!keepsShape(p, q, info.p0, info.p1))
            return ILLEGAL_COLLAPSE;
    }
    const auto &removed = mesh().data(info.v0), &kept = mesh().data(info.v1);
    const double error = removed.quadric(info.p1) + kept.quadric(info.p1);
    const double uneven = evenness * removed.triangles * (info.p1 - info.p0).sqrnorm();
    return static_cast<float>(std::max(0.0, error) + uneven);
}

void CollapseCost::preprocess_collapse(const CollapseInfo &info)
{
    const int shared = info.fl.is_valid() + info.fr.is_valid();
    mesh().data(info.v1).quadric += mesh().data(info.v0).quadric;
    mesh().data(info.v1).triangles += mesh().data(info.v0).triangles - 2 * shared;
    for (const auto apex : {info.vl, info.vr}) {
        if (apex.is_valid())
            --mesh().data(apex).triangles;
    }
    collapses.push_back({info.v0.idx(), info.v1.idx()});
}

//! Builds the half-edges of a surface. OpenMesh identifies an edge by its end points, so the ends of edges
//! that differ in it are locked.
class Builder
{
public:
    Builder(const CollapsingSurface &surface, HalfEdgeMesh &mesh) : mSurface(surface), mMesh(mesh)
    {
        mMesh.request_vertex_status();
        addPoints();
        addTriangles();
        for (const auto face : mMesh.faces()) {
            for (const auto side : mMesh.fh_range(face))
                lockUnlessSame(side, mTriangle[face.idx()]);
        }
    }
    int refused() const { return mRefused; }

private:
    using Handle = HalfEdgeMesh::VertexHandle;

    //! Adds the points, centred and scaled to a mean triangle area of 1, so that the costs are accurate in
    //! single precision.
    void addPoints()
    {
        double area = 0;
        int count = 0;
        for (std::size_t t = 0; t < mSurface.alive.size(); ++t) {
            if (!mSurface.alive[t])
                continue;
            const Vec3 &a = at(3 * t), &b = at(3 * t + 1), &c = at(3 * t + 2);
            area += 0.5 * (b - a).cross(c - a).norm();
            ++count;
        }
        const double scale = area > 0 ? std::sqrt(count / area) : 1;
        Vec3 middle = Vec3::Zero();
        for (const Vec3 &p : mSurface.position)
            middle += p / double(mSurface.position.size());
        mMesh.reserve(mSurface.position.size(), mSurface.position.size() + count + 1, count);
        for (std::size_t p = 0; p < mSurface.position.size(); ++p) {
            const Vec3 place = scale * (mSurface.position[p] - middle);
            const Handle vertex = mMesh.add_vertex({place.x(), place.y(), place.z()});
            mMesh.status(vertex).set_locked(mSurface.locked[p]);
        }
    }

    void addTriangles()
    {
        static std::once_flag silenced; // OpenMesh prints a message for every face it refuses
        std::call_once(silenced, [] { omerr().disable(); });
        for (std::size_t t = 0; t < mSurface.alive.size(); ++t) {
            if (!mSurface.alive[t])
                continue;
            const int *points = &mSurface.point[3 * t];
            const Handle a(points[0]), b(points[1]), c(points[2]);
            const bool good = a != b && b != c && c != a && mMesh.add_face(a, b, c).is_valid();
            for (const Handle vertex : {a, b, c}) {
                mMesh.data(vertex).triangles += good;
                if (!good)
                    mMesh.status(vertex).set_locked(true);
            }
            if (good)
                mTriangle.push_back(static_cast<int>(t));
            else
                ++mRefused;
        }
    }

    void lockUnlessSame(HalfEdgeMesh::HalfedgeHandle h, int triangle)
    {
        const Handle from = mMesh.from_vertex_handle(h), to = mMesh.to_vertex_handle(h);
        int side = 3 * triangle;
        while (mSurface.point[side] != from.idx())
            ++side;
        const int across = mSurface.across[side];
        const auto other = mMesh.face_handle(mMesh.opposite_halfedge_handle(h));
        const bool same = other.is_valid() ? across >= 0 && across / 3 == mTriangle[other.idx()] &&
                                                 mSurface.point[across] == to.idx()
                                           : across < 0;
        for (const Handle vertex : {from, to}) {
            if (!same)
                mMesh.status(vertex).set_locked(true);
        }
    }

    const Vec3 &at(std::size_t corner) const { return mSurface.position[mSurface.point[corner]]; }

    const CollapsingSurface &mSurface;
    HalfEdgeMesh &mMesh;
    std::vector<int> mTriangle; //!< triangle of each face
    int mRefused = 0;
};

//! Ends the decimation when the job is stopped.
class Stopper final : public OpenMesh::Decimater::Observer
{
public:
    explicit Stopper(const JobContext &job) : Observer(collapsesPerLook), mJob(job) {}
    void notify(std::size_t) override {}
    bool abort() const override { return mJob.stopped(); }

private:
    static constexpr std::size_t collapsesPerLook = 100;
    const JobContext &mJob;
};

} // namespace

std::vector<HalfEdgeCollapse> edgeCollapses(const CollapsingSurface &surface, int triangles,
                                            const JobContext &job)
{
    HalfEdgeMesh mesh;
    const Builder builder(surface, mesh);
    OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(mesh);
    OpenMesh::Decimater::ModHandleT<CollapseCost> cost;
    decimater.add(cost);
    Stopper stopper(job);
    decimater.set_observer(&stopper);
    decimater.initialize();
    decimater.decimate_to_faces(0, static_cast<std::size_t>(std::max(0, triangles - builder.refused())));
    return std::move(decimater.module(cost).collapses);
}

} // namespace autocuts::multires
