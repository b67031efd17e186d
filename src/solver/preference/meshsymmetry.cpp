#include "solver/preference/meshsymmetry.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace autocuts::preference {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Share of the edge length that must match under a plane of symmetry; from the second value on no other
//! plane is tried.
constexpr double exactShare = 0.95, certainShare = 0.999;
//! The same for models that are symmetric only in part or nearly, such as sculpts.
constexpr double leastShare = 0.45, leastArea = 0.75;
//! Distances within which two points match, as shares of the mean edge length: on exact models, and on others
//! at the end, and while their plane is sought.
constexpr double tolerance = 0.1, looseTolerance = 0.6, firstTolerance = 1.5;
constexpr double mostReach = 0.02; // of the size of the model: the edges of coarse models are long
constexpr int planeSteps = 8;

//! Welded vertices in the order of a k-d tree: the middle one of a range divides the others by one
//! coordinate. Takes the same time however many are near each other, in models with fine details.
class PointTree
{
public:
    PointTree(const MeshData &mesh, double radius) : mMesh(mesh), mRadius(radius)
    {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            if (mesh.vertexWeld[v] == v)
                mPoints.push_back({v, 0});
        }
        divide(0, mPoints.size());
    }

    //! The vertex nearest to a point within the tolerance, -1 when there is none.
    int nearest(const Vec3 &p) const
    {
        Nearest found{p, mRadius * mRadius};
        search(0, mPoints.size(), found);
        return found.vertex;
    }

private:
    struct Point
    {
        int vertex;
        int axis; //!< of the coordinate that divides the points before from those after
    };
    struct Nearest
    {
        Vec3 place;
        double squared; //!< distance
        int vertex = -1;
    };

    Vec3 at(std::size_t i) const { return mMesh.positions.row(mPoints[i].vertex); }

    void divide(std::size_t first, std::size_t end)
    {
        if (end - first < 2)
            return;
        Vec3 low = at(first), high = low;
        for (std::size_t i = first; i < end; ++i) {
            low = low.cwiseMin(at(i));
            high = high.cwiseMax(at(i));
        }
        int axis = 0;
        (high - low).maxCoeff(&axis);
        const std::size_t middle = first + (end - first) / 2;
        const auto less = [&](const Point &a, const Point &b) {
            return std::pair(mMesh.positions(a.vertex, axis), a.vertex) <
                   std::pair(mMesh.positions(b.vertex, axis), b.vertex);
        };
        const auto begin = mPoints.begin();
        std::nth_element(begin + first, begin + middle, begin + end, less);
        mPoints[middle].axis = axis;
        divide(first, middle);
        divide(middle + 1, end);
    }

    void search(std::size_t first, std::size_t end, Nearest &found) const
    {
        if (first >= end)
            return;
        const std::size_t middle = first + (end - first) / 2;
        const auto [vertex, axis] = mPoints[middle];
        const double squared = (at(middle) - found.place).squaredNorm();
        if (squared < found.squared || (squared == found.squared && vertex < found.vertex)) {
            found.squared = squared;
            found.vertex = vertex;
        }
        const double beyond = found.place[axis] - mMesh.positions(vertex, axis);
        beyond < 0 ? search(first, middle, found) : search(middle + 1, end, found);
        if (beyond * beyond <= found.squared)
            beyond < 0 ? search(middle + 1, end, found) : search(first, middle, found);
    }

    const MeshData &mMesh;
    double mRadius;
    std::vector<Point> mPoints;
};

using EdgeKey = std::array<int, 2>;

EdgeKey keyOf(int a, int b)
{
    return {std::min(a, b), std::max(a, b)};
}

struct Plane
{
    Vec3 point, normal;
};

