#include "model/editing/newfaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace autocuts {

namespace {

//! Faces whose area in the map is so many times too large or too small, by the density of the map, are laid
//! anew. Chosen by hand.
constexpr double mostStretch = 8;
//! Cosine of the angle up to which neighbours are laid together.
constexpr double sameDirection = 0.9;
//! Of lengths, below which shapes only touch.
constexpr double touching = 1e-7;

using Triangle2 = std::array<Vec2, 3>;

double crossOf(const Vec2 &a, const Vec2 &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

double areaOf(const Triangle2 &t)
{
    return 0.5 * crossOf(t[1] - t[0], t[2] - t[0]);
}

//! True when a side of the first triangle has all of the second one outside.
bool isApartFrom(const Triangle2 &a, const Triangle2 &b, double slack)
{
    const double sign = areaOf(a) < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 side = a[(k + 1) % 3] - a[k];
        const double length = side.norm();
        if (std::ranges::all_of(
                b, [&](const Vec2 &p) { return sign * crossOf(side, p - a[k]) <= slack * length; }))
            return true;
    }
    return false;
}

class RoomFinder
{
public:
    RoomFinder(const MeshData &mesh, UvMatrix &uv, const std::vector<bool> &among)
        : mMesh(mesh), mUv(uv), mAmong(among), mMoves(among.size(), false)
    {}

    int run()
    {
        measure();
        findBad();
        findOverlaps();
        return lay();
    }

private:
    Triangle2 triangle(int t) const
    {
        Triangle2 result;
        for (std::size_t k = 0; k < 3; ++k)
            result[k] = mUv.row(mMesh.triangles[t][k]);
        return result;
    }
    bool hasUv(int t) const
    {
        return std::ranges::all_of(mMesh.triangles[t], [this](int c) { return mUv.row(c).allFinite(); });
    }

    //! The density and size of the map of the other faces; where these have none, of all.
    void measure()
    {
        const auto counts = [this](int t, bool all) {
            return hasUv(t) && (all || !mAmong[mMesh.triangleFace[t]]);
        };
        bool all = true;
        for (int t = 0; t < mMesh.triangleCount(); ++t)
            all = all && !counts(t, false);
        double uvArea = 0, area = 0;
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            if (!counts(t, all))
                continue;
            uvArea += std::abs(areaOf(triangle(t)));
            area += mMesh.triangleArea[t];
            for (const Vec2 &p : triangle(t))
                mBox.extend(p);
        }
        if (uvArea > 0 && area > 0)
            mScale = std::sqrt(uvArea / area);
        if (mBox.isEmpty())
            mBox = {Vec2(0, 0), Vec2(1, 1)};
    }

    void findBad()
    {
        for (int t = 0; t < mMesh.triangleCount(); ++t) {
            const int face = mMesh.triangleFace[t];
            if (!mAmong[face] || mMesh.triangleDegenerate[t])
                continue;
            const double wanted = mScale * mScale * mMesh.triangleArea[t];
            const double ratio = hasUv(t) ? areaOf(triangle(t)) / wanted : 0;
            mMoves[face] = mMoves[face] || !(ratio > 1 / mostStretch && ratio < mostStretch);
        }
    }

    //! Of two faces that lie on each other the new one moves, of two new ones the later.
    void findOverlaps()
    {
        const double cell = std::max(mBox.diagonal().norm() / 256, 1e-300);
        const double slack = touching * mBox.diagonal().norm();
        std::map<std::array<int, 2>, std::vector<int>> cells;
        const auto visit = [&](int t, const auto &use) {
            Eigen::AlignedBox2d box;
            for (const Vec2 &p : triangle(t))
                box.extend(p);
            const auto index = [&](double x) {
                return static_cast<int>(std::clamp(std::floor(x / cell), -1e6, 1e6));
            };
            for (int x = index(box.min().x()); x <= index(box.max().x()); ++x) {
                for (int y = index(box.min().y()); y <= index(box.max().y()); ++y)
                    use(cells[{x, y}]);
            }
        };
        for (const bool isNew : {false, true}) {
            for (int t = 0; t < mMesh.triangleCount(); ++t) {
                const int face = mMesh.triangleFace[t];
                if (!hasUv(t) || mAmong[face] != isNew || mMoves[face])
                    continue;
                const Triangle2 own = triangle(t);
                bool lies = false;
                if (isNew) {
                    visit(t, [&](const std::vector<int> &others) {
                        for (const int other : others) {
                            const Triangle2 theirs = triangle(other);
                            lies = lies ||
                                   (mMesh.triangleFace[other] != face && !mMoves[mMesh.triangleFace[other]] &&
                                    !isApartFrom(own, theirs, slack) && !isApartFrom(theirs, own, slack));
                        }
                    });
                }
                mMoves[face] = lies;
                if (!lies)
                    visit(t, [t](std::vector<int> &others) { others.push_back(t); });
            }
        }
    }

