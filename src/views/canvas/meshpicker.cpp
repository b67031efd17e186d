#include "views/canvas/meshpicker.h"

#include "views/canvas/depthmap.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace autocuts {

SegmentPlace nearestOnSegment(double px, double py, double ax, double ay, double bx, double by)
{
    const double dx = bx - ax, dy = by - ay;
    const double squared = dx * dx + dy * dy;
    const double along = squared > 0 ? std::clamp(((px - ax) * dx + (py - ay) * dy) / squared, 0.0, 1.0) : 0;
    return {std::hypot(px - ax - along * dx, py - ay - along * dy), along};
}

//! The vertices projected to the screen.
struct MeshPicker::Projection
{
    std::vector<ScreenPoint> points;
    std::vector<char> before; //!< in front of the eye; other vertices have no screen position
    std::vector<int> around;  //!< triangles that may be within pickRadius of the mouse, ascending
};

namespace {

//! Only this many candidates are tested; when all of them are hidden, nothing is picked. Chosen by hand.
constexpr std::size_t maxCandidates = 24;

} // namespace

MeshPicker::MeshPicker(std::shared_ptr<const MeshData> mesh, const MeshFrame &frame,
                       const SoupTopology &topology, const std::vector<bool> &hidden)
    : mMesh(std::move(mesh)), mTopology(topology), mPoints(mMesh->vertexCount(), 3)
{
    for (int v = 0; v < mMesh->vertexCount(); ++v)
        mPoints.row(v) = frame.toFrame(mMesh->positions.row(v));
    mVertices.reserve(mMesh->triangles.size());
    for (const std::array<int, 3> &corners : mMesh->triangles)
        mVertices.push_back({mMesh->cornerVertex[corners[0]], mMesh->cornerVertex[corners[1]],
                             mMesh->cornerVertex[corners[2]]});
    for (int face : mMesh->triangleFace)
        mHidden.push_back(!hidden.empty() && hidden[face]);
}

MeshPicker::Projection MeshPicker::project(const OrbitCamera &camera) const
{
    Projection seen;
    seen.points.resize(mMesh->vertexCount());
    seen.before.resize(mMesh->vertexCount());
    const OrbitProjector projector(camera);
    for (int v = 0; v < mMesh->vertexCount(); ++v)
        seen.before[v] = projector.project(mPoints.row(v), seen.points[v]);
    return seen;
}

MeshPicker::Projection MeshPicker::projectNear(const OrbitCamera &camera, const QPointF &pixel) const
{
    Projection seen = project(camera);
    const double left = pixel.x() - pickRadius, right = pixel.x() + pickRadius;
    const double top = pixel.y() - pickRadius, bottom = pixel.y() + pickRadius;
    for (int t = 0; t < mMesh->triangleCount(); ++t) {
        if (mHidden[t])
            continue;
        const auto &v = mVertices[t];
        const ScreenPoint &a = seen.points[v[0]], &b = seen.points[v[1]], &c = seen.points[v[2]];
        const bool outside =
            (a.x < left && b.x < left && c.x < left) || (a.x > right && b.x > right && c.x > right) ||
            (a.y < top && b.y < top && c.y < top) || (a.y > bottom && b.y > bottom && c.y > bottom);
        // A triangle that reaches behind the eye can be anywhere on the screen.
        if (!outside || !seen.before[v[0]] || !seen.before[v[1]] || !seen.before[v[2]])
            seen.around.push_back(t);
    }
    return seen;
}

std::vector<MeshPicker::Hit> MeshPicker::hits(const OrbitCamera &camera, const Projection &seen,
                                              const QPointF &pixel) const
{
    const ViewRay ray = camera.ray(pixel);
    std::vector<Hit> found;
    for (int t : seen.around) {
        const std::array<int, 3> &v = mVertices[t];
        // Moeller and Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection".
        const Vec3 origin = mPoints.row(v[0]);
        const Vec3 e1 = Vec3(mPoints.row(v[1])) - origin, e2 = Vec3(mPoints.row(v[2])) - origin;
        const Vec3 p = ray.direction.cross(e2);
        const double determinant = e1.dot(p);
        if (determinant == 0)
            continue;
        const Vec3 s = ray.origin - origin;
        const double u = s.dot(p) / determinant;
        const Vec3 q = s.cross(e1);
        const double w = ray.direction.dot(q) / determinant;
        const double distance = e2.dot(q) / determinant;
        if (u >= 0 && w >= 0 && u + w <= 1 && distance > 0)
            found.push_back({t, distance});
    }
    return found;
}

MeshPicker::Hit MeshPicker::cast(const OrbitCamera &camera, const Projection &seen,
                                 const QPointF &pixel) const
{
    Hit nearest{-1, std::numeric_limits<double>::infinity()};
    for (const Hit &hit : hits(camera, seen, pixel)) {
        if (hit.distance < nearest.distance)
            nearest = hit;
    }
    return nearest;
}

std::vector<int> MeshPicker::trianglesAt(const OrbitCamera &camera, const QPointF &pixel) const
{
    std::vector<Hit> found = hits(camera, projectNear(camera, pixel), pixel);
    std::stable_sort(found.begin(), found.end(),
                     [](const Hit &a, const Hit &b) { return a.distance < b.distance; });
    std::vector<int> triangles;
    for (const Hit &hit : found)
        triangles.push_back(hit.triangle);
    return triangles;
}

bool MeshPicker::isVisible(const OrbitCamera &camera, const Projection &seen,
                           const Candidate &candidate) const
{
    const Hit hit = cast(camera, seen, candidate.place);
    if (hit.triangle < 0)
        return true;
    const ViewRay ray = camera.ray(candidate.place);
    const double depth = (ray.origin + hit.distance * ray.direction - camera.eye()).dot(camera.forward());
    return depth >= candidate.depth - 1e-6 * (std::abs(candidate.depth) + camera.distance());
}

