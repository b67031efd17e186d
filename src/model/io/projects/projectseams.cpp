#include "model/io/projects/projectseams.h"

#include "model/io/projects/packedarrays.h"
#include "model/plain/polygonsides.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

QCborMap seamsToCbor(const Seams &seams, const MeshData &mesh)
{
    std::vector<int> sides;
    QByteArray states;
    std::vector<double> weights;
    QByteArray straight;
    for (int p = 0; p < static_cast<int>(mesh.edgePairs.size()); ++p) {
        const auto isPlain = [&](int pair) {
            return seams.states[pair] == PairState::Free && seams.weights[pair] == unpaintedWeight &&
                   seams.straight[pair] == 0;
        };
        if (mesh.edgePairs[p].diagonal || (isPlain(2 * p) && isPlain(2 * p + 1)))
            continue;
        const SidePair side = sidePair(mesh, p);
        for (int i = 0; i < 2; ++i) {
            sides.push_back(side.startCorner[i]);
            states.append(static_cast<char>(seams.states[side.cornerPair[i]]));
            weights.push_back(seams.weights[side.cornerPair[i]]);
            straight.append(static_cast<char>(seams.straight[side.cornerPair[i]]));
        }
    }
    return {{"sides"_L1, packedArray(sides)},
            {"states"_L1, states},
            {"weights"_L1, packedArray(weights)},
            {"straight"_L1, straight}};
}

bool readSeams(CborReader &reader, const MeshData &mesh, Seams &seams, int &lost)
{
    const QByteArray states = reader.bytes("states"_L1);
    const auto sides = unpackedIntegers(reader.bytes("sides"_L1), states.size());
    const auto weights = unpackedDoubles(reader.bytes("weights"_L1), states.size());
    // Older files have none.
    const QByteArray straight =
        reader.contains("straight"_L1) ? reader.bytes("straight"_L1) : QByteArray(states.size(), 0);
    if (reader.failed() || !sides || !weights || states.size() % 2 != 0 || straight.size() != states.size())
        return false;
    Seams result = seams;
    const std::vector<int> pairs = edgePairsBySide(mesh);
    lost = 0;
    for (std::size_t i = 0; i < sides->size(); i += 2) {
        const int corner = (*sides)[i];
        const int pair = corner >= 0 && corner < mesh.cornerCount() ? pairs[corner] : -1;
        const SidePair side = pair < 0 ? SidePair{{-1, -1}, {0, 0}} : sidePair(mesh, pair);
        if (side.startCorner[0] != corner || side.startCorner[1] != (*sides)[i + 1]) {
            ++lost;
            continue;
        }
        for (std::size_t k = 0; k < 2; ++k) {
            result.states[side.cornerPair[k]] = static_cast<PairState>(states[static_cast<int>(i + k)]);
            result.weights[side.cornerPair[k]] = (*weights)[i + k];
            result.straight[side.cornerPair[k]] =
                static_cast<std::uint8_t>(straight[static_cast<int>(i + k)]);
        }
    }
    if (!result.validate(mesh).isEmpty())
        return false;
    seams = std::move(result);
    return true;
}

} // namespace autocuts
