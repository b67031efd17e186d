#include "views/selecting/findings.h"

#include "model/document/document.h"
#include "model/plain/uvlayout.h"
#include "views/gl/stretch.h"

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

//! The sides of polygons on one edge in space.
struct SidesThere
{
    int forward = 0, backward = 0; //!< by the order of the vertices' numbers
    std::vector<int> edges;        //!< of MeshAdjacency
};

template <typename Accept>
Selection edgesWhere(const Document &document, Accept accept)
{
    const MeshData &mesh = document.mesh();
    std::map<std::pair<int, int>, SidesThere> all;
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const int first = mesh.faceStart[face], end = mesh.faceStart[face + 1];
        for (int c = first; c < end; ++c) {
            const int a = mesh.vertexWeld[mesh.cornerVertex[c]];
            const int b = mesh.vertexWeld[mesh.cornerVertex[c + 1 < end ? c + 1 : first]];
            SidesThere &sides = all[std::minmax(a, b)];
            ++(a < b ? sides.forward : sides.backward);
            sides.edges.push_back(document.adjacency().edgeOfCorner(c));
        }
    }
    Selection selection;
    selection.mode = SelectionMode::Edges;
    for (const auto &[ends, sides] : all) {
        if (accept(sides))
            selection.edges.append(QList<int>(sides.edges.begin(), sides.edges.end()));
    }
    return selection;
}

template <typename Accept>
Selection facesWhere(const Document &document, Accept accept)
{
    Selection selection;
    for (int face = 0; face < document.mesh().faceCount(); ++face) {
        if (accept(face))
            selection.faces << face;
    }
    return selection;
}

Selection facesOfTriangles(const Document &document, const std::vector<bool> &triangles)
{
    return facesWhere(document, [&](int face) {
        const auto own = document.mesh().trianglesOf(face);
        return std::any_of(own.begin(), own.end(), [&](int t) { return bool(triangles[t]); });
    });
}

//! Twice the area of each triangle in the map; not a number without UVs.
std::vector<double> areasInMap(const Document &document)
{
    const UvMatrix &uv = document.soupMap().uv;
    std::vector<double> areas(document.mesh().triangleCount());
    for (std::size_t t = 0; t < areas.size(); ++t) {
        const Vec2 a = uv.row(3 * t), b = uv.row(3 * t + 1), c = uv.row(3 * t + 2);
        areas[t] = cross2(a, b, c);
    }
    return areas;
}

Selection mostStretched(const Document &document)
{
    const MeshData &mesh = document.mesh();
    const std::vector<float> energy =
        StretchMeter(*document.weightedMesh()).measure(document.soupMap().uv).dirichlet;
    int worst = -1;
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (energy[t] >= 4 && !mesh.triangleDegenerate[t] && (worst < 0 || energy[t] > energy[worst]))
            worst = t;
    }
    Selection selection;
    if (worst >= 0)
        selection.faces << mesh.triangleFace[worst];
    return selection;
}

Selection mirroredIslands(const Document &document)
{
    const Islands &islands = document.islands();
    const std::vector<double> areas = areasInMap(document);
    std::vector<double> sum(islands.count(), 0);
    for (std::size_t t = 0; t < areas.size(); ++t) {
        if (const int island = islands.islandOfFace(document.mesh().triangleFace[t]); island >= 0)
            sum[island] += areas[t];
    }
    return facesWhere(document, [&](int face) {
        const int island = islands.islandOfFace(face);
        return island >= 0 && sum[island] < 0;
    });
}

} // namespace

Selection elementsOf(const Document &document, Finding finding)
{
    Selection selection;
    switch (finding) {
    case Finding::BoundaryEdges:
        selection = edgesWhere(document, [](const SidesThere &s) { return s.forward + s.backward == 1; });
        break;
    case Finding::NonManifoldEdges:
        selection = edgesWhere(document, [](const SidesThere &s) { return s.forward + s.backward > 2; });
        break;
    case Finding::WindingEdges:
        selection =
            edgesWhere(document, [](const SidesThere &s) { return s.forward == 2 || s.backward == 2; });
        break;
    case Finding::TrianglesWithoutArea:
        selection = facesOfTriangles(document, document.mesh().triangleDegenerate);
        break;
    case Finding::PolygonsThatMeetThemselves: {
        const std::vector<int> &faces = document.mesh().report.selfContactFaces;
        selection.faces = QList<int>(faces.begin(), faces.end());
        break;
    }
    case Finding::MostStretched:
        selection = mostStretched(document);
        break;
    case Finding::FacesWithoutUv:
        selection = facesWhere(document, [&](int face) { return document.islands().islandOfFace(face) < 0; });
        break;
    case Finding::CollapsedTriangles: {
        std::vector<bool> collapsed;
        for (const double area : areasInMap(document))
            collapsed.push_back(area == 0);
        selection = facesOfTriangles(document, collapsed);
        break;
    }
    case Finding::MirroredIslands:
        selection = mirroredIslands(document);
        break;
    }
    selection.normalize(document.mesh());
    return selection;
}

} // namespace autocuts
