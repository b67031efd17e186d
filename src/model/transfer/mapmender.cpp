#include "model/transfer/mapmender.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace autocuts::transfer {

namespace {

// Chosen by hand, on the models of the tests.
constexpr double collapsedShare = 1e-3; // of the area that a triangle would have in the source
constexpr double noArea = 1e-14;        // twice the area of a triangle on the model, in the frame
constexpr double worse = 4;             // times the source's distortion, and so much more, is too much
constexpr double turnedOverEnergy = 1e5;
constexpr int rounds = 24;
constexpr int narrowRounds = 8; // in which only the corners of bad triangles move, not those around them
constexpr std::array<double, 3> steps{0.5, 0.2, 0.05}; // times the length of the sides around
constexpr int directions = 8;

struct Shape
{
    double area = 0, uvArea = 0; //!< twice
    double lengths = 0;          //!< half of the sum of cot * UV length squared: the Dirichlet energy
};

Shape shapeOf(const TransferredMap &map, int triangle)
{
    const auto &corners = map.mesh.triangles[triangle];
    std::array<Vec3, 3> p;
    std::array<Vec2, 3> u;
    for (int k = 0; k < 3; ++k) {
        p[k] = map.position(corners[k]);
        u[k] = map.uv.row(corners[k]);
    }
    Shape shape;
    shape.area = (p[1] - p[0]).cross(p[2] - p[0]).norm();
    shape.uvArea = cross2(u[0], u[1], u[2]);
    for (int k = 0; k < 3; ++k) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        shape.lengths += 0.5 * (p[a] - p[k]).dot(p[b] - p[k]) * (u[b] - u[a]).squaredNorm();
    }
    return shape;
}

//! The symmetric Dirichlet energy in units of the source's scale; turnedOverEnergy and more for triangles
//! that are turned over.
double energyOf(const Shape &shape, double areaRatio)
{
    const double scale = std::abs(areaRatio) * shape.area; // twice the area in the map, if it is kept
    const double share = shape.uvArea * (areaRatio < 0 ? -1 : 1) / scale;
    // The squares of the singular values sum up to 2 * lengths / area^2.
    const double squares = 2 * shape.lengths / (shape.area * scale);
    if (!(share > 1e-6))
        return turnedOverEnergy * (1 - std::max(share, -1e6)) + std::min(squares, turnedOverEnergy);
    return std::min(squares * (1 + 1 / (share * share)), turnedOverEnergy);
}

bool isJudged(const TransferredMap &map, int face, const Shape &shape)
{
    return map.placed[face] && map.shape[face].areaRatio != 0 && shape.area > noArea;
}

//! One pass after the other over the triangles that are too bad.
class Mender
{
public:
    Mender(TransferredMap &map, const std::function<bool()> &stopped) : mMap(map), mStopped(stopped) {}

    void run()
    {
        std::vector<int> bad;
        for (int t = 0; t < mMap.mesh.triangleCount(); ++t) {
            if (isTooBad(t))
                bad.push_back(t);
        }
        for (int round = 0; round < rounds && !bad.empty(); ++round) {
            bool moved = false;
            for (int root : cornersOf(bad, round >= narrowRounds)) {
                if (mStopped && mStopped())
                    return;
                moved = moveCorner(root) || moved;
            }
            if (!moved && round >= narrowRounds)
                return;
            std::erase_if(bad, [&](int t) { return !isTooBad(t); });
        }
    }

private:
    bool isTooBad(int triangle) const
    {
        const int face = mMap.mesh.triangleFace[triangle];
        const Shape shape = shapeOf(mMap, triangle);
        return isJudged(mMap, face, shape) &&
               energyOf(shape, mMap.shape[face].areaRatio) > worse * (mMap.shape[face].energy + 1);
    }

    //! The energy of the faces around, by area.
    double energyAround(int root) const
    {
        double sum = 0;
        for (int c : mMap.at[root]) {
            const int face = mMap.faceOf(c);
            for (int t : mMap.mesh.trianglesOf(face)) {
                const Shape shape = shapeOf(mMap, t);
                if (isJudged(mMap, face, shape))
                    sum += shape.area * energyOf(shape, mMap.shape[face].areaRatio);
            }
        }
        return sum;
    }

