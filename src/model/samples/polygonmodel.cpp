#include "model/samples/polygonmodel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace autocuts::samples {

namespace {

using EdgeKey = std::pair<int, int>;

EdgeKey edgeKey(int a, int b)
{
    return {std::min(a, b), std::max(a, b)};
}

} // namespace

Frame frameAlong(const Vec3 &origin, const Vec3 &direction)
{
    Frame frame;
    frame.origin = origin;
    frame.z = direction.normalized();
    const Vec3 helper = std::abs(frame.z.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitZ();
    frame.x = helper.cross(frame.z).normalized();
    frame.y = frame.z.cross(frame.x);
    return frame;
}

void PolygonModel::beginObject(const QString &name)
{
    mObject = static_cast<int>(mObjects.size());
    mObjects.push_back(name);
}

void PolygonModel::useMaterial(const QString &name)
{
    const auto found = std::find(mMaterials.begin(), mMaterials.end(), name);
    mMaterial = static_cast<int>(found - mMaterials.begin());
    if (found == mMaterials.end())
        mMaterials.push_back(name);
}

int PolygonModel::addPoint(const Vec3 &point)
{
    points.push_back(point);
    return static_cast<int>(points.size()) - 1;
}

int PolygonModel::addFace(std::vector<int> corners)
{
    faces.push_back(std::move(corners));
    mFaceObject.push_back(mObject);
    mFaceMaterial.push_back(mMaterial);
    return static_cast<int>(faces.size()) - 1;
}

std::vector<int> PolygonModel::border(const std::vector<int> &region) const
{
    std::map<EdgeKey, int> uses;
    std::map<int, int> next;
    for (int f : region) {
        for (std::size_t i = 0; i < faces[f].size(); ++i)
            ++uses[edgeKey(faces[f][i], faces[f][(i + 1) % faces[f].size()])];
    }
    for (int f : region) {
        for (std::size_t i = 0; i < faces[f].size(); ++i) {
            const int a = faces[f][i];
            const int b = faces[f][(i + 1) % faces[f].size()];
            if (uses[edgeKey(a, b)] == 1)
                next[a] = b;
        }
    }
    std::vector<int> loop;
    const int start = next.begin()->first;
    int v = start;
    do {
        loop.push_back(v);
        v = next.at(v);
    } while (v != start);
    return loop;
}

void PolygonModel::extrude(const std::vector<int> &region, const Vec3 &offset, const Vec3 &scale)
{
    const std::vector<int> loop = border(region);
    std::map<int, int> copy;
    Vec3 centre = Vec3::Zero();
    for (int f : region) {
        for (int v : faces[f]) {
            if (copy.try_emplace(v, -1).second)
                centre += points[v];
        }
    }
    centre /= static_cast<double>(copy.size());
    for (auto &[from, to] : copy) {
        const Vec3 arm = points[from] - centre;
        to = addPoint(centre + scale.cwiseProduct(arm) + offset);
    }
    for (int f : region) {
        for (int &v : faces[f])
            v = copy[v];
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const int a = loop[i];
        const int b = loop[(i + 1) % loop.size()];
        addFace({a, b, copy[b], copy[a]});
    }
}

void PolygonModel::removeFaces(std::vector<int> region)
{
    std::sort(region.rbegin(), region.rend());
    for (int f : region) {
        faces.erase(faces.begin() + f);
        mFaceObject.erase(mFaceObject.begin() + f);
        mFaceMaterial.erase(mFaceMaterial.begin() + f);
    }
}

void PolygonModel::dropUnusedPoints()
{
    std::vector<int> number(points.size(), -1);
    std::vector<Vec3> kept;
    for (auto &face : faces) {
        for (int &v : face) {
            if (number[v] < 0) {
                number[v] = static_cast<int>(kept.size());
                kept.push_back(points[v]);
            }
            v = number[v];
        }
    }
    points = std::move(kept);
}

void PolygonModel::subdivide()
{
    dropUnusedPoints();
    const int oldPoints = static_cast<int>(points.size());
    const std::vector<std::vector<int>> oldFaces = std::move(faces);
    const std::vector<int> oldObject = std::move(mFaceObject);
    const std::vector<int> oldMaterial = std::move(mFaceMaterial);
    std::vector<Vec3> faceSum(oldPoints, Vec3::Zero()); // around each point
    std::vector<Vec3> middleSum(oldPoints, Vec3::Zero());
    std::vector<int> valence(oldPoints, 0);
    std::vector<int> facePoint;
    std::map<EdgeKey, std::pair<Vec3, int>> edges; // sum of the two face points; the new point

    for (const auto &face : oldFaces) {
        Vec3 centre = Vec3::Zero();
        for (int v : face)
            centre += points[v];
        centre /= static_cast<double>(face.size());
        facePoint.push_back(addPoint(centre));
        for (std::size_t i = 0; i < face.size(); ++i) {
            faceSum[face[i]] += centre;
            const EdgeKey key = edgeKey(face[i], face[(i + 1) % face.size()]);
            edges.try_emplace(key, Vec3::Zero(), 0).first->second.first += centre;
        }
    }
    for (auto &[key, edge] : edges) {
        const Vec3 ends = points[key.first] + points[key.second];
        edge.second = addPoint((ends + edge.first) / 4);
        for (int v : {key.first, key.second}) {
            middleSum[v] += ends / 2;
            ++valence[v];
        }
    }
    for (int v = 0; v < oldPoints; ++v) {
        const double n = valence[v];
        points[v] = (faceSum[v] / n + 2 * middleSum[v] / n + (n - 3) * points[v]) / n;
    }
    faces.clear();
    mFaceObject.clear();
    mFaceMaterial.clear();
    for (std::size_t f = 0; f < oldFaces.size(); ++f) {
        const auto &face = oldFaces[f];
        mObject = oldObject[f];
        mMaterial = oldMaterial[f];
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int before = face[(i + face.size() - 1) % face.size()];
            const int after = face[(i + 1) % face.size()];
            addFace({face[i], edges[edgeKey(face[i], after)].second, facePoint[f],
                     edges[edgeKey(before, face[i])].second});
        }
    }
}

