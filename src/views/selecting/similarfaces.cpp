#include "views/selecting/similarfaces.h"

#include "model/document/document.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <set>

namespace autocuts {

namespace {

// Chosen by hand.
constexpr double largestAreaFactor = 1.1;
constexpr double largestAngle = 10 * std::numbers::pi / 180;

double areaOf(const MeshData &mesh, int face)
{
    double area = 0;
    for (const int t : mesh.trianglesOf(face))
        area += mesh.triangleArea[t];
    return area;
}

//! The direction of a face; zero when it has no area.
Vec3 normalOf(const MeshData &mesh, int face)
{
    Vec3 sum = Vec3::Zero();
    for (const int t : mesh.trianglesOf(face)) {
        const Vec3 a = mesh.cornerPosition(mesh.triangles[t][0]);
        const Vec3 b = mesh.cornerPosition(mesh.triangles[t][1]);
        const Vec3 c = mesh.cornerPosition(mesh.triangles[t][2]);
        const Vec3 across = (b - a).stableNormalized().cross((c - a).stableNormalized());
        sum += mesh.triangleArea[t] * across.stableNormalized();
    }
    return sum.stableNormalized();
}

//! Areas of faces, to be compared with others.
class Areas
{
public:
    Areas(const MeshData &mesh, const QList<int> &faces) : mMesh(mesh)
    {
        for (int face : faces)
            mAreas.push_back(areaOf(mesh, face));
        std::sort(mAreas.begin(), mAreas.end());
    }

    bool areLike(int face) const
    {
        const double area = areaOf(mMesh, face);
        const auto least = std::lower_bound(mAreas.begin(), mAreas.end(), area / largestAreaFactor);
        return least != mAreas.end() && *least <= area * largestAreaFactor;
    }

private:
    const MeshData &mMesh;
    std::vector<double> mAreas; //!< ascending
};

//! Normals of faces in cells, so that only near ones are compared.
class Normals
{
public:
    Normals(const MeshData &mesh, const QList<int> &faces) : mMesh(mesh)
    {
        std::set<Cell> seen; // normals that are almost the same are kept once
        for (int face : faces) {
            const Vec3 normal = normalOf(mesh, face);
            if (seen.insert(cellOf(normal, fine)).second)
                mCells[cellOf(normal, coarse)].push_back(normal);
        }
    }

    bool areLike(int face) const
    {
        const Vec3 normal = normalOf(mMesh, face);
        const Cell middle = cellOf(normal, coarse);
        for (int i = 0; i < 27; ++i) {
            const auto found =
                mCells.find({middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1});
            if (found != mCells.end() &&
                std::any_of(found->second.begin(), found->second.end(),
                            [&](const Vec3 &other) { return (normal - other).norm() <= coarse; }))
                return true;
        }
        return false;
    }

private:
    using Cell = std::array<int, 3>;
    //! The distance between unit vectors at the largest angle, and a part of it that makes no difference.
    static inline const double coarse = 2 * std::sin(largestAngle / 2), fine = coarse / 64;

    static Cell cellOf(const Vec3 &normal, double size)
    {
        const auto at = [&](int axis) { return static_cast<int>(std::floor(normal[axis] / size)); };
        return {at(0), at(1), at(2)};
    }

    const MeshData &mMesh;
    std::map<Cell, std::vector<Vec3>> mCells;
};

//! The faces with a number that one of the given faces has, too.
template <typename NumberOf>
QList<int> withNumbersOf(int faceCount, const QList<int> &faces, NumberOf numberOf)
{
    std::set<int> numbers;
    for (int face : faces)
        numbers.insert(numberOf(face));
    QList<int> result;
    for (int face = 0; face < faceCount; ++face) {
        if (numbers.count(numberOf(face)) > 0)
            result.append(face);
    }
    return result;
}

//! The faces that are like the given ones, and these: rounding must not leave one of them out.
template <class Figures>
QList<int> withFiguresLike(const MeshData &mesh, const QList<int> &faces)
{
    const Figures figures(mesh, faces);
    QList<int> alike;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        if (figures.areLike(face))
            alike.append(face);
    }
    QList<int> result;
    std::set_union(alike.begin(), alike.end(), faces.begin(), faces.end(), std::back_inserter(result));
    return result;
}

} // namespace

QList<int> similarFaces(const Document &document, const QList<int> &faces, FaceLikeness likeness)
{
    const MeshData &mesh = document.mesh();
    const std::vector<int> &materials = document.state().scene.faceMaterial;
    switch (likeness) {
    case FaceLikeness::Area:
        return withFiguresLike<Areas>(mesh, faces);
    case FaceLikeness::Normal:
        return withFiguresLike<Normals>(mesh, faces);
    case FaceLikeness::Material:
        return withNumbersOf(mesh.faceCount(), faces, [&](int face) {
            return materials.empty() ? -1 : materials[static_cast<std::size_t>(face)];
        });
    case FaceLikeness::Corners:
        return withNumbersOf(mesh.faceCount(), faces,
                             [&](int face) { return mesh.faceStart[face + 1] - mesh.faceStart[face]; });
    }
    return faces;
}

} // namespace autocuts
