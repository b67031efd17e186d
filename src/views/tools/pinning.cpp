#include "views/tools/pinning.h"

#include "model/document/document.h"
#include "views/canvas/mapcamera.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/studiocontext.h"
#include "views/gl/soupbuffers.h"

#include <set>

namespace autocuts {

namespace {

//! Pixels. While triangles are separate, corners of a vertex closer than this count as one position. Chosen
//! by hand.
constexpr double nearlyThere = 4;

bool samePlace(const Vec2 &a, const Vec2 &b, double tolerance)
{
    return (a - b).cwiseAbs().maxCoeff() <= tolerance;
}

} // namespace

std::vector<UvPin> pinsAt(const MeshData &mesh, const UvMatrix &soupUv, const QList<int> &corners)
{
    std::vector<int> soupOfCorner(mesh.cornerCount(), -1);
    for (int soup = mesh.soupCornerCount() - 1; soup >= 0; --soup)
        soupOfCorner[mesh.cornerOfSoup(soup)] = soup;
    std::vector<UvPin> pins;
    for (int corner : corners) {
        const int soup = soupOfCorner[corner];
        if (soup < 0 || soup >= soupUv.rows() || !soupUv.row(soup).allFinite())
            continue;
        UvPin pin;
        pin.corner = corner;
        pin.position = soupUv.row(soup);
        pins.push_back(pin);
    }
    return pins;
}

std::vector<UvPin> pinsOfVertex(const Document &document, const ToolCanvas &canvas, int soupCorner)
{
    const auto corners = document.adjacency().vertexCorners(document.mesh().vertexOfSoup(soupCorner));
    const UvMatrix &uv = canvas.studio().shownMap.uv();
    std::vector<UvPin> pins = pinsAt(document.mesh(), uv, {corners.begin(), corners.end()});
    const auto *view = asMap(&canvas);
    if (!view)
        return pins;
    const Vec2 place = uv.row(soupCorner);
    const double tolerance = canvas.studio().shownMap.isLive() ? nearlyThere / view->mapCamera()->scale()
                                                               : 1e-9 * (1 + place.cwiseAbs().maxCoeff());
    std::erase_if(pins, [&](const UvPin &pin) { return !samePlace(pin.position, place, tolerance); });
    for (UvPin &pin : pins)
        pin.position = place;
    return pins;
}

std::vector<UvPin> pinsOfIslands(const Document &document, const ShownMap &shown, const QList<int> &faces)
{
    const MeshData &mesh = document.mesh();
    QList<int> corners;
    if (shown.isLive()) {
        const std::vector<int> islands = liveIslands(mesh, shown.separation());
        std::set<int> wanted;
        for (const int face : faces)
            wanted.insert(islands[face]);
        for (int face = 0; face < mesh.faceCount(); ++face) {
            for (int c = mesh.faceStart[face]; wanted.contains(islands[face]) && c < mesh.faceStart[face + 1];
                 ++c)
                corners << c;
        }
    } else {
        const Islands &islands = document.islands();
        for (const int corner : islands.corners(mesh, islands.islandsOf(faces)))
            corners << corner;
    }
    return pinsAt(mesh, shown.uv(), corners);
}

std::vector<UvPin> pinsWith(const Document &document, const UvPin &pin)
{
    const MeshData &mesh = document.mesh();
    std::vector<UvPin> pins;
    const int vertex = mesh.vertexWeld[mesh.cornerVertex[pin.corner]];
    for (int corner : document.adjacency().vertexCorners(vertex)) {
        const UvPin *other = document.constraints().pin(corner);
        if (other && samePlace(other->position, pin.position, 1e-9 * (1 + pin.position.norm())))
            pins.push_back(*other);
    }
    return pins;
}

} // namespace autocuts