int MeshPicker::firstVisible(const OrbitCamera &camera, const Projection &seen,
                             std::vector<Candidate> candidates, int preferredTriangle, bool through) const
{
    const auto key = [preferredTriangle](const Candidate &c) {
        // Both sides of an edge are equally far away; rounding must not decide between them.
        return std::tuple(std::round(c.distance * 1e6), c.soup / 3 != preferredTriangle, c.depth, c.soup);
    };
    const auto end =
        candidates.begin() + static_cast<std::ptrdiff_t>(std::min(maxCandidates, candidates.size()));
    std::partial_sort(candidates.begin(), end, candidates.end(),
                      [&key](const Candidate &a, const Candidate &b) { return key(a) < key(b); });
    const auto found = std::find_if(candidates.begin(), end, [&](const Candidate &candidate) {
        return through || isVisible(camera, seen, candidate);
    });
    return found == end ? -1 : found->soup;
}

void MeshPicker::collect(const OrbitCamera &camera, const Projection &seen, const QPointF &pixel,
                         std::vector<Candidate> &sides, std::vector<Candidate> &corners) const
{
    const double x = pixel.x(), y = pixel.y();
    for (int i = 0; i < 3 * static_cast<int>(seen.around.size()); ++i) {
        const int s = 3 * seen.around[i / 3] + i % 3;
        const int from = vertex(s), to = vertex(nextSoupCorner(s));
        if (!seen.before[from])
            continue;
        const ScreenPoint &a = seen.points[from];
        const double apart = std::hypot(a.x - x, a.y - y);
        if (apart <= pickRadius)
            corners.push_back({apart, s, {a.x, a.y}, a.depth});
        if (mTopology.sideEdge[s] < 0 || !seen.before[to])
            continue;
        const ScreenPoint &b = seen.points[to];
        const SegmentPlace place = nearestOnSegment(x, y, a.x, a.y, b.x, b.y);
        if (place.distance > pickRadius)
            continue;
        const double k = place.along;
        const double depth =
            camera.isOrthographic() ? (1 - k) * a.depth + k * b.depth : 1 / ((1 - k) / a.depth + k / b.depth);
        sides.push_back({place.distance, s, {a.x + k * (b.x - a.x), a.y + k * (b.y - a.y)}, depth});
    }
}

PickResult MeshPicker::pick(const OrbitCamera &camera, const QPointF &pixel, bool through) const
{
    const Projection seen = projectNear(camera, pixel);
    PickResult result;
    result.triangle = cast(camera, seen, pixel).triangle;
    std::vector<Candidate> sides, corners;
    collect(camera, seen, pixel, sides, corners);
    result.side = firstVisible(camera, seen, std::move(sides), result.triangle, through);
    result.edge = result.side < 0 ? -1 : mTopology.sideEdge[result.side];
    result.soupCorner = firstVisible(camera, seen, std::move(corners), result.triangle, through);
    result.corner = result.soupCorner < 0 ? -1 : mMesh->cornerOfSoup(result.soupCorner);
    return result;
}

Vec3 MeshPicker::faceCentre(int face) const
{
    // Weighted by area, because the average of the corners may lie outside a concave face.
    Vec3 sum = Vec3::Zero();
    double area = 0;
    for (const int t : mMesh->trianglesOf(face)) {
        const double weight = std::max(mMesh->triangleArea[t], std::numeric_limits<double>::min());
        for (int vertex : mVertices[t])
            sum += weight / 3 * mPoints.row(vertex).transpose();
        area += weight;
    }
    return sum / area;
}

BoxPick MeshPicker::pickBox(const OrbitCamera &camera, const PickRegion &region, bool through) const
{
    const OrbitProjector projector(camera);
    DepthMap depths(region.box);
    const Projection seen = project(camera);
    for (int t = 0; t < mMesh->triangleCount() && !through; ++t) {
        const std::array<int, 3> v{vertex(3 * t), vertex(3 * t + 1), vertex(3 * t + 2)};
        if (!mHidden[t] && seen.before[v[0]] && seen.before[v[1]] && seen.before[v[2]])
            depths.add({seen.points[v[0]], seen.points[v[1]], seen.points[v[2]]}, !camera.isOrthographic());
    }
    const auto inside = [&](const Vec3 &point) {
        ScreenPoint place;
        return projector.project(point, place) && region.contains({place.x, place.y}) &&
               (through || depths.isVisible(place));
    };
    BoxPick result;
    std::vector<bool> vertexInside(mMesh->vertexCount());
    for (int v = 0; v < mMesh->vertexCount(); ++v)
        vertexInside[v] = inside(mPoints.row(v));
    for (int f = 0; f < mMesh->faceCount(); ++f) {
        if (isHiddenFace(f))
            continue;
        for (int c = mMesh->faceStart[f]; c < mMesh->faceStart[f + 1]; ++c) {
            if (vertexInside[mMesh->cornerVertex[c]])
                result.corners.push_back(c);
        }
        if (inside(faceCentre(f)))
            result.faces.push_back(f);
    }
    for (std::size_t e = 0; e < mTopology.edgeSides.size(); ++e) {
        const auto [side, other] = mTopology.edgeSides[e];
        if (mTopology.sideEdge[side] != static_cast<int>(e) ||
            (mHidden[side / 3] && (other < 0 || mHidden[other / 3])))
            continue;
        const int a = vertex(side), b = vertex(nextSoupCorner(side));
        if (inside(0.5 * (mPoints.row(a) + mPoints.row(b))))
            result.edges.push_back(static_cast<int>(e));
    }
    return result;
}

} // namespace autocuts
