#include "views/selecting/similarfaces.h"

#include "model/document/document.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <vector>

namespace autocuts {

namespace {

// Chosen by hand.
constexpr double largestAreaFactor = 1.1;
constexpr double largestSideFactor = 1.1;
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

double areaInMap(const Document &document, int face)
{
    const UvMatrix &uv = document.uv();
    double area = 0;
    for (const int t : document.mesh().trianglesOf(face)) {
        const auto &[a, b, c] = document.mesh().triangles[t];
        const Vec2 u = uv.row(b) - uv.row(a), v = uv.row(c) - uv.row(a);
        area += std::abs(u.x() * v.y() - u.y() * v.x()) / 2;
    }
    return area;
}

//! Areas of faces, to be compared with others.
template <bool inMap>
class Areas
{
public:
    Areas(const Document &document, const QList<int> &faces) : mDocument(document)
    {
        for (int face : faces) {
            if (const double area = of(face); std::isfinite(area))
                mAreas.push_back(area);
        }
        std::sort(mAreas.begin(), mAreas.end());
    }

    bool areLike(int face) const
    {
        const double area = of(face);
        const auto least = std::lower_bound(mAreas.begin(), mAreas.end(), area / largestAreaFactor);
        return least != mAreas.end() && *least <= area * largestAreaFactor;
    }

private:
    double of(int face) const { return inMap ? areaInMap(mDocument, face) : areaOf(mDocument.mesh(), face); }

    const Document &mDocument;
    std::vector<double> mAreas; //!< ascending
};

//! Shapes of faces, those of about the same longest and shortest side in one cell.
class Shapes
{
public:
    Shapes(const Document &document, const QList<int> &faces) : mMesh(document.mesh())
    {
        for (int face : faces) {
            const Shape shape = shapeOf(face);
            std::vector<Shape> &known = mCells[cellOf(shape)];
            if (std::ranges::find(known, shape) == known.end())
                known.push_back(shape);
        }
    }

    bool areLike(int face) const
    {
        const Shape shape = shapeOf(face);
        const Cell middle = cellOf(shape);
        for (int i = 0; i < 9; ++i) {
            const auto found = mCells.find({middle[0], middle[1] + i % 3 - 1, middle[2] + i / 3 - 1});
            if (found != mCells.end() &&
                std::ranges::any_of(found->second, [&](const Shape &other) { return fits(shape, other); }))
                return true;
        }
        return false;
    }

private:
    //! A corner: the share of the next side in the length of all sides, and the angle.
    using Shape = std::vector<std::array<double, 2>>;
    using Cell = std::array<int, 3>;

    Shape shapeOf(int face) const
    {
        const int first = mMesh.faceStart[face], count = mMesh.faceStart[face + 1] - first;
        const auto at = [&](int corner) { return mMesh.cornerPosition(first + (corner + count) % count); };
        double whole = 0;
        for (int k = 0; k < count; ++k)
            whole += (at(k + 1) - at(k)).norm();
        Shape shape;
        for (int k = 0; k < count; ++k) {
            const Vec3 next = at(k + 1) - at(k), before = at(k - 1) - at(k);
            shape.push_back({whole > 0 ? next.norm() / whole : 0,
                             std::atan2(next.cross(before).norm(), next.dot(before))});
        }
        return shape;
    }

    static Cell cellOf(const Shape &shape)
    {
        const auto [least, most] =
            std::ranges::minmax(shape, {}, [](const auto &corner) { return corner[0]; });
        constexpr double tiny = 1e-6;
        const auto cell = [](double share) {
            return static_cast<int>(std::floor(std::log(share + tiny) / std::log(largestSideFactor)));
        };
        return {static_cast<int>(shape.size()), cell(least[0]), cell(most[0])};
    }

    static bool fits(const Shape &a, const Shape &b)
    {
        const int count = static_cast<int>(a.size());
        for (int shift = 0; shift < count; ++shift) {
            if (fitsAt(a, b, shift, false) || fitsAt(a, b, shift, true))
                return true;
        }
        return false;
    }

    //! True when corner k of the one is corner shift + k, or mirrored shift - k, of the other.
    static bool fitsAt(const Shape &a, const Shape &b, int shift, bool mirrored)
    {
        const int count = static_cast<int>(a.size());
        for (int k = 0; k < count; ++k) {
            const int corner = (mirrored ? shift - k + count : shift + k) % count;
            const int side = mirrored ? (corner + count - 1) % count : corner;
            const double one = a[k][0], other = b[side][0];
            if (std::abs(a[k][1] - b[corner][1]) > largestAngle ||
                std::max(one, other) > largestSideFactor * std::min(one, other))
                return false;
        }
        return true;
    }

    const MeshData &mMesh;
    std::map<Cell, std::vector<Shape>> mCells;
};

//! Normals of faces in cells, so that only near ones are compared.
class Normals
{
public:
    Normals(const Document &document, const QList<int> &faces) : mMesh(document.mesh())
    {
        std::set<Cell> seen; // normals that are almost the same are kept once
        for (int face : faces) {
            const Vec3 normal = normalOf(mMesh, face);
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
QList<int> withFiguresLike(const Document &document, const QList<int> &faces)
{
    const Figures figures(document, faces);
    QList<int> alike;
    for (int face = 0; face < document.mesh().faceCount(); ++face) {
        if (!std::binary_search(faces.begin(), faces.end(), face) && figures.areLike(face))
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
        return withFiguresLike<Areas<false>>(document, faces);
    case FaceLikeness::AreaInMap:
        return withFiguresLike<Areas<true>>(document, faces);
    case FaceLikeness::Shape:
        return withFiguresLike<Shapes>(document, faces);
    case FaceLikeness::Normal:
        return withFiguresLike<Normals>(document, faces);
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
