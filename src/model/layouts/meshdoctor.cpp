#include "model/layouts/meshdoctor.h"

#include <QCoreApplication>

#include <algorithm>

namespace autocuts {

namespace {

QString translated(const char *text)
{
    return QCoreApplication::translate("MeshDoctor", text);
}

//! "1 thing" or "n things": the number with the singular or plural.
QString counted(int count, const char *one, const char *many)
{
    return QStringLiteral("%1 %2").arg(count).arg(translated(count == 1 ? one : many));
}

constexpr std::size_t mostNumbers = 10; // listed in one sentence

//! "face 3" or "faces 3, 8, 9, ...", counted from 1.
QString faceNumbers(const std::vector<int> &faces)
{
    QStringList numbers;
    for (std::size_t i = 0; i < std::min(faces.size(), mostNumbers); ++i)
        numbers << QString::number(faces[i] + 1);
    if (faces.size() > mostNumbers)
        numbers << QStringLiteral("...");
    return translated(faces.size() == 1 ? QT_TRANSLATE_NOOP("MeshDoctor", "face %1")
                                        : QT_TRANSLATE_NOOP("MeshDoctor", "faces %1"))
        .arg(numbers.join(QLatin1String(", ")));
}

} // namespace

QStringList meshDoctorNotes(const MeshReport &report)
{
    QStringList notes;
    const auto note = [&](int count, const char *one, const char *many, const char *done) {
        if (count > 0)
            notes << counted(count, one, many) + QStringLiteral(": ") + translated(done);
    };
    if (report.faces == 0)
        notes << QCoreApplication::translate("MeshDoctor", "No faces: there is nothing to unwrap");
    note(report.nonManifoldEdges, QT_TRANSLATE_NOOP("MeshDoctor", "non-manifold edge"),
         QT_TRANSLATE_NOOP("MeshDoctor", "non-manifold edges"),
         QT_TRANSLATE_NOOP(
             "MeshDoctor",
             "each face was joined to its best partner, the other sides are treated as boundary"));
    note(
        report.windingEdges, QT_TRANSLATE_NOOP("MeshDoctor", "edge between faces of opposite winding"),
        QT_TRANSLATE_NOOP("MeshDoctor", "edges between faces of opposite winding"),
        QT_TRANSLATE_NOOP(
            "MeshDoctor",
            "treated as boundary, because the two sides cannot be continued into each other without a flip"));
    note(report.degenerateTriangles, QT_TRANSLATE_NOOP("MeshDoctor", "triangle without area"),
         QT_TRANSLATE_NOOP("MeshDoctor", "triangles without area"),
         QT_TRANSLATE_NOOP("MeshDoctor", "kept, and given a thin stand-in shape so that it gets UVs"));
    note(report.duplicateFaces, QT_TRANSLATE_NOOP("MeshDoctor", "duplicated face"),
         QT_TRANSLATE_NOOP("MeshDoctor", "duplicated faces"),
         QT_TRANSLATE_NOOP("MeshDoctor", "kept, and unwrapped as a layer of its own"));
    note(report.concavePolygons, QT_TRANSLATE_NOOP("MeshDoctor", "polygon that is not convex"),
         QT_TRANSLATE_NOOP("MeshDoctor", "polygons that are not convex"),
         QT_TRANSLATE_NOOP("MeshDoctor",
                           "split into triangles along diagonals inside it; the polygon itself stays whole"));
    if (!report.selfContactFaces.empty()) {
        notes << QCoreApplication::translate("MeshDoctor",
                                             "%1 (%2): cut off from the faces around where it does so")
                     .arg(counted(static_cast<int>(report.selfContactFaces.size()),
                                  QT_TRANSLATE_NOOP("MeshDoctor", "polygon meets itself"),
                                  QT_TRANSLATE_NOOP("MeshDoctor", "polygons meet themselves")),
                          faceNumbers(report.selfContactFaces));
    }
    note(report.weldedVertices, QT_TRANSLATE_NOOP("MeshDoctor", "vertex at the place of another"),
         QT_TRANSLATE_NOOP("MeshDoctor", "vertices at the place of another"),
         QT_TRANSLATE_NOOP("MeshDoctor", "treated as joined, and kept apart in the saved file"));
    note(report.isolatedVertices, QT_TRANSLATE_NOOP("MeshDoctor", "vertex without a face"),
         QT_TRANSLATE_NOOP("MeshDoctor", "vertices without a face"),
         QT_TRANSLATE_NOOP("MeshDoctor", "kept in the saved file"));
    note(report.components > 1 ? report.components : 0, "", QT_TRANSLATE_NOOP("MeshDoctor", "separate parts"),
         QT_TRANSLATE_NOOP("MeshDoctor", "each gets islands of its own"));
    if (report.boxDiagonal > 0 && report.distanceFromOrigin > 1000 * report.boxDiagonal) {
        notes << QCoreApplication::translate(
                     "MeshDoctor",
                     "The mesh lies %1 times its own size from the origin: it is moved there for "
                     "solving, and saved where it was")
                     .arg(report.distanceFromOrigin / report.boxDiagonal, 0, 'g', 3);
    }
    if (report.faces > 0 && !(report.area > 0))
        notes << QCoreApplication::translate("MeshDoctor", "The mesh has no area: its UVs have no meaning");
    return notes;
}

} // namespace autocuts
