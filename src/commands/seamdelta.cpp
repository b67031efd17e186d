#include "commands/seamdelta.h"

#include "model/plain/polygonsides.h"

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

XorDelta failed(CborReader &reader, int elementSize)
{
    reader.fail();
    return XorDelta(elementSize);
}

} // namespace

void writeSeamDelta(QCborMap &map, const XorDelta &delta, const MeshData &mesh)
{
    std::vector<int> sides;
    delta.indices().forEach([&](int pair) { sides.push_back(sideOfCornerPair(mesh, pair)); });
    QCborMap content;
    delta.renumbered(sides).write(content);
    map["sides"_L1] = content;
}

XorDelta readSeamDelta(CborReader &reader, int elementSize, const Document &document)
{
    const MeshData &mesh = document.mesh();
    if (!reader.contains("sides"_L1)) {
        if (!hasNumbersOfVersion1(mesh))
            return failed(reader, elementSize);
        return XorDelta::read(reader, elementSize, mesh.cornerPairCount());
    }
    CborReader content(reader.map("sides"_L1));
    const XorDelta delta = XorDelta::read(content, elementSize, mesh.cornerCount());
    if (reader.failed() || content.failed())
        return failed(reader, elementSize);
    std::vector<int> pairs;
    bool fits = true;
    delta.indices().forEach([&](int corner) {
        const int edge = document.adjacency().edgeOfCorner(corner);
        fits = fits && edge >= 0 && edge < static_cast<int>(mesh.edgePairs.size());
        if (fits)
            pairs.push_back(cornerPairOfSide(mesh, edge, corner));
    });
    return fits ? delta.renumbered(pairs) : failed(reader, elementSize);
}

} // namespace autocuts