//! Finds the mirror image of each vertex and edge; not of all once the job is stopped.
class Matcher
{
public:
    //! \param reach of the mean edge length
    Matcher(const MeshData &mesh, double reach, const JobContext &job)
        : mMesh(mesh), mTree(mesh, radiusFor(mesh, reach)), mJob(job)
    {
        for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
            if (!mesh.edgePairs[e].diagonal)
                mEdges.emplace(keyOfEdge(e), static_cast<int>(e));
        }
    }

    MeshSymmetry match(const Vec3 &point, const Vec3 &normal) const
    {
        MeshSymmetry found;
        found.point = point;
        found.normal = normal;
        matchVertices(found);
        found.mirrorEdge.assign(mMesh.edgePairs.size(), -1);
        double all = 0, matched = 0;
        for (std::size_t e = 0; e < mMesh.edgePairs.size(); ++e) {
            if (mMesh.edgePairs[e].diagonal)
                continue;
            all += mMesh.edgePairs[e].length;
            const EdgeKey key = keyOfEdge(e);
            const int a = found.mirrorVertex[key[0]], b = found.mirrorVertex[key[1]];
            const auto other = a < 0 || b < 0 ? mEdges.end() : mEdges.find(keyOf(a, b));
            // Where more than two faces meet at an edge, only its first pair gets a mirror image.
            if (other == mEdges.end() || mEdges.at(key) != static_cast<int>(e))
                continue;
            found.mirrorEdge[e] = other->second;
            matched += mMesh.edgePairs[e].length;
        }
        found.matchedShare = all > 0 ? matched / all : 0;
        found.matchedArea = matchedAreaOf(found);
        return found;
    }

    //! The plane that fits the vertices and their mirror images best; nothing with too few of them.
    std::optional<Plane> fitted(const Plane &plane) const
    {
        MeshSymmetry found;
        found.point = plane.point;
        found.normal = plane.normal;
        matchVertices(found);
        std::vector<std::pair<Vec3, Vec3>> pairs; // middle and difference
        Vec3 centre = Vec3::Zero();
        for (int v = 0; v < mMesh.vertexCount(); ++v) {
            const int image = found.mirrorVertex[v];
            if (image < 0)
                continue;
            const Vec3 p = mMesh.positions.row(v), q = mMesh.positions.row(image);
            pairs.emplace_back(0.5 * (p + q), p - q);
            centre += 0.5 * (p + q);
        }
        if (pairs.size() < 6)
            return std::nullopt;
        centre /= static_cast<double>(pairs.size());
        // The normal runs along the differences and across the middles.
        Eigen::Matrix3d form = Eigen::Matrix3d::Zero();
        for (const auto &[middle, difference] : pairs) {
            const Vec3 offset = middle - centre;
            form += difference * difference.transpose() - 4 * offset * offset.transpose();
        }
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(form);
        if (axes.info() != Eigen::Success)
            return std::nullopt;
        return Plane{centre, axes.eigenvectors().col(2).normalized()};
    }

private:
    static double radiusFor(const MeshData &mesh, double reach)
    {
        double sum = 0;
        for (const EdgePair &pair : mesh.edgePairs)
            sum += pair.length;
        const double mean = sum / std::max<double>(1, double(mesh.edgePairs.size()));
        return std::max(std::min(reach * mean, mostReach * mesh.report.boxDiagonal), 1e-300);
    }

    EdgeKey keyOfEdge(std::size_t e) const
    {
        const EdgePair &pair = mMesh.edgePairs[e];
        return keyOf(mMesh.vertexOfSoup(pair.corner[0][0]), mMesh.vertexOfSoup(pair.corner[1][0]));
    }

    double matchedAreaOf(const MeshSymmetry &found) const
    {
        double matched = 0;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const auto hasImage = [&](int k) {
                return found.mirrorVertex[mMesh.vertexOfSoup(3 * t + k)] >= 0;
            };
            if (hasImage(0) && hasImage(1) && hasImage(2))
                matched += mMesh.triangleArea[t];
        }
        return mMesh.area > 0 ? matched / mMesh.area : 0;
    }

    void matchVertices(MeshSymmetry &found) const
    {
        std::vector<int> &mirror = found.mirrorVertex;
        mirror.assign(mMesh.vertexCount(), -1);
        for (int v = 0; v < mMesh.vertexCount(); ++v) {
            if (mMesh.vertexWeld[v] != v || mJob.stopped())
                continue;
            const Vec3 p = mMesh.positions.row(v);
            mirror[v] = mTree.nearest(p - 2 * found.normal.dot(p - found.point) * found.normal);
        }
        // Keep only vertices that are each other's mirror images.
        const std::vector<int> one = mirror;
        for (int v = 0; v < mMesh.vertexCount(); ++v) {
            if (one[v] >= 0 && one[one[v]] != v)
                mirror[v] = -1;
        }
    }

    const MeshData &mMesh;
    const PointTree mTree;
    const JobContext &mJob;
    std::map<EdgeKey, int> mEdges;
};

