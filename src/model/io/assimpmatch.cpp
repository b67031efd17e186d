#include "model/io/assimpmatch.h"

#include <algorithm>
#include <limits>

namespace autocuts {

namespace {

//! Positions that are so close, relative to the size of the model, are the same: Assimp calculates in single
//! precision. Chosen by hand.
constexpr double tolerance = 1e-5;

int cornersOf(const MeshData &mesh, int face)
{
    return mesh.faceStart[face + 1] - mesh.faceStart[face];
}

//! How many corners the face of b starts later than that of a; -1 when they are not the same face.
int rotationBetween(const MeshData &a, int faceA, const MeshData &b, int faceB, double allowed)
{
    const int n = cornersOf(a, faceA);
    if (cornersOf(b, faceB) != n)
        return -1;
    int best = -1;
    double least = allowed;
    for (int shift = 0; shift < n; ++shift) {
        double farthest = 0;
        for (int k = 0; k < n && farthest <= least; ++k)
            farthest = std::max(farthest, (a.cornerPosition(a.faceStart[faceA] + (k + shift) % n) -
                                           b.cornerPosition(b.faceStart[faceB] + k))
                                              .norm());
        if (farthest < least || (best < 0 && farthest <= least)) {
            least = farthest;
            best = shift;
        }
    }
    return best;
}

bool hasNoArea(const MeshData &mesh, int face)
{
    for (const int t : mesh.trianglesOf(face)) {
        if (!mesh.triangleDegenerate[static_cast<std::size_t>(t)])
            return false;
    }
    return true;
}

//! The corner of `from` for each corner of `to`, -1 for faces that `from` does not have; empty when the faces
//! do not correspond.
std::vector<int> matchedCorners(const MeshData &from, const MeshData &to)
{
    const double size =
        from.report.boxDiagonal + (from.positions.size() ? from.positions.cwiseAbs().maxCoeff() : 0);
    std::vector<int> corners(static_cast<std::size_t>(to.cornerCount()), -1);
    int face = 0;
    for (int g = 0; g < to.faceCount(); ++g) {
        const int shift = face < from.faceCount() ? rotationBetween(from, face, to, g, tolerance * size) : -1;
        if (shift < 0) {
            if (!hasNoArea(to, g))
                return {};
            continue;
        }
        const int n = cornersOf(from, face);
        for (int k = 0; k < n; ++k)
            corners[static_cast<std::size_t>(to.faceStart[g] + k)] = from.faceStart[face] + (k + shift) % n;
        ++face;
    }
    if (face < from.faceCount())
        return {};
    return corners;
}

} // namespace

std::optional<Scene> withUvsOf(const Scene &scene, Scene assimp)
{
    const std::vector<int> corners = matchedCorners(*scene.mesh, *assimp.mesh);
    if (corners.empty())
        return {};
    assimp.path = scene.path;
    assimp.format = scene.format;
    assimp.uvSets.clear();
    for (const UvSet &set : scene.uvSets) {
        UvMatrix uv =
            UvMatrix::Constant(assimp.mesh->cornerCount(), 2, std::numeric_limits<double>::quiet_NaN());
        for (std::size_t c = 0; c < corners.size(); ++c) {
            if (corners[c] >= 0)
                uv.row(static_cast<Eigen::Index>(c)) = set.uv.row(corners[c]);
        }
        assimp.uvSets.push_back({set.name, std::move(uv)});
    }
    return assimp;
}

} // namespace autocuts
