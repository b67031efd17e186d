#include "model/io/meshdoctor.h"

#include <algorithm>

namespace autocuts {

namespace {

//! "1 thing" or "n things": the number with the singular or plural.
QString counted(int count, const char *one, const char *many)
{
    return QStringLiteral("%1 %2").arg(count).arg(QLatin1String(count == 1 ? one : many));
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
    return QLatin1String(faces.size() == 1 ? "face " : "faces ") + numbers.join(QLatin1String(", "));
}

} // namespace

QStringList meshDoctorNotes(const MeshReport &report)
{
    QStringList notes;
    const auto note = [&](int count, const char *one, const char *many, const char *done) {
        if (count > 0)
            notes << counted(count, one, many) + QStringLiteral(": ") + QLatin1String(done);
    };
    if (report.faces == 0)
        notes << QStringLiteral("No faces: there is nothing to unwrap");
    note(report.nonManifoldEdges, "non-manifold edge", "non-manifold edges",
         "each face was joined to its best partner, the other sides are treated as boundary");
    note(report.windingEdges, "edge between faces of opposite winding",
         "edges between faces of opposite winding",
         "treated as boundary, because the two sides cannot be continued into each other without a flip");
    note(report.degenerateTriangles, "triangle without area", "triangles without area",
         "kept, and given a thin stand-in shape so that it gets UVs");
    note(report.duplicateFaces, "duplicated face", "duplicated faces",
         "kept, and unwrapped as a layer of its own");
    note(report.concavePolygons, "polygon that is not convex", "polygons that are not convex",
         "split into triangles along diagonals inside it; the polygon itself stays whole");
    if (!report.selfContactFaces.empty()) {
        notes << QStringLiteral("%1 (%2): cut off from the faces around where it does so")
                     .arg(counted(static_cast<int>(report.selfContactFaces.size()), "polygon meets itself",
                                  "polygons meet themselves"),
                          faceNumbers(report.selfContactFaces));
    }
    note(report.weldedVertices, "vertex at the place of another", "vertices at the place of another",
         "treated as joined, and kept apart in the saved file");
    note(report.isolatedVertices, "vertex without a face", "vertices without a face",
         "kept in the saved file");
    note(report.components > 1 ? report.components : 0, "", "separate parts", "each gets islands of its own");
    if (report.boxDiagonal > 0 && report.distanceFromOrigin > 1000 * report.boxDiagonal) {
        notes << QStringLiteral("The mesh lies %1 times its own size from the origin: it is moved there for "
                                "solving, and saved where it was")
                     .arg(report.distanceFromOrigin / report.boxDiagonal, 0, 'g', 3);
    }
    if (report.faces > 0 && !(report.area > 0))
        notes << QStringLiteral("The mesh has no area: its UVs have no meaning");
    return notes;
}

} // namespace autocuts