std::vector<Plane> candidates(const MeshData &mesh)
{
    const Vec3 boxMiddle = 0.5 * (mesh.positions.colwise().minCoeff() + mesh.positions.colwise().maxCoeff());
    Vec3 middle = Vec3::Zero();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    const auto centre = [&](int t) {
        Vec3 sum = Vec3::Zero();
        for (int k = 0; k < 3; ++k)
            sum += mesh.cornerPosition(mesh.triangles[t][k]);
        return Vec3(sum / 3);
    };
    for (int t = 0; t < mesh.triangleCount(); ++t)
        middle += mesh.triangleArea[t] / mesh.area * centre(t);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const Vec3 d = centre(t) - middle;
        spread += mesh.triangleArea[t] / mesh.area * d * d.transpose();
    }
    std::vector<Plane> planes;
    for (const Vec3 &point : {boxMiddle, middle}) {
        for (int axis = 0; axis < 3; ++axis)
            planes.push_back({point, Vec3::Unit(axis)});
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    for (int i = 0; i < 3 && axes.info() == Eigen::Success; ++i)
        planes.push_back({middle, axes.eigenvectors().col(i).normalized()});
    return planes;
}

//! The plane under which most matches; nothing when that is less than the given share.
std::optional<MeshSymmetry> bestOf(const std::vector<Plane> &planes, const Matcher &matcher, double least)
{
    std::optional<MeshSymmetry> best;
    for (const Plane &plane : planes) {
        MeshSymmetry found = matcher.match(plane.point, plane.normal);
        if (found.matchedShare >= least && (!best || found.matchedShare > best->matchedShare))
            best = std::move(found);
        if (best && best->matchedShare >= certainShare)
            break;
    }
    return best;
}

} // namespace

std::optional<MeshSymmetry> findSymmetry(const MeshData &mesh, Exactness exactness, const JobContext &job)
{
    if (mesh.edgePairs.empty() || !(mesh.area > 0))
        return std::nullopt;
    const std::vector<Plane> planes = candidates(mesh);
    std::optional<MeshSymmetry> exact = bestOf(planes, Matcher(mesh, tolerance, job), exactShare);
    if (job.stopped())
        return std::nullopt;
    if (exact || exactness == Exactness::Exact)
        return exact;
    // Nearly symmetric: the plane moves until vertices and their images fit best.
    const Matcher wide(mesh, firstTolerance, job), narrow(mesh, looseTolerance, job);
    std::vector<Plane> fitted;
    for (Plane plane : planes) {
        for (int step = 0; step < planeSteps; ++step) {
            const std::optional<Plane> next = (2 * step < planeSteps ? wide : narrow).fitted(plane);
            if (!next || std::abs(next->normal.dot(plane.normal)) < 0.5)
                break;
            plane = *next;
        }
        fitted.push_back(plane);
    }
    std::optional<MeshSymmetry> best = bestOf(fitted, narrow, leastShare);
    return best && best->matchedArea >= leastArea && !job.stopped() ? best : std::nullopt;
}

double symmetricShare(const MeshData &mesh, const MeshSymmetry &symmetry, const std::vector<bool> &cut)
{
    double all = 0, paired = 0;
    for (std::size_t e = 0; e < cut.size(); ++e) {
        if (!cut[e])
            continue;
        all += mesh.edgePairs[e].length;
        if (symmetry.mirrorEdge[e] >= 0 && cut[symmetry.mirrorEdge[e]])
            paired += mesh.edgePairs[e].length;
    }
    return all > 0 ? paired / all : 1;
}

} // namespace autocuts::preference
