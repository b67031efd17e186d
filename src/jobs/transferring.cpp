#include "jobs/transferring.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>
#include <set>

namespace autocuts::jobs {

using namespace Qt::Literals::StringLiterals;
using transfer::UvTransfer;

namespace {

struct TransferTexts
{
    Q_DECLARE_TR_FUNCTIONS(Transfer)
};

//! A mesh, or a part of it, with its map.
struct Piece
{
    std::shared_ptr<const MeshData> mesh;
    UvMatrix uv;
    std::vector<int> corner; //!< of the whole mesh; empty: it is the whole

    int wholeCorner(int c) const { return corner.empty() ? c : corner[c]; }
};

//! Vertices of a part are numbered in the order of its corners, so that copies of an object have equal
//! numbers. \param faces at least one
Piece pieceOf(const std::shared_ptr<const MeshData> &mesh, const UvMatrix &uv, const std::vector<bool> &faces)
{
    if (std::find(faces.begin(), faces.end(), false) == faces.end())
        return {mesh, uv, {}};
    Piece piece;
    std::vector<int> numberOf(static_cast<std::size_t>(mesh->vertexCount()), -1), vertices;
    std::vector<int> faceStart{0}, cornerVertex, faceObject;
    for (int f = 0; f < mesh->faceCount(); ++f) {
        if (!faces[f])
            continue;
        for (int c = mesh->faceStart[f]; c < mesh->faceStart[f + 1]; ++c) {
            int &number = numberOf[mesh->cornerVertex[c]];
            if (number < 0) {
                number = static_cast<int>(vertices.size());
                vertices.push_back(mesh->cornerVertex[c]);
            }
            cornerVertex.push_back(number);
            piece.corner.push_back(c);
        }
        faceStart.push_back(static_cast<int>(cornerVertex.size()));
        faceObject.push_back(mesh->faceObject[f]);
    }
    const PositionMatrix positions = mesh->positions(vertices, Eigen::all);
    piece.uv = uv(piece.corner, Eigen::all);
    piece.mesh =
        MeshData::build(positions, std::move(faceStart), std::move(cornerVertex), std::move(faceObject));
    return piece;
}

bool hasAny(const std::vector<bool> &faces)
{
    return std::find(faces.begin(), faces.end(), true) != faces.end();
}

std::vector<bool> facesOfObject(const MeshData &mesh, int object, std::vector<bool> among)
{
    for (int f = 0; f < mesh.faceCount(); ++f)
        among[f] = among[f] && mesh.faceObject[f] == object;
    return among;
}

QString boxInWords(const MeshData &mesh)
{
    const transfer::Frame frame = transfer::frameOf(mesh);
    return TransferTexts::tr("centre %1, %2, %3, size %4")
        .arg(frame.origin.x(), 0, 'g', 4)
        .arg(frame.origin.y(), 0, 'g', 4)
        .arg(frame.origin.z(), 0, 'g', 4)
        .arg(frame.size, 0, 'g', 4);
}

Error errorOf(UvTransfer::Status status, const TransferJob &input, const MeshData &source,
              const MeshData &mesh)
{
    switch (status) {
    case UvTransfer::Status::NoUvs:
        return {TransferTexts::tr("there are no UVs to transfer"), input.sourceName, 0,
                TransferTexts::tr("Choose a source that has UVs")};
    case UvTransfer::Status::OtherPolygons:
        return {TransferTexts::tr("the polygons are not the same, faces of the source: %1, of the model: %2")
                    .arg(source.faceCount())
                    .arg(mesh.faceCount()),
                input.sourceName, 0, TransferTexts::tr("Match by position")};
    default:
        return {
            TransferTexts::tr("the models do not lie in one place: the source has its %1, the model its %2")
                .arg(boxInWords(source), boxInWords(mesh)),
            input.sourceName, 0, TransferTexts::tr("Save both at the same place, in the same units")};
    }
}

//! Where a part of a job's progress goes.
transfer::TransferControl partOfControl(const transfer::TransferControl &control, std::size_t index,
                                        std::size_t count)
{
    transfer::TransferControl part = control;
    if (control.progress)
        part.progress = [&control, index, count](double fraction) {
            control.progress((double(index) + fraction) / double(count));
        };
    return part;
}

//! The faces that get UVs.
std::vector<bool> wantedFaces(const TransferJob &input)
{
    return input.faces.empty() ? std::vector<bool>(static_cast<std::size_t>(input.mesh->faceCount()), true)
                               : input.faces;
}

//! The objects that get UVs, each by itself; -1: all at once.
std::vector<int> targetObjects(const TransferJob &input)
{
    const std::vector<bool> wanted = wantedFaces(input);
    if (input.sourceObject < 0)
        return hasAny(wanted) ? std::vector<int>{-1} : std::vector<int>();
    std::set<int> objects;
    for (int f = 0; f < input.mesh->faceCount(); ++f) {
        if (wanted[f])
            objects.insert(input.mesh->faceObject[f]);
    }
    if (input.source == input.mesh)
        objects.erase(input.sourceObject);
    return {objects.begin(), objects.end()};
}

void findUnmatched(const MeshData &mesh, const Piece &piece, const UvTransfer &made, TransferredUvs &result)
{
    for (int f = 0; f < piece.mesh->faceCount(); ++f) {
        const int first = piece.mesh->faceStart[f], count = piece.mesh->faceStart[f + 1] - first;
        if (made.uv.middleRows(first, count).allFinite()) {
            for (int c = first; c < first + count; ++c)
                result.uv.row(piece.wholeCorner(c)) = made.uv.row(c);
            continue;
        }
        const auto after =
            std::upper_bound(mesh.faceStart.begin(), mesh.faceStart.end(), piece.wholeCorner(first));
        result.unmatched << static_cast<int>(after - mesh.faceStart.begin()) - 1;
    }
}

} // namespace

void keepLocked(TransferJob &job, const std::vector<IslandFlags> &faceFlags)
{
    const auto locked = [](const IslandFlags &flags) { return flags.locked != 0; };
    if (std::none_of(faceFlags.begin(), faceFlags.end(), locked))
        return;
    job.faces = wantedFaces(job);
    for (std::size_t f = 0; f < faceFlags.size(); ++f)
        job.faces[f] = job.faces[f] && !locked(faceFlags[f]);
}

Result<TransferredUvs> runTransfer(const TransferJob &input, const transfer::TransferControl &control)
{
    TransferredUvs result;
    result.uv = input.uv;
    std::vector<bool> sourceFaces(static_cast<std::size_t>(input.source->faceCount()), true);
    if (input.sourceObject >= 0)
        sourceFaces = facesOfObject(*input.source, input.sourceObject, std::move(sourceFaces));
    if (!hasAny(sourceFaces))
        return errorOf(UvTransfer::Status::NoUvs, input, *input.source, *input.mesh);
    const Piece source = pieceOf(input.source, input.sourceUv, sourceFaces);
    const std::vector<int> objects = targetObjects(input);
    if (objects.empty())
        return Error{TransferTexts::tr("no face is to get UVs"), input.sourceName, 0,
                     TransferTexts::tr("Choose another part of the model, or unlock its islands")};
    std::optional<Error> problem; // of an object that was not matched
    for (std::size_t i = 0; i < objects.size(); ++i) {
        std::vector<bool> faces = wantedFaces(input);
        if (objects[i] >= 0)
            faces = facesOfObject(*input.mesh, objects[i], std::move(faces));
        const Piece piece = pieceOf(input.mesh, input.uv, faces);
        const transfer::TransferControl part = partOfControl(control, i, objects.size());
        const transfer::UvTransferInput pair{*source.mesh, source.uv, *piece.mesh, input.match,
                                             input.sourceObject >= 0};
        UvTransfer made =
            pair.mayMove ? transferUvs(pair, part) : transferAnywhere(pair, part, result.placement);
        if (made.status == UvTransfer::Status::Stopped) {
            result.stopped = true;
            return result;
        }
        if (made.status != UvTransfer::Status::Done && !problem)
            problem = errorOf(made.status, input, *source.mesh, *piece.mesh);
        findUnmatched(*input.mesh, piece, made, result);
        result.figures.add(made.figures);
    }
    if (problem && result.figures.copied + result.figures.placed == 0)
        return *problem;
    std::sort(result.unmatched.begin(), result.unmatched.end());
    return result;
}

QString TransferredUvs::summary() const
{
    QStringList parts;
    if (figures.copied > 0)
        parts << TransferTexts::tr("%1 of %2 faces are the same").arg(figures.copied).arg(figures.faces);
    if (figures.placed > 0)
        parts << TransferTexts::tr("%1 of %2 faces matched by position, mean distance %3, largest %4")
                     .arg(figures.placed)
                     .arg(figures.faces)
                     .arg(figures.meanDistance, 0, 'g', 3)
                     .arg(figures.maxDistance, 0, 'g', 3);
    // As a share: the models may have other units than the figures of maps elsewhere.
    if (figures.sourceSeamLength > 0)
        parts << TransferTexts::tr("the seams are %1 times as long as in the source")
                     .arg(figures.seamLength / figures.sourceSeamLength, 0, 'f', 2);
    return parts.join(u"; "_s);
}

QStringList TransferredUvs::warnings() const
{
    QStringList lines;
    if (placement.scale != 1)
        lines << TransferTexts::tr("the source has other units: it was taken %1 times as large")
                     .arg(placement.scale, 0, 'g', 4);
    if (placement.turn != 0)
        lines << TransferTexts::tr("the source has another axis up: it was turned to match");
    if (figures.unmatched() > 0)
        lines << TransferTexts::tr("%1 of %2 faces are too far from the source, or it has no UVs there: they "
                                   "keep what they had")
                     .arg(figures.unmatched())
                     .arg(figures.faces);
    if (figures.moved)
        lines << TransferTexts::tr("the source lies elsewhere: it was moved onto the model to match it");
    if (figures.meanShare > transfer::farShare)
        lines << TransferTexts::tr(
                     "the surfaces are %1 % of the model's size apart: are both in the same place and pose?")
                     .arg(100 * figures.meanShare, 0, 'f', 1);
    if (figures.turnedOver > 0)
        lines << TransferTexts::tr(
                     "triangles turned over in the map: %1; Finish mends them, but lays the map out anew")
                     .arg(figures.turnedOver);
    if (figures.collapsed > 0)
        lines << TransferTexts::tr("triangles with hardly any area in the map: %1; Finish mends them, but "
                                   "lays the map out anew")
                     .arg(figures.collapsed);
    return lines;
}

} // namespace autocuts::jobs
