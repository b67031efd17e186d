#include "solver/preference/meshsymmetry.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace autocuts::preference {

namespace {

//! Share of the edge length that must match under a plane of symmetry; from the second value on no other
//! plane is tried. Chosen by hand; no measurement of their effect is recorded.
constexpr double exactShare = 0.95, certainShare = 0.999;
//! The same for models that are symmetric only in part or nearly, such as sculpts.
constexpr double leastShare = 0.45, leastArea = 0.75;
//! Distances within which two points match, as shares of the mean edge length: on exact models, and on others
//! at the end, and while their plane is sought. Chosen by hand.
constexpr double tolerance = 0.1, looseTolerance = 0.6, firstTolerance = 1.5;
constexpr double mostReach = 0.02; // of the size of the model: the edges of coarse models are long
constexpr int planeSteps = 8;

//! Welded vertices sorted into cubes whose side is twice the tolerance.
class PointGrid
{
public:
    PointGrid(const MeshData &mesh, double radius) : mMesh(mesh), mRadius(radius)
    {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            if (mesh.vertexWeld[v] == v)
                mPoints.emplace_back(cellOf(mesh.positions.row(v)), v);
        }
        std::sort(mPoints.begin(), mPoints.end());
    }

    //! The vertex nearest to a point within the tolerance, -1 when there is none.
    int nearest(const Vec3 &p) const
    {
        int best = -1;
        double least = mRadius * mRadius;
        const Cell low = cellOf(p - Vec3::Constant(mRadius)), high = cellOf(p + Vec3::Constant(mRadius));
        Cell cell;
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0]) {
            for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1]) {
                for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) {
                    for (auto at = std::lower_bound(mPoints.begin(), mPoints.end(), std::pair(cell, -1));
                         at != mPoints.end() && at->first == cell; ++at) {
                        const double d = (Vec3(mMesh.positions.row(at->second)) - p).squaredNorm();
                        if (d < least) {
                            least = d;
                            best = at->second;
                        }
                    }
                }
            }
        }
        return best;
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    Cell cellOf(const Vec3 &p) const
    {
        Cell cell;
        for (int i = 0; i < 3; ++i)
            cell[i] = static_cast<std::int64_t>(std::floor(std::clamp(p[i] / (2 * mRadius), -1e15, 1e15)));
        return cell;
    }

    const MeshData &mMesh;
    double mRadius;
    std::vector<std::pair<Cell, int>> mPoints;
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

//! Finds the mirror image of each vertex and edge.
class Matcher
{
public:
    //! \param reach of the mean edge length
    Matcher(const MeshData &mesh, double reach) : mMesh(mesh), mGrid(mesh, radiusFor(mesh, reach))
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
            if (mMesh.vertexWeld[v] != v)
                continue;
            const Vec3 p = mMesh.positions.row(v);
            mirror[v] = mGrid.nearest(p - 2 * found.normal.dot(p - found.point) * found.normal);
        }
        // Keep only vertices that are each other's mirror images.
        const std::vector<int> one = mirror;
        for (int v = 0; v < mMesh.vertexCount(); ++v) {
            if (one[v] >= 0 && one[one[v]] != v)
                mirror[v] = -1;
        }
    }

    const MeshData &mMesh;
    PointGrid mGrid;
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

std::optional<MeshSymmetry> findSymmetry(const MeshData &mesh, Exactness exactness)
{
    if (mesh.edgePairs.empty() || !(mesh.area > 0))
        return std::nullopt;
    const std::vector<Plane> planes = candidates(mesh);
    std::optional<MeshSymmetry> exact = bestOf(planes, Matcher(mesh, tolerance), exactShare);
    if (exact || exactness == Exactness::Exact)
        return exact;
    // Nearly symmetric: the plane moves until vertices and their images fit best.
    const Matcher wide(mesh, firstTolerance), narrow(mesh, looseTolerance);
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
    return best && best->matchedArea >= leastArea ? best : std::nullopt;
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
