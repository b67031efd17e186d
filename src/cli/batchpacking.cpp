#include "cli/batchpacking.h"

#include "model/document/rigidpieces.h"
#include "solver/packing/packmap.h"

#include <algorithm>

namespace autocuts {

namespace {

//! Effort of packing, in seconds, when a stop was requested.
constexpr double hurriedPackEffort = 0.1;

} // namespace

Result<Done> BatchPacking::pack(const MeshData &mesh, const ChartMap &charts, UvMatrix &uv)
{
    packing::PackOptions settings = mOptions.unwrap.packing;
    std::vector<bool> movable;
    if (!mOptions.intoRectangle.isEmpty()) {
        const LayoutRectangle *rectangle = mFiles.rectangle(mOptions.intoRectangle);
        if (!rectangle)
            return Error{
                QStringLiteral("there is no rectangle \"%1\" in the session").arg(mOptions.intoRectangle),
                mOptions.input, 0,
                QStringLiteral("Give --into the name of one, or its sides: --into 0,0,0.5,1")};
        settings.lower = rectangle->lower;
        settings.upper = rectangle->upper;
        // The islands of the rectangle; all when nothing is assigned to it.
        if (!rectangle->faces.isEmpty()) {
            movable.assign(mesh.faceCount(), false);
            for (int face : rectangle->faces)
                movable[face] = true;
        }
    }
    const RigidPieces rigid = rigidPieces(charts, mFiles.marks(mesh), movable);
    packing::PackResult packed =
        packMap(mesh, rigid.pieces, rigid.locked, settings, uv, &mStop.stop, [this](double done) {
            mProgress.show(QStringLiteral("packing %1 %").arg(100 * done, 0, 'f', 0));
        });
    if (!packed.complete && mStop.stop) {
        settings.effort = std::min(settings.effort, hurriedPackEffort);
        packed = packMap(mesh, rigid.pieces, rigid.locked, settings, uv);
    }
    if (!packed.complete)
        return noRoom();
    return Done{};
}

Error BatchPacking::noRoom() const
{
    if (mOptions.unwrap.packing.keepScale)
        return {QStringLiteral("the islands do not fit at their size"), mOptions.input, 0,
                QStringLiteral("Leave --keep-scale out or use a smaller --margin")};
    return {QStringLiteral("there is no room for the margins between the islands"), mOptions.input, 0,
            QStringLiteral("Use a smaller --margin or a larger --texture-size")};
}

} // namespace autocuts