    //! The corners of triangles, or also those of the faces around them, each by its root, ascending.
    std::vector<int> cornersOf(const std::vector<int> &triangles, bool around) const
    {
        std::set<int> roots;
        for (int t : triangles) {
            for (int corner : mMap.mesh.triangles[t])
                roots.insert(mMap.root[corner]);
        }
        const std::vector<int> own(roots.begin(), roots.end());
        for (std::size_t i = 0; i < own.size() && around; ++i) {
            for (int corner : mMap.at[own[i]]) {
                const int face = mMap.faceOf(corner);
                for (int c = mMap.mesh.faceStart[face]; c < mMap.mesh.faceStart[face + 1]; ++c)
                    roots.insert(mMap.root[c]);
            }
        }
        return {roots.begin(), roots.end()};
    }

    //! The mean of the neighbours' UVs. \param length becomes the mean distance to them
    Vec2 middleOfNeighbours(int root, double &length) const
    {
        Vec2 sum = Vec2::Zero();
        length = 0;
        for (int c : mMap.at[root]) {
            const int face = mMap.faceOf(c);
            const int first = mMap.mesh.faceStart[face], end = mMap.mesh.faceStart[face + 1];
            for (int neighbour : {c + 1 < end ? c + 1 : first, c > first ? c - 1 : end - 1}) {
                sum += mMap.uv.row(neighbour);
                length += (mMap.uv.row(neighbour) - mMap.uv.row(root)).norm();
            }
        }
        const double count = 2 * static_cast<double>(mMap.at[root].size());
        length /= count;
        return sum / count;
    }

    void setUv(int root, const Vec2 &uv)
    {
        for (int c : mMap.at[root])
            mMap.uv.row(c) = uv;
    }

    bool moveCorner(int root)
    {
        const std::vector<int> &corners = mMap.at[root];
        if (std::any_of(corners.begin(), corners.end(), [&](int c) { return !mMap.placed[mMap.faceOf(c)]; }))
            return false; // a face that keeps its UVs has this corner too
        const Vec2 before = mMap.uv.row(root), past = mMap.continued.row(root);
        double length = 0;
        const Vec2 middle = middleOfNeighbours(root, length);
        Vec2 best = before;
        double bestEnergy = energyAround(root) * (1 - 1e-6);
        const auto tryAt = [&](const Vec2 &there) {
            setUv(root, there);
            if (const double energy = energyAround(root); energy < bestEnergy) {
                bestEnergy = energy;
                best = there;
            }
        };
        for (const double share : {1.0, 0.5, 0.25}) {
            tryAt(before + share * (past - before));
            tryAt(before + share * (middle - before));
        }
        const Vec2 from = best;
        for (const double step : steps) {
            for (int i = 0; i < directions; ++i) {
                const double angle = 2 * std::numbers::pi * i / directions;
                tryAt(from + step * length * Vec2(std::cos(angle), std::sin(angle)));
            }
        }
        setUv(root, best);
        return best != before;
    }

    TransferredMap &mMap;
    const std::function<bool()> &mStopped;
};

} // namespace

int TransferredMap::faceOf(int corner) const
{
    const auto after = std::upper_bound(mesh.faceStart.begin(), mesh.faceStart.end(), corner);
    return static_cast<int>(after - mesh.faceStart.begin()) - 1;
}

Fault faultOf(const TransferredMap &map, int triangle)
{
    const int face = map.mesh.triangleFace[triangle];
    const Shape shape = shapeOf(map, triangle);
    if (!isJudged(map, face, shape))
        return Fault::None;
    const double share = shape.uvArea / (map.shape[face].areaRatio * shape.area);
    if (share < -collapsedShare)
        return Fault::TurnedOver;
    return share < collapsedShare ? Fault::Collapsed : Fault::None;
}

void mendMap(TransferredMap &map, const std::function<bool()> &stopped)
{
    Mender(map, stopped).run();
}

} // namespace autocuts::transfer
