#include "solver/straight/turning.h"

#include <cmath>
#include <numbers>

namespace autocuts::straight {

namespace {

// Numbers in this file without another source were chosen by hand.

//! Directions that are nearer than about this count as one.
constexpr double sameDirection = 4 * std::numbers::pi / 180;
//! Below this mean slope an island lies across a direction.
constexpr double leastRise = 0.1;
constexpr double quarter = std::numbers::pi / 2;

struct Direction
{
    double angle, weight;
};

std::vector<Direction> directionsOf(const Island &island, const std::vector<Chain> &chains)
{
    std::vector<Direction> directions;
    const auto add = [&](int from, int to) {
        const Vec2 along = island.position[to] - island.position[from];
        directions.push_back({std::atan2(along.y(), along.x()), along.norm()});
    };
    for (const Chain &chain : chains)
        add(chain.points.front(), chain.points.back());
    for (const Island::Loop &loop : island.loops) {
        for (std::size_t i = 0; i < loop.point.size() && chains.empty(); ++i)
            add(loop.point[i], loop.point[(i + 1) % loop.point.size()]);
    }
    return directions;
}

//! From one angle to another, modulo a right angle.
double between(double from, double to)
{
    return std::remainder(to - from, quarter);
}

} // namespace

double angleToAxes(const Island &island, const std::vector<Chain> &chains)
{
    const std::vector<Direction> directions = directionsOf(island, chains);
    // The direction that most others agree with, then the mean of these.
    double most = 0, best = 0;
    for (const Direction &middle : directions) {
        double agreeing = 0, offset = 0;
        for (const Direction &other : directions) {
            const double apart = between(middle.angle, other.angle) / sameDirection;
            const double weight = other.weight * std::exp(-apart * apart);
            agreeing += weight;
            offset += weight * apart * sameDirection;
        }
        if (agreeing > most) {
            most = agreeing;
            best = middle.angle + offset / agreeing;
        }
    }
    return between(best, 0);
}

double angleToUp(const Soup &soup, const Island &island, const Positions &positions, WorldUp up)
{
    const MeshData &mesh = *soup.mesh;
    const std::array<Vec3, 2> ups = up == WorldUp::Y ? std::array<Vec3, 2>{Vec3::UnitY(), -Vec3::UnitZ()}
                                                     : std::array<Vec3, 2>{Vec3::UnitZ(), Vec3::UnitY()};
    for (const Vec3 &direction : ups) {
        Vec2 sum = Vec2::Zero(); // of the direction, seen in the map
        double area = 0;
        for (std::size_t t = 0; t < island.triangles.size(); ++t) {
            const Soup::Basis &b = island.basis[t];
            const int first = 3 * island.triangles[t];
            Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();
            Vec2 slope = Vec2::Zero();
            for (int k = 0; k < 3; ++k) {
                const Vec2 weights(b[2 * k], b[2 * k + 1]);
                const double height =
                    soup.scale * direction.dot(mesh.cornerPosition(mesh.cornerOfSoup(first + k)) -
                                               mesh.cornerPosition(mesh.cornerOfSoup(first)));
                jacobian += positions[island.points[t][k]] * weights.transpose();
                slope += height * weights;
            }
            sum += island.weight[t] * (jacobian * slope);
            area += island.weight[t];
        }
        if (sum.norm() >= leastRise * area)
            return quarter - std::atan2(sum.y(), sum.x());
    }
    return 0;
}

void turn(Positions &positions, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    for (Vec2 &p : positions)
        p = Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
}

void turnQuarters(Positions &positions, int quarters)
{
    for (int i = 0; i < (quarters % 4 + 4) % 4; ++i) {
        for (Vec2 &p : positions)
            p = Vec2(-p.y(), p.x());
    }
}

} // namespace autocuts::straight
