#include "views/control/editing/brushstroke.h"

#include <algorithm>

namespace autocuts {

namespace {

std::vector<bool> heldCorners(const Document &document)
{
    const MeshData &mesh = document.mesh();
    std::vector<bool> held(mesh.cornerCount(), false);
    for (const UvPin &pin : document.constraints().pins)
        held[pin.corner] = true;
    for (int face : document.state().hiddenFaces)
        std::fill(held.begin() + mesh.faceStart[face], held.begin() + mesh.faceStart[face + 1], true);
    const Islands &islands = document.islands();
    for (int island = 0; island < islands.count(); ++island) {
        if (document.marks().flagsOf(islands.faces(island)).locked == 0)
            continue;
        for (int corner : islands.corners(mesh, {island}))
            held[corner] = true;
    }
    return held;
}

} // namespace

BrushStroke::BrushStroke(Document &document, UvEdit edit)
    : mDocument(document), mEdit(edit), mGesture(document.undoStack().newGesture()),
      mBrush(document.weightedMesh(), document.uv(), heldCorners(document), document.marks().faceFlags)
{}

std::unique_ptr<SetUvs> BrushStroke::command() const
{
    auto command = std::make_unique<SetUvs>(mDocument, mEdit, mBrush.uv());
    command->setGesture(mGesture);
    return command;
}

} // namespace autocuts
