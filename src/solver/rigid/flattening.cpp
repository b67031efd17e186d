#include "solver/rigid/flattening.h"

#include "solver/base/cornerat.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>

namespace autocuts::rigid {

namespace {

constexpr int rounds = 12; // of turning the triangles and solving for the points; chosen by hand
//! Bounds on cotangents, so that obtuse and thin triangles keep the system definite.
constexpr double leastCotangent = 1e-3, mostCotangent = 1e3;

class Flattening
{
public:
    Flattening(const Soup &soup, const CutMesh &state, const std::vector<int> &triangles)
        : mSoup(soup), mState(state), mTriangles(triangles)
    {
        for (const int t : triangles) {
            for (int k = 0; k < 3; ++k)
                mPoints.push_back(state.uvVertex[3 * t + k]);
        }
        std::sort(mPoints.begin(), mPoints.end());
        mPoints.erase(std::unique(mPoints.begin(), mPoints.end()), mPoints.end());
    }

    void run(std::vector<double> &x)
    {
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> system(laplacian());
        if (system.info() != Eigen::Success)
            return;
        const Vec2 fixed = cornerAt(x, 3 * mTriangles.front());
        for (int round = 0; round < rounds; ++round) {
            const Eigen::MatrixX2d position = system.solve(turnedSides(x, fixed));
            for (const int t : mTriangles) {
                for (int k = 0; k < 3; ++k)
                    cornerAt(x, 3 * t + k) = position.row(pointOf(3 * t + k)).transpose();
            }
        }
    }

private:
    int pointOf(int corner) const
    {
        return static_cast<int>(std::lower_bound(mPoints.begin(), mPoints.end(), mState.uvVertex[corner]) -
                                mPoints.begin());
    }

    Vec2 rest(int t, int k) const { return cornerAt(mSoup.restShape[t], k % 3); }

    //! Cotangent of the angle opposite to side k.
    double cotangent(int t, int k) const
    {
        const Vec2 a = rest(t, k) - rest(t, k + 2), b = rest(t, k + 1) - rest(t, k + 2);
        const double area = a.x() * b.y() - a.y() * b.x();
        return area > 0 ? std::clamp(a.dot(b) / area, leastCotangent, mostCotangent) : leastCotangent;
    }

    //! The Laplacian of the part, with its first point held.
    Eigen::SparseMatrix<double> laplacian() const
    {
        std::vector<Eigen::Triplet<double>> entries;
        for (const int t : mTriangles) {
            for (int k = 0; k < 3; ++k) {
                const int a = pointOf(3 * t + k), b = pointOf(3 * t + (k + 1) % 3);
                const double weight = cotangent(t, k);
                entries.emplace_back(a, a, weight);
                entries.emplace_back(b, b, weight);
                entries.emplace_back(a, b, -weight);
                entries.emplace_back(b, a, -weight);
            }
        }
        entries.emplace_back(held(), held(), 1);
        const auto count = static_cast<Eigen::Index>(mPoints.size());
        Eigen::SparseMatrix<double> result(count, count);
        result.setFromTriplets(entries.begin(), entries.end());
        return result;
    }

    int held() const { return pointOf(3 * mTriangles.front()); }

    //! The right side: the sides of the triangles, each triangle turned as in the map.
    Eigen::MatrixX2d turnedSides(const std::vector<double> &x, const Vec2 &fixed) const
    {
        Eigen::MatrixX2d sum = Eigen::MatrixX2d::Zero(static_cast<Eigen::Index>(mPoints.size()), 2);
        for (const int t : mTriangles) {
            std::array<double, 3> weight{};
            double cosine = 0, sine = 0;
            for (int k = 0; k < 3; ++k) {
                weight[k] = cotangent(t, k);
                const Vec2 side = rest(t, k + 1) - rest(t, k);
                const Vec2 now = cornerAt(x, 3 * t + (k + 1) % 3) - cornerAt(x, 3 * t + k);
                cosine += weight[k] * side.dot(now);
                sine += weight[k] * (side.x() * now.y() - side.y() * now.x());
            }
            const double length = std::hypot(cosine, sine);
            if (!(length > 0))
                continue;
            for (int k = 0; k < 3; ++k) {
                const Vec2 side = rest(t, k + 1) - rest(t, k);
                const Vec2 turned =
                    Vec2(cosine * side.x() - sine * side.y(), sine * side.x() + cosine * side.y()) / length;
                sum.row(pointOf(3 * t + (k + 1) % 3)) += weight[k] * turned.transpose();
                sum.row(pointOf(3 * t + k)) -= weight[k] * turned.transpose();
            }
        }
        sum.row(held()) += fixed.transpose();
        return sum;
    }

    const Soup &mSoup;
    const CutMesh &mState;
    const std::vector<int> &mTriangles;
    std::vector<int> mPoints; //!< UV vertices of the part, in ascending order
};

} // namespace

void flatten(const Soup &soup, const CutMesh &state, const std::vector<int> &triangles,
             std::vector<double> &x)
{
    Flattening(soup, state, triangles).run(x);
}

} // namespace autocuts::rigid
