#include "views/actions/selectactions.h"

#include "model/document/selectiontools.h"
#include "views/actions/choice.h"
#include "views/control/mapcontroller.h"
#include "views/control/workspace.h"
#include "views/selecting/selecting.h"

#include <algorithm>

namespace autocuts {

namespace {

constexpr Choice<SelectionMode> modes[] = {{"select.vertices", SelectionMode::Vertices},
                                           {"select.edges", SelectionMode::Edges},
                                           {"select.faces", SelectionMode::Faces},
                                           {"select.islands", SelectionMode::Islands}};

QList<int> facesOfTriangles(const MeshData &mesh, const std::vector<int> &triangles)
{
    QList<int> faces;
    for (int triangle : triangles)
        faces.append(mesh.triangleFace[triangle]);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

} // namespace

template <typename Change>
void SelectActions::connectChange(const char *id, Change change)
{
    connect(mContext.actions.action(id), &QAction::triggered, this, [this, change] {
        if (Document *document = mContext.workspace.document())
            document->setSelection(change(*document, document->selection()));
    });
}

SelectActions::SelectActions(const StudioContext &context, QObject *parent)
    : QObject(parent), mContext(context)
{
    using S = const Selection &;
    using D = const Document &;
    connectChange("select.all", [](D d, S s) { return everything(d, s.mode); });
    connectChange("select.none", [](D d, S s) { return selectionOf(d, {}, s.mode); });
    connectChange("select.invert", [](D d, S s) { return inverted(d, s); });
    connectChange("select.grow", [](D d, S s) { return grown(d.mesh(), d.adjacency(), s); });
    connectChange("select.shrink", [](D d, S s) { return shrunk(d.mesh(), d.adjacency(), s); });
    connectChange("select.linked",
                  [](D d, S s) { return selectionOf(d, linkedFaces(d.mesh(), facesOf(d, s)), s.mode); });
    connectChange("select.island", [](D d, S s) {
        return selectionOf(d, facesOfIslands(d.islands(), facesOf(d, s)), s.mode);
    });
    connectChange("select.loop", [](D d, S s) { return loopsOf(d, s); });
    connectChange("select.similar",
                  [](D d, S s) { return selectionOf(d, facesOfSimilarIslands(d, facesOf(d, s)), s.mode); });
    connectChange("select.flipped", [](D d, S s) { return selectionOf(d, flippedFaces(d), s.mode); });
    connectChange("select.overlapping", [this](D d, S s) {
        const MapFigures *figures = mContext.map.figures();
        if (!figures || !mContext.map.figuresAreFresh())
            return s;
        return selectionOf(d, facesOfTriangles(d.mesh(), figures->overlapping), s.mode);
    });
    for (const auto &[id, mode] : modes)
        connectMode(id, mode);
    connect(&context.workspace, &Workspace::selectionChanged, this, &SelectActions::showMode);
    connect(&context.workspace, &Workspace::documentReplaced, this, &SelectActions::showMode);
    showMode();
}

void SelectActions::connectMode(const char *id, SelectionMode mode)
{
    connectChange(id, [mode](const Document &, Selection selection) {
        selection.mode = mode;
        return selection;
    });
}

void SelectActions::showMode()
{
    const Document *document = mContext.workspace.document();
    const SelectionMode mode = document ? document->selection().mode : Selection().mode;
    showChoice(mContext.actions, modes, mode);
}

} // namespace autocuts
