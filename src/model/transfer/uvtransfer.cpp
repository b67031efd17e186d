#include "model/transfer/uvtransfer.h"

#include "model/plain/uvlayout.h"
#include "model/plain/uvseams.h"
#include "model/transfer/facematch.h"

#include <algorithm>

namespace autocuts::transfer {

namespace {

bool faceHasUvs(const MeshData &mesh, const UvMatrix &uv, int face)
{
    return uv.middleRows(mesh.faceStart[face], mesh.faceStart[face + 1] - mesh.faceStart[face]).allFinite();
}

//! Copies the UVs of equal faces. \returns per face of the mesh: it has no equal
std::vector<bool> copyEqual(const UvTransferInput &input, const FaceMatch &match, UvTransfer &result)
{
    std::vector<bool> without(static_cast<std::size_t>(input.mesh.faceCount()), true);
    for (int f = 0; f < input.source.faceCount(); ++f) {
        if (match.face[f] < 0)
            continue;
        without[match.face[f]] = false;
        for (int c = input.source.faceStart[f]; c < input.source.faceStart[f + 1]; ++c)
            result.uv.row(match.corner[c]) = input.sourceUv.row(c);
        result.figures.copied += faceHasUvs(input.source, input.sourceUv, f);
    }
    return without;
}

bool isApart(const UvTransfer &result, const PositionUvs &found)
{
    const auto placed = static_cast<int>(std::count(found.placed.begin(), found.placed.end(), true));
    return transfer::isApart(result.figures.copied + placed, result.figures.faces);
}

void placeRest(const UvTransferInput &input, const std::vector<bool> &wanted, const TransferControl &control,
               UvTransfer &result)
{
    const Frame frame = frameOf(input.source);
    const SourceSurface surface(input.source, input.sourceUv, frame);
    PositionUvs found = takeByPosition(surface, input.mesh, frame, result.uv, wanted, control);
    if (!found.stopped && isApart(result, found) && input.mayMove) {
        Frame moved = frame;
        moved.origin = frameOf(input.mesh).origin;
        PositionUvs other = takeByPosition(surface, input.mesh, moved, result.uv, wanted, control);
        if (other.stopped || (!isApart(result, other) && other.meanOfAll <= farShare)) {
            found = std::move(other);
            result.figures.moved = true;
        }
    }
    TransferFigures &figures = result.figures;
    figures.meanShare = found.meanOfAll;
    if (found.stopped || isApart(result, found)) {
        result.status = found.stopped ? UvTransfer::Status::Stopped : UvTransfer::Status::Apart;
        result.uv = emptyLayout(input.mesh);
        figures.copied = 0;
        return;
    }
    result.uv = std::move(found.uv);
    figures.placed = static_cast<int>(std::count(found.placed.begin(), found.placed.end(), true));
    figures.meanDistance = found.meanDistance * frame.size;
    figures.maxDistance = found.maxDistance * frame.size;
    figures.turnedOver = found.turnedOver;
    figures.collapsed = found.collapsed;
}

} // namespace

void TransferFigures::add(const TransferFigures &other)
{
    const int sum = placed + other.placed;
    if (sum > 0)
        meanDistance = (placed * meanDistance + other.placed * other.meanDistance) / sum;
    maxDistance = std::max(maxDistance, other.maxDistance);
    meanShare = std::max(meanShare, other.meanShare);
    faces += other.faces;
    copied += other.copied;
    placed = sum;
    turnedOver += other.turnedOver;
    collapsed += other.collapsed;
    seamLength += other.seamLength;
    sourceSeamLength = other.sourceSeamLength;
    moved = moved || other.moved;
}

UvTransfer transferUvs(const UvTransferInput &input, const TransferControl &control)
{
    UvTransfer result;
    result.uv = emptyLayout(input.mesh);
    result.figures.faces = input.mesh.faceCount();
    bool any = false;
    for (int t = 0; t < input.source.triangleCount() && !any; ++t)
        any = hasUvs(input.source, input.sourceUv, t);
    if (!any) {
        result.status = UvTransfer::Status::NoUvs;
        return result;
    }
    const FaceMatch match = input.match == UvMatch::Position ? matchFacesInPlace(input.source, input.mesh)
                                                             : matchFaces(input.source, input.mesh);
    const std::vector<bool> wanted = copyEqual(input, match, result);
    const bool rest = std::find(wanted.begin(), wanted.end(), true) != wanted.end();
    if (rest && input.match == UvMatch::Topology) {
        result.uv = emptyLayout(input.mesh);
        result.figures.copied = 0;
        result.status = UvTransfer::Status::OtherPolygons;
    } else if (control.isStopped())
        result.status = UvTransfer::Status::Stopped;
    else if (rest)
        placeRest(input, wanted, control, result);
    if (result.status == UvTransfer::Status::Done) {
        result.figures.seamLength = seamLength(input.mesh, result.uv);
        result.figures.sourceSeamLength = seamLength(input.source, input.sourceUv);
    }
    return result;
}

UvTransfer transferAnywhere(const UvTransferInput &input, const TransferControl &control,
                            Placement &placement)
{
    UvTransfer made = transferUvs(input, control);
    if (made.status != UvTransfer::Status::Apart)
        return made;
    for (const Placement &likely : likelyPlacements(input.source, input.mesh)) {
        const std::shared_ptr<const MeshData> source = placed(input.source, likely);
        UvTransfer there =
            transferUvs({*source, input.sourceUv, input.mesh, input.match, input.mayMove}, control);
        if (there.status != UvTransfer::Status::Apart) {
            placement = likely;
            return there;
        }
    }
    return made;
}

double seamLength(const MeshData &mesh, const UvMatrix &uv)
{
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    double length = 0;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        if ((open[2 * e] || open[2 * e + 1]) && hasUvs(mesh, uv, pair.triangle[0]) &&
            hasUvs(mesh, uv, pair.triangle[1]))
            length += pair.length;
    }
    return length;
}

} // namespace autocuts::transfer
