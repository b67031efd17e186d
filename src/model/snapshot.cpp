#include "model/snapshot.h"

#include <cmath>
#include <numbers>

namespace autocuts {

double Snapshot::scale() const
{
    return std::sqrt(std::numbers::pi / mesh->area);
}

} // namespace autocuts
