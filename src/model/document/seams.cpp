#include "model/document/seams.h"

namespace autocuts {

Seams Seams::allFree(const MeshData &mesh)
{
    Seams seams;
    seams.states.assign(mesh.cornerPairCount(), PairState::Free);
    seams.weights.assign(mesh.cornerPairCount(), unpaintedWeight);
    seams.straight.assign(mesh.cornerPairCount(), 0);
    return seams;
}

QString Seams::validate(const MeshData &mesh) const
{
    const std::size_t count = mesh.cornerPairCount();
    if (states.size() != count || weights.size() != count || straight.size() != count)
        return QStringLiteral("The seams do not fit the mesh");
    for (std::size_t i = 0; i < count; ++i) {
        if (states[i] > PairState::Joined)
            return QStringLiteral("Corner pair %1 has an unknown state").arg(i);
        if (!(weights[i] >= 0 && weights[i] <= maxPaintedWeight))
            return QStringLiteral("The weight of corner pair %1 is out of range").arg(i);
        if (straight[i] > 1 || straight[i] != straight[i ^ 1])
            return QStringLiteral("Corner pair %1 is kept straight at one end only").arg(i);
        if (mesh.edgePairs[i / 2].diagonal &&
            (states[i] != PairState::Free || weights[i] != unpaintedWeight || straight[i] != 0))
            return QStringLiteral("Corner pair %1 lies inside a polygon but is steered").arg(i);
    }
    return {};
}

} // namespace autocuts