    Vec3 normalOf(int face) const
    {
        Vec3 normal = Vec3::Zero();
        for (const int t : mMesh.trianglesOf(face)) {
            const Vec3 a = mMesh.cornerPosition(mMesh.triangles[t][0]);
            normal += (mMesh.cornerPosition(mMesh.triangles[t][1]) - a)
                          .cross(mMesh.cornerPosition(mMesh.triangles[t][2]) - a);
        }
        return normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitZ());
    }

    //! Faces that are laid together: a first one and its neighbours of nearly its direction.
    std::vector<std::vector<int>> pieces() const
    {
        std::vector<std::vector<int>> neighbours(mMoves.size());
        for (const EdgePair &pair : mMesh.edgePairs) {
            const int a = mMesh.triangleFace[pair.triangle[0]], b = mMesh.triangleFace[pair.triangle[1]];
            if (a != b && mMoves[a] && mMoves[b]) {
                neighbours[a].push_back(b);
                neighbours[b].push_back(a);
            }
        }
        std::vector<std::vector<int>> result;
        std::vector<bool> taken(mMoves.size(), false);
        for (int first = 0; first < mMesh.faceCount(); ++first) {
            if (!mMoves[first] || taken[first])
                continue;
            const Vec3 normal = normalOf(first);
            std::vector<int> piece{first};
            taken[first] = true;
            for (std::size_t i = 0; i < piece.size(); ++i) {
                for (const int next : neighbours[piece[i]]) {
                    if (!taken[next] && normalOf(next).dot(normal) > sameDirection) {
                        taken[next] = true;
                        piece.push_back(next);
                    }
                }
            }
            result.push_back(std::move(piece));
        }
        return result;
    }

    //! Projects a piece to the plane of its first face. \returns its box
    Eigen::AlignedBox2d flatten(const std::vector<int> &piece)
    {
        const Vec3 normal = normalOf(piece.front());
        const Vec3 right =
            (std::abs(normal.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX()).cross(normal).normalized();
        const Vec3 up = normal.cross(right);
        Eigen::AlignedBox2d box;
        for (const int face : piece) {
            for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c) {
                const Vec3 p = mScale * mMesh.cornerPosition(c);
                mUv.row(c) << right.dot(p), up.dot(p);
                box.extend(Vec2(mUv.row(c)));
            }
        }
        return box;
    }

    //! Puts the pieces into rows beside the map.
    int lay()
    {
        const double gap = 0.01 * mBox.diagonal().norm();
        std::vector<std::pair<std::vector<int>, Eigen::AlignedBox2d>> flat;
        double area = 0;
        for (std::vector<int> &piece : pieces()) {
            const Eigen::AlignedBox2d box = flatten(piece);
            area += (box.sizes().x() + gap) * (box.sizes().y() + gap);
            flat.emplace_back(std::move(piece), box);
        }
        std::ranges::stable_sort(flat, std::greater(),
                                 [](const auto &entry) { return entry.second.sizes().y(); });
        const double width = std::max(std::sqrt(area), mBox.sizes().x() / 4);
        const double left = std::max(mBox.max().x(), 1.0) + gap;
        Vec2 at(left, mBox.min().y());
        double height = 0;
        int moved = 0;
        for (const auto &[piece, box] : flat) {
            if (at.x() > left && at.x() + box.sizes().x() > left + width) {
                at = Vec2(left, at.y() + height + gap);
                height = 0;
            }
            for (const int face : piece) {
                for (int c = mMesh.faceStart[face]; c < mMesh.faceStart[face + 1]; ++c)
                    mUv.row(c) += (at - box.min()).transpose();
            }
            at.x() += box.sizes().x() + gap;
            height = std::max(height, box.sizes().y());
            moved += static_cast<int>(piece.size());
        }
        return moved;
    }

    const MeshData &mMesh;
    UvMatrix &mUv;
    const std::vector<bool> &mAmong;
    std::vector<bool> mMoves; //!< per face
    Eigen::AlignedBox2d mBox;
    double mScale = 1; //!< UV length per length
};

} // namespace

int layBeside(const MeshData &mesh, UvMatrix &uv, const std::vector<bool> &among)
{
    return RoomFinder(mesh, uv, among).run();
}

} // namespace autocuts
