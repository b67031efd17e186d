#include "solver/straight/islandmirror.h"

#include "model/plain/meshpart.h"
#include "solver/base/rigidfit.h"
#include "solver/preference/meshsymmetry.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace autocuts::straight {

namespace {

//! Finds the images of faces, corners and points.
class MirrorFinder
{
public:
    MirrorFinder(const MeshData &mesh, const std::vector<Island> &islands)
        : mMesh(mesh), mIslands(islands), mIslandOf(mesh.faceCount(), -1), mPointOf(mesh.cornerCount(), -1)
    {
        for (std::size_t i = 0; i < islands.size(); ++i) {
            for (std::size_t t = 0; t < islands[i].triangles.size(); ++t) {
                const int triangle = islands[i].triangles[t];
                mIslandOf[mesh.triangleFace[triangle]] = static_cast<int>(i);
                for (int k = 0; k < 3; ++k)
                    mPointOf[mesh.cornerOfSoup(3 * triangle + k)] = islands[i].points[t][k];
            }
        }
        for (int face = 0; face < mesh.faceCount(); ++face)
            mFaces.emplace(verticesOf(face), face);
    }

    std::vector<int> facesOf(int island) const
    {
        std::vector<int> faces;
        for (const int t : mIslands[island].triangles)
            faces.push_back(mMesh.triangleFace[t]);
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        return faces;
    }

    //! \param image per vertex, see MeshSymmetry::mirrorVertex
    IslandMirror mirrorOf(int island, const std::vector<int> &image) const
    {
        IslandMirror mirror;
        mirror.points.assign(mIslands[island].pointCount(), -1);
        for (const int face : facesOf(island)) {
            const int other = imageOf(face, image);
            if (other < 0 || (mirror.island >= 0 && mIslandOf[other] != mirror.island))
                return {};
            mirror.island = mIslandOf[other];
            if (!addCorners(face, other, image, mirror.points))
                return {};
        }
        if (!isBijective(mirror))
            return {};
        return mirror;
    }

private:
    //! The welded vertices of a face, ascending.
    std::vector<int> verticesOf(int face) const
    {
        std::vector<int> vertices;
        for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
            vertices.push_back(vertexOf(c));
        std::sort(vertices.begin(), vertices.end());
        return vertices;
    }

    int vertexOf(int corner) const { return mMesh.vertexWeld[mMesh.cornerVertex[corner]]; }

    int imageOf(int face, const std::vector<int> &image) const
    {
        std::vector<int> vertices = verticesOf(face);
        for (int &v : vertices)
            v = image[v];
        std::sort(vertices.begin(), vertices.end());
        const auto found = vertices.front() < 0 ? mFaces.end() : mFaces.find(vertices);
        return found == mFaces.end() ? -1 : found->second;
    }

    //! Enters the images of a face's points. \returns false when they contradict others, or the image has not
    //! the opposite winding
    bool addCorners(int face, int other, const std::vector<int> &image, MirrorPoints &points) const
    {
        const int first = mMesh.faceStart[face], count = mMesh.faceStart[face + 1] - first;
        const int firstOther = mMesh.faceStart[other];
        int start = 0;
        while (start < count && vertexOf(firstOther + start) != image[vertexOf(first)])
            ++start;
        for (int k = 0; k < count; ++k) {
            const int corner = firstOther + (start + count - k) % count;
            if (vertexOf(corner) != image[vertexOf(first + k)])
                return false;
            int &point = points[mPointOf[first + k]];
            if (point >= 0 && point != mPointOf[corner])
                return false;
            point = mPointOf[corner];
        }
        return true;
    }

    bool isBijective(const IslandMirror &mirror) const
    {
        std::vector<int> sorted = mirror.points;
        std::sort(sorted.begin(), sorted.end());
        return mirror.island >= 0 &&
               mIslands[mirror.island].pointCount() == static_cast<int>(sorted.size()) &&
               sorted.front() == 0 && std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    }

    const MeshData &mMesh;
    const std::vector<Island> &mIslands;
    std::vector<int> mIslandOf;             //!< per face
    std::vector<int> mPointOf;              //!< per corner: its point in its island
    std::map<std::vector<int>, int> mFaces; //!< by their vertices
};

//! The symmetry of some faces as one of the whole mesh: -1 for other vertices.
std::vector<int> imagesWithin(const MeshData &mesh, const std::vector<int> &faces, const JobContext &job)
{
    std::vector<bool> inside(mesh.faceCount(), false);
    for (const int face : faces)
        inside[face] = true;
    const MeshPart part = partOf(mesh, inside);
    std::vector<int> image(mesh.vertexCount(), -1);
    if (!(part.mesh->area > 0))
        return image;
    const std::optional<preference::MeshSymmetry> symmetry =
        preference::findSymmetry(*part.mesh, preference::Exactness::Exact, job);
    if (!symmetry)
        return image;
    std::vector<int> whole(part.mesh->vertexCount(), -1);
    for (int c = 0; c < part.mesh->cornerCount(); ++c)
        whole[part.mesh->vertexWeld[part.mesh->cornerVertex[c]]] =
            mesh.vertexWeld[mesh.cornerVertex[part.corner[c]]];
    for (std::size_t v = 0; v < whole.size(); ++v) {
        if (whole[v] >= 0 && symmetry->mirrorVertex[v] >= 0)
            image[whole[v]] = whole[symmetry->mirrorVertex[v]];
    }
    return image;
}

} // namespace

std::vector<IslandMirror> mirrorsOf(const MeshData &mesh, const std::vector<Island> &islands,
                                    const JobContext &job)
{
    const MirrorFinder finder(mesh, islands);
    const std::optional<preference::MeshSymmetry> symmetry =
        preference::findSymmetry(mesh, preference::Exactness::Exact, job);
    std::vector<IslandMirror> mirrors(islands.size());
    for (std::size_t i = 0; i < islands.size() && !job.stopped(); ++i) {
        const int island = static_cast<int>(i);
        if (symmetry)
            mirrors[i] = finder.mirrorOf(island, symmetry->mirrorVertex);
        if (mirrors[i].island < 0)
            mirrors[i] = finder.mirrorOf(island, imagesWithin(mesh, finder.facesOf(island), job));
    }
    return mirrors;
}

void placeAtAxis(Positions &positions, const MirrorPoints &mirror)
{
    std::vector<PointMatch> matches;
    for (std::size_t p = 0; p < positions.size(); ++p) {
        const Vec2 &image = positions[mirror[p]];
        matches.push_back({positions[p], Vec2(-image.x(), image.y())});
    }
    // Reflected at the axis u = 0 and turned by an angle, it lies on itself: its axis is turned by half of
    // that.
    const RigidMotion motion = fitRigid(matches);
    const double angle = -0.5 * std::atan2(motion.s, motion.c), c = std::cos(angle), s = std::sin(angle);
    double middle = 0;
    for (Vec2 &p : positions) {
        p = Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
        middle += p.x() / static_cast<double>(positions.size());
    }
    for (Vec2 &p : positions)
        p.x() -= middle;
}

} // namespace autocuts::straight
