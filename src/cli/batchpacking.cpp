#include "cli/batchpacking.h"

namespace autocuts {

Result<unwrap::PackJob> batchPacking(const CliOptions &options, const BatchFiles &files,
                                     const Snapshot &snapshot)
{
    unwrap::PackJob pack = unwrap::steeredPackJob(snapshot, options.unwrap.packing);
    pack.hurry = unwrap::PackHurry::WhenStopped;
    if (options.hasRectangle()) {
        // In units of the file, in which a tile is 1 high.
        const Vec2 tile(1, options.unwrap.packing.tileHeight());
        pack.packInto({options.unwrap.packing.lower.cwiseProduct(tile),
                       options.unwrap.packing.upper.cwiseProduct(tile)});
    }
    if (!options.intoRectangle.isEmpty()) {
        const LayoutRectangle *rectangle = files.rectangle(options.intoRectangle);
        if (!rectangle)
            return Error{
                QStringLiteral("there is no rectangle \"%1\" in the session").arg(options.intoRectangle),
                options.input, 0,
                QStringLiteral("Give --into the name of one, or its sides: --into 0,0,0.5,1")};
        pack.packInto({rectangle->lower, rectangle->upper});
        // Only the islands assigned to the rectangle are packed; all islands when none is assigned.
        if (!rectangle->faces.isEmpty()) {
            pack.movable.assign(snapshot.mesh->faceCount(), false);
            for (int face : rectangle->faces)
                pack.movable[face] = true;
        }
    }
    return pack;
}

Error noRoomError(const CliOptions &options)
{
    if (options.unwrap.packing.keepScale)
        return {QStringLiteral("the islands do not fit at their size"), options.input, 0,
                QStringLiteral("Leave --keep-scale out or use a smaller --margin")};
    return {QStringLiteral("there is no room for the margins between the islands"), options.input, 0,
            QStringLiteral("Use a smaller --margin or a larger --texture-size")};
}

} // namespace autocuts