std::vector<int> PolygonModel::addRing(int segments, const std::function<Vec3(int)> &at)
{
    std::vector<int> ring;
    for (int i = 0; i < segments; ++i)
        ring.push_back(addPoint(at(i)));
    return ring;
}

void PolygonModel::addBand(const std::vector<int> &lower, const std::vector<int> &upper)
{
    const std::size_t n = std::max(lower.size(), upper.size());
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        if (lower.size() == 1)
            addFace({lower[0], upper[j], upper[i]});
        else if (upper.size() == 1)
            addFace({lower[i], lower[j], upper[0]});
        else
            addFace({lower[i], lower[j], upper[j], upper[i]});
    }
}

std::pair<std::vector<int>, std::vector<int>>
PolygonModel::addWalls(const Frame &frame, const std::vector<Vec2> &profile, double height, double bevel)
{
    const int n = static_cast<int>(profile.size());
    // Offsetting every side inwards by the bevel keeps profiles simple as long as the bevel is small.
    const auto inset = [&](int i) -> Vec2 {
        const Vec2 before = (profile[i] - profile[(i + n - 1) % n]).normalized();
        const Vec2 after = (profile[(i + 1) % n] - profile[i]).normalized();
        const Vec2 inwards(-before.y() - after.y(), before.x() + after.x());
        return profile[i] + bevel * 2 / inwards.squaredNorm() * inwards;
    };
    const auto ring = [&](bool inner, double z) {
        return addRing(n, [&](int i) {
            const Vec2 p = inner ? inset(i) : profile[i];
            return frame.at(p.x(), p.y(), z);
        });
    };
    std::vector<std::vector<int>> rings;
    if (bevel > 0)
        rings = {ring(true, 0), ring(false, bevel), ring(false, height - bevel), ring(true, height)};
    else
        rings = {ring(false, 0), ring(false, height)};
    for (std::size_t i = 0; i + 1 < rings.size(); ++i)
        addBand(rings[i], rings[i + 1]);
    return {rings.front(), rings.back()};
}

