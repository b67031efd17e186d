#include "views/tools/draghandles.h"

#include "model/document/document.h"
#include "views/canvas/mapcamera.h"
#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/session/shownmap.h"
#include "views/gl/souptopology.h"
#include "views/selecting/selecting.h"
#include "views/tools/dragreach.h"

#include <algorithm>
#include <limits>
#include <set>

namespace autocuts {

namespace {

//! Pixels. While triangles are separate, corners of a vertex closer than this count as one position. Chosen
//! by hand.
constexpr double nearlyThere = 4;

//! Adds all soup corners of a vertex that are drawn in the position of the given one.
void addVertex(const Document &document, const ToolCanvas &view, const ShownMap &map, int soupCorner,
               std::set<int> &handles)
{
    const UvMatrix &uv = map.uv();
    const double tolerance = map.isLive() ? nearlyThere / view.mapCamera()->scale()
                                          : 1e-9 * (1 + uv.row(soupCorner).cwiseAbs().maxCoeff());
    for (int corner : document.adjacency().vertexCorners(document.mesh().vertexOfSoup(soupCorner))) {
        const int face = document.adjacency().faceOfCorner(corner);
        for (const int s : document.mesh().soupCornersOf(face)) {
            if (document.mesh().cornerOfSoup(s) == corner &&
                (uv.row(s) - uv.row(soupCorner)).cwiseAbs().maxCoeff() <= tolerance)
                handles.insert(s);
        }
    }
}

//! In ascending order.
std::vector<int> cornersOfFaces(const MeshData &mesh, const QList<int> &faces)
{
    std::vector<int> corners;
    for (int face : faces) {
        const auto own = mesh.soupCornersOf(face);
        corners.insert(corners.end(), own.begin(), own.end());
    }
    std::sort(corners.begin(), corners.end());
    return corners;
}

template <typename List>
bool has(const List &list, int value)
{
    return std::binary_search(list.begin(), list.end(), value);
}

std::vector<int> vertexHandles(const Document &document, const ToolCanvas &view, const ShownMap &map,
                               const PickResult &pick)
{
    std::set<int> handles;
    if (pick.soupCorner < 0)
        return {};
    addVertex(document, view, map, pick.soupCorner, handles);
    const MeshData &mesh = document.mesh();
    const QList<int> &selected = document.selection().corners;
    if (has(selected, pick.corner)) {
        for (int s = 0; s < mesh.soupCornerCount(); ++s) {
            if (has(selected, mesh.cornerOfSoup(s)))
                handles.insert(s);
        }
    }
    return {handles.begin(), handles.end()};
}

std::vector<int> edgeHandles(const Document &document, const ToolCanvas &view, const ShownMap &map,
                             const PickResult &pick)
{
    std::set<int> handles;
    if (pick.side < 0)
        return {};
    const auto addSide = [&](int side) {
        addVertex(document, view, map, side, handles);
        addVertex(document, view, map, nextSoupCorner(side), handles);
    };
    addSide(pick.side);
    const QList<int> &selected = document.selection().edges;
    if (has(selected, pick.edge)) {
        for (int edge : selected) {
            for (int side : view.content().topology().edgeSides[edge]) {
                if (side >= 0)
                    addSide(side);
            }
        }
    }
    return {handles.begin(), handles.end()};
}

} // namespace

std::vector<int> dragHandles(const Document &document, const ToolCanvas &view, const ShownMap &map,
                             const PickResult &pick)
{
    const Selection &selection = document.selection();
    if (selection.mode == SelectionMode::Vertices)
        return vertexHandles(document, view, map, pick);
    if (selection.mode == SelectionMode::Edges)
        return edgeHandles(document, view, map, pick);
    if (pick.triangle < 0)
        return {};
    const MeshData &mesh = document.mesh();
    const int face = mesh.triangleFace[pick.triangle];
    const std::vector<int> faces =
        cornersOfFaces(mesh, has(selection.faces, face) ? selection.faces : QList<int>{face});
    if (selection.mode == SelectionMode::Faces)
        return faces;
    return dragReach(mesh, map.uv(), map.separation(), faces, 0).corners;
}

} // namespace autocuts
