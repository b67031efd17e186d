#include "solver/straight/upright.h"

#include "solver/base/cutmesh.h"
#include "solver/straight/turning.h"

#include <array>
#include <cmath>
#include <numbers>

namespace autocuts::straight {

namespace {

constexpr double rightAngle = std::numbers::pi / 2;
//! Directions that a right angle is divided into, to find the one of most of a border.
constexpr int directionCount = 90;
//! Share of its border that runs in one direction and across it where an island has straight borders. Round
//! ones have .06, those of boxes 1; in between chosen by hand.
constexpr double straightShare = 0.15;

//! What most of a border runs along, modulo a right angle.
struct MainDirection
{
    double angle = 0; //!< radians
    double share = 0; //!< of the length of the border within one and a half steps of it
};

MainDirection mainDirection(const Island &island)
{
    constexpr double step = rightAngle / directionCount;
    struct Sides
    {
        double length = 0, offset = 0; // of their angles from the middle of the step, times length
    };
    std::array<Sides, directionCount> sides;
    double all = 0;
    for (const Island::Loop &loop : island.loops) {
        for (std::size_t i = 0; i < loop.point.size(); ++i) {
            const Vec2 side =
                island.position[loop.point[(i + 1) % loop.point.size()]] - island.position[loop.point[i]];
            const double angle = std::atan2(side.y(), side.x());
            const double steps = std::round(angle / step);
            Sides &own = sides[(static_cast<int>(steps) + 4 * directionCount) % directionCount];
            own.length += side.norm();
            own.offset += side.norm() * (angle - step * steps);
            all += side.norm();
        }
    }
    MainDirection best;
    for (int i = 0; i < directionCount && all > 0; ++i) {
        const Sides &left = sides[(i + directionCount - 1) % directionCount];
        const Sides &right = sides[(i + 1) % directionCount];
        const double length = left.length + sides[i].length + right.length;
        if (length > best.share * all) {
            const double offset = left.offset + sides[i].offset + right.offset;
            best = {step * i + (offset + step * (right.length - left.length)) / length, length / all};
        }
    }
    return best;
}

//! The positions of an island that stands upright.
Positions upright(const Soup &soup, const Island &island, WorldUp up)
{
    Positions positions = island.position;
    const MainDirection main = mainDirection(island);
    const bool isStraight = main.share >= straightShare;
    if (isStraight)
        turn(positions, -main.angle);
    const double angle = angleToUp(soup, island, positions, up);
    if (isStraight)
        turnQuarters(positions, static_cast<int>(std::lround(angle / rightAngle)));
    else
        turn(positions, angle);
    return positions;
}

} // namespace

SeamedMap turnedUpright(const Soup &soup, const SeamedMap &map, WorldUp up)
{
    SeamedMap turned = map;
    for (const Island &island : islandsOf(soup, CutMesh(*soup.mesh, map.cut), map.x)) {
        const Positions positions = upright(soup, island, up);
        // Rounding may turn over a triangle that is very thin.
        if (std::isfinite(island.energy(positions)))
            store(island, positions, turned.x);
    }
    return turned;
}

} // namespace autocuts::straight
