#include "views/actions/selectactions.h"

#include "model/editing/selectiontools.h"
#include "views/actions/choice.h"
#include "views/control/figures/islandfigures.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/numberdialog.h"
#include "views/selecting/alongloops.h"
#include "views/selecting/edgekinds.h"
#include "views/selecting/islandkinds.h"
#include "views/selecting/selecting.h"
#include "views/selecting/similaredges.h"
#include "views/selecting/similarfaces.h"
#include "views/ui/questions.h"

#include <algorithm>

namespace autocuts {

namespace {

constexpr Choice<SelectionMode> modes[] = {{"select.vertices", SelectionMode::Vertices},
                                           {"select.edges", SelectionMode::Edges},
                                           {"select.faces", SelectionMode::Faces},
                                           {"select.islands", SelectionMode::Islands}};

constexpr Choice<FaceLikeness> likenesses[] = {
    {"select.similarArea", FaceLikeness::Area},         {"select.similarNormal", FaceLikeness::Normal},
    {"select.similarMaterial", FaceLikeness::Material}, {"select.similarCorners", FaceLikeness::Corners},
    {"select.similarShape", FaceLikeness::Shape},       {"select.similarAreaInMap", FaceLikeness::AreaInMap}};

constexpr Choice<EdgeLikeness> edgeLikenesses[] = {{"select.similarLength", EdgeLikeness::Length},
                                                   {"select.similarLengthInMap", EdgeLikeness::LengthInMap},
                                                   {"select.similarDirection", EdgeLikeness::DirectionInMap}};

Selection selectionOfEdges(const QList<int> &edges)
{
    Selection result;
    result.mode = SelectionMode::Edges;
    result.edges = edges;
    return result;
}

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

template <typename Ask, typename Change>
void SelectActions::connectAsked(const char *id, double &number, Ask question, Change change)
{
    connect(mContext.actions.action(id), &QAction::triggered, this, [this, &number, question, change] {
        if (!mContext.workspace.document())
            return;
        NumberQuestion asked = question(*mContext.workspace.document());
        asked.value = number;
        NumberDialog dialog(asked, mQuestions.window());
        if (mQuestions.run(dialog) != QDialog::Accepted)
            return;
        number = dialog.number();
        // Another document may have been opened meanwhile.
        if (Document *document = mContext.workspace.document())
            document->setSelection(change(*document, document->selection(), number));
    });
}

SelectActions::SelectActions(const StudioContext &context, Questions &questions, QObject *parent)
    : QObject(parent), mContext(context), mQuestions(questions)
{
    connectWays();
    connectEdgeKinds();
    connectIslandKinds();
    for (const auto &[id, mode] : modes)
        connectMode(id, mode);
    connect(&context.workspace, &Workspace::selectionChanged, this, &SelectActions::showMode);
    connect(&context.workspace, &Workspace::documentReplaced, this, &SelectActions::showMode);
    showMode();
}

void SelectActions::connectWays()
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
    for (const auto &[id, value] : likenesses)
        connectChange(id, [likeness = value](D d, S s) {
            return selectionOf(d, similarFaces(d, facesOf(d, s), likeness), s.mode);
        });
    connectChange("select.ring", [](D d, S s) { return ringsOf(d, s); });
    connectChange("select.strip", [](D d, S s) { return stripsOf(d, s); });
    connectChange("select.everySecond", [](D d, S s) { return everySecond(d, s); });
    connectChange("select.growAlong", [](D d, S s) { return grownAlong(d, s); });
    connectChange("select.shrinkAlong", [](D d, S s) { return shrunkAlong(d, s); });
    connectAsked(
        "select.flat", mFlatAngle,
        [](D) {
            return NumberQuestion{
                tr("Flat with the selection"),
                tr("Select the connected faces between which the model is bent by no more than "
                   "this angle."),
                tr("&Angle:"),
                tr("\u00b0"),
                tr("&Select"),
                0,
                0,
                180,
                1};
        },
        [](D d, S s, double angle) { return selectionOf(d, flatFaces(d, facesOf(d, s), angle), s.mode); });
}

void SelectActions::connectEdgeKinds()
{
    using S = const Selection &;
    using D = const Document &;
    for (const auto &[id, value] : edgeLikenesses)
        connectChange(id, [likeness = value](D d, S s) {
            return selectionOfEdges(similarEdges(d, s.edges, likeness));
        });
    connectChange("select.border", [](D d, S) { return selectionOfEdges(borderEdges(d)); });
    connectChange("select.seams", [](D d, S) { return selectionOfEdges(seamEdges(d)); });
    connectChange("select.outline", [](D d, S s) { return selectionOfEdges(outlineEdges(d, s.faces)); });
    connectAsked(
        "select.sharp", mSharpAngle,
        [](D) {
            return NumberQuestion{tr("Sharp edges"),
                                  tr("Select the edges that are bent by more than this angle."),
                                  tr("&Angle:"),
                                  tr("\u00b0"),
                                  tr("&Select"),
                                  0,
                                  0,
                                  180,
                                  1};
        },
        [](D d, S, double angle) { return selectionOfEdges(sharpEdges(d, angle)); });
}

void SelectActions::connectIslandKinds()
{
    using S = const Selection &;
    using D = const Document &;
    connectChange("select.stretched", [](D d, S s) {
        return selectionOf(d, facesOfStretchedIslands(d, d.solveSettings().maxDistortion), s.mode);
    });
    connectAsked(
        "select.small", mSmallIsland,
        [](D d) {
            return NumberQuestion{tr("Small islands"),
                                  tr("Select the islands that are shorter than this, at %1 texels per tile.")
                                      .arg(d.packingSettings().textureSize),
                                  tr("&Shorter than:"),
                                  tr(" px"),
                                  tr("S&elect"),
                                  0,
                                  1,
                                  100'000,
                                  0};
        },
        [](D d, S s, double texels) { return selectionOf(d, facesOfSmallIslands(d, texels), s.mode); });
    connectAsked(
        "select.offDensity", mDensityTolerance,
        [](D d) {
            return NumberQuestion{
                tr("Texel density outliers"),
                tr("Select the islands with a texel density off the median, %1 px/unit, by more than this.")
                    .arg(medianTexelDensity(islandFigures(d, {})), 0, 'g', 4),
                tr("&Off by more than:"),
                tr(" %"),
                tr("&Select"),
                0,
                0,
                1000,
                1};
        },
        [](D d, S s, double percent) { return selectionOf(d, facesOffDensity(d, percent / 100), s.mode); });
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
