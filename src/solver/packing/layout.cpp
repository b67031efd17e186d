#include "solver/packing/layout.h"

namespace autocuts::packing {

double PackProblem::smallBoxAngle(int island) const
{
    if (turnsFreely(island))
        return outlines[island].boxAngle;
    double best = angleOf(island, 0), least = rotatedBox(outlines[island].hull, best).prod();
    for (int k = 1; 4 * k < directions(island); ++k) {
        const double area = rotatedBox(outlines[island].hull, angleOf(island, k)).prod();
        if (area < least) {
            least = area;
            best = angleOf(island, k);
        }
    }
    return best;
}

} // namespace autocuts::packing