void PolygonModel::addPrism(const Frame &frame, const std::vector<Vec2> &profile, double height, double bevel)
{
    const auto [bottom, top] = addWalls(frame, profile, height, bevel);
    addFace({bottom.rbegin(), bottom.rend()});
    addFace(top);
}

void PolygonModel::addGear(const Frame &frame, int teeth, double inner, double outer, double height,
                           double bevel)
{
    std::vector<Vec2> profile;
    for (int i = 0; i < teeth; ++i) {
        static constexpr double place[] = {0.0, 0.18, 0.42, 0.60};
        for (int k = 0; k < 4; ++k) {
            const double angle = 2 * std::numbers::pi * (i + place[k]) / teeth;
            const double radius = k == 1 || k == 2 ? outer : inner;
            profile.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
    }
    auto [bottom, top] = addWalls(frame, profile, height, bevel);
    std::reverse(bottom.begin(), bottom.end());
    for (const std::vector<int> &ring : {bottom, top}) {
        std::vector<int> disk;
        for (std::size_t i = 0; i < ring.size(); i += 4) {
            addFace({ring[i], ring[i + 1], ring[i + 2], ring[i + 3]});
            disk.push_back(ring[i]);
            disk.push_back(ring[i + 3]);
        }
        addFace(std::move(disk));
    }
}

void PolygonModel::addLathe(const Frame &frame, const std::vector<Vec2> &profile, int segments)
{
    std::vector<std::vector<int>> rings;
    for (const Vec2 &p : profile) {
        rings.push_back(addRing(p.x() > 0 ? segments : 1, [&](int i) {
            const double angle = 2 * std::numbers::pi * i / segments;
            return frame.at(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
        }));
    }
    for (std::size_t i = 0; i + 1 < rings.size(); ++i)
        addBand(rings[i], rings[i + 1]);
    if (rings.front().size() > 1)
        addFace({rings.front().rbegin(), rings.front().rend()});
    if (rings.back().size() > 1)
        addFace(rings.back());
}

void PolygonModel::addTube(const std::vector<Vec3> &path, double radius, int segments)
{
    std::vector<int> before;
    Frame frame = frameAlong(path[0], path[1] - path[0]);
    for (std::size_t k = 0; k < path.size(); ++k) {
        const Vec3 in = (path[k] - path[k == 0 ? 0 : k - 1]).stableNormalized();
        const Vec3 out = (path[std::min(k + 1, path.size() - 1)] - path[k]).stableNormalized();
        // The smallest rotation of the last frame keeps the tube from twisting.
        const auto turn = Eigen::Quaterniond::FromTwoVectors(frame.z, in + out);
        frame = {path[k], turn * frame.x, turn * frame.y, turn * frame.z};
        const std::vector<int> ring = addRing(segments, [&](int i) {
            const double angle = 2 * std::numbers::pi * i / segments;
            return frame.at(radius * std::cos(angle), radius * std::sin(angle), 0);
        });
        if (k == 0)
            addFace({ring.rbegin(), ring.rend()});
        else
            addBand(before, ring);
        before = ring;
    }
    addFace(before);
}

Scene PolygonModel::toScene() const
{
    PositionMatrix positions(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        positions.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    std::vector<int> start{0}, corners;
    for (const auto &face : faces) {
        corners.insert(corners.end(), face.begin(), face.end());
        start.push_back(static_cast<int>(corners.size()));
    }
    Scene scene;
    scene.objectNames = mObjects;
    scene.materialNames = mMaterials;
    scene.faceMaterial = mFaceMaterial;
    scene.mesh = MeshData::build(std::move(positions), std::move(start), std::move(corners), mFaceObject);
    return scene;
}

} // namespace autocuts::samples
