#include "views/actions/islandactions.h"

#include "commands/islandtransform.h"
#include "commands/makeunique.h"
#include "commands/setislandflags.h"
#include "commands/setislandtag.h"
#include "commands/stackislands.h"
#include "model/io/meshes/instances.h"
#include "model/plain/udimtiles.h"
#include "views/actions/actionregistry.h"
#include "views/control/figures/islandfigures.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/densitydialog.h"
#include "views/dialogs/numberdialog.h"
#include "views/dialogs/scatterdialog.h"
#include "views/dialogs/tagdialog.h"
#include "views/selecting/movableislands.h"
#include "views/selecting/selecting.h"
#include "views/state/viewstate.h"
#include "views/ui/questions.h"

#include <QAction>
#include <QPointer>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

namespace autocuts {

namespace {

std::vector<Vec2> pointsOf(const Document &document, const IslandPiece &piece)
{
    std::vector<Vec2> points;
    for (int corner : document.islands().corners(document.mesh(), piece.islands))
        points.push_back(document.uv().row(corner).transpose());
    return points;
}

//! The directions of a piece's selected edges in the map.
std::vector<Vec2> selectedDirections(const Document &document, const IslandPiece &piece)
{
    const QList<int> &edges = document.selection().edges;
    std::vector<Vec2> directions;
    for (int island : piece.islands) {
        for (int face : document.islands().faces(island)) {
            const int first = document.mesh().faceStart[face], end = document.mesh().faceStart[face + 1];
            for (int c = first; c < end; ++c) {
                if (!std::binary_search(edges.begin(), edges.end(), document.adjacency().edgeOfCorner(c)))
                    continue;
                const int next = c + 1 < end ? c + 1 : first;
                directions.push_back((document.uv().row(next) - document.uv().row(c)).transpose());
            }
        }
    }
    return directions;
}

//! Makes one transform per piece.
template <typename Function>
std::vector<Eigen::Affine2d> each(const std::vector<IslandPiece> &pieces, Function function)
{
    std::vector<Eigen::Affine2d> result;
    std::transform(pieces.begin(), pieces.end(), std::back_inserter(result), function);
    return result;
}

} // namespace

IslandActions::IslandActions(const StudioContext &context, Questions &questions, QObject *parent)
    : QObject(parent), mContext(context), mQuestions(questions)
{
    mRanges.move = 0.05;
    mRanges.angle = std::numbers::pi / 6;
    mRanges.scale = 0.1;
    connectMoves();
    connectTurns();
    connectStacks();
    connectDialogs();
}

void IslandActions::onTriggered(const char *id, const std::function<void(Document &)> &function)
{
    connect(mContext.actions.action(id), &QAction::triggered, this, [this, function] {
        if (!mContext.workspace.document())
            return;
        mContext.solver.whenPaused([self = QPointer(this), function] {
            Document *document = self ? self->mContext.workspace.document() : nullptr;
            if (document && !self->mContext.map.jobs().isBusy())
                function(*document);
        });
    });
}

std::vector<int> IslandActions::selectedIslands(const Document &document) const
{
    return document.islands().islandsOf(facesOf(document, document.selection()));
}

void IslandActions::onPieces(const char *id, UvEdit edit,
                             const std::function<Transforms(const Document &, const Pieces &)> &transforms)
{
    onTriggered(id, [this, edit, transforms](Document &document) {
        const Pieces pieces = islandPieces(document.islands(), document.marks(), selectedIslands(document));
        if (pieces.empty())
            return;
        const bool allLocked =
            std::all_of(pieces.begin(), pieces.end(), [](const IslandPiece &p) { return p.locked; });
        if (pushCommand(movePieces(document, edit, pieces, transforms(document, pieces))))
            Q_EMIT said(document.undoStack().undoText());
        else
            Q_EMIT said(allLocked ? tr("The selected islands are locked")
                                  : tr("Nothing to do: the islands lie that way already"));
    });
}

void IslandActions::connectMoves()
{
    const auto align = [this](const char *id, AlignTo to) {
        onPieces(id, UvEdit::Align, [to](const Document &document, const Pieces &pieces) {
            return alignedPieces(pieces, to, document.packingSettings().tileHeight());
        });
    };
    align("uv.alignLeft", AlignTo::Left);
    align("uv.alignRight", AlignTo::Right);
    align("uv.alignTop", AlignTo::Top);
    align("uv.alignBottom", AlignTo::Bottom);
    align("uv.alignCentreU", AlignTo::CentreU);
    align("uv.alignCentreV", AlignTo::CentreV);
    const auto distribute = [this](const char *id, Distribute how) {
        onPieces(id, UvEdit::Distribute, [this, how](const Document &, const Pieces &pieces) {
            if (pieces.size() < 3)
                Q_EMIT said(tr("Select three islands or more to distribute them"));
            return distributedPieces(pieces, how);
        });
    };
    distribute("uv.distributeU", Distribute::CentresU);
    distribute("uv.distributeV", Distribute::CentresV);
    distribute("uv.distributeGapsU", Distribute::GapsU);
    distribute("uv.distributeGapsV", Distribute::GapsV);
}

void IslandActions::connectTurns()
{
    for (const int axis : {0, 1}) {
        onPieces(axis == 0 ? "uv.mirrorU" : "uv.mirrorV", UvEdit::Mirror,
                 [axis](const Document &, const Pieces &pieces) {
                     return each(pieces, [axis](const IslandPiece &p) { return mirroredPiece(p, axis); });
                 });
    }
    for (const bool left : {true, false}) {
        onPieces(left ? "uv.turnLeft" : "uv.turnRight", UvEdit::Rotate,
                 [this, left](const Document &document, const Pieces &pieces) {
                     const MovableIslands movable = movableIslands(document, mContext.view.tools());
                     return each(pieces, [&](const IslandPiece &piece) {
                         return turnedAbout(movable.pivotOf(piece.islands.front()),
                                            (left ? 0.5 : -0.5) * std::numbers::pi);
                     });
                 });
    }
    onPieces("uv.fitTile", UvEdit::Scale, [](const Document &document, Pieces pieces) {
        // Locked pieces stay where they are.
        const PackingSettings settings = document.packingSettings();
        const std::size_t count = pieces.size();
        std::erase_if(pieces, [](const IslandPiece &piece) { return piece.locked; });
        return Transforms(count, fittedIntoTile(pieces, 0.5 * settings.margin / settings.textureSize,
                                                settings.tileHeight()));
    });
    onPieces("uv.toTexture", UvEdit::Scale, [](const Document &document, const Pieces &pieces) {
        const Vec2 factor(1, document.packingSettings().tileHeight());
        return Transforms(pieces.size(), scaledAbout(Vec2::Zero(), factor));
    });
    onPieces("uv.orientBox", UvEdit::Orient, [](const Document &document, const Pieces &pieces) {
        return each(pieces, [&](const IslandPiece &piece) {
            return turnedPiece(piece, turnToSmallestBox(pointsOf(document, piece)));
        });
    });
    onPieces("uv.orientEdges", UvEdit::Orient, [](const Document &document, const Pieces &pieces) {
        return each(pieces, [&](const IslandPiece &piece) {
            return turnedPiece(piece, turnToDirections(selectedDirections(document, piece)));
        });
    });
    onTriggered("uv.alignAxes", [this](const Document &document) {
        mContext.map.alignToAxes(facesOf(document, document.selection()));
    });
    connect(mContext.actions.action("uv.straighten"), &QAction::triggered, &mContext.map,
            &MapController::straightenSelection);
    connect(mContext.actions.action("uv.grid"), &QAction::triggered, &mContext.map,
            &MapController::gridSelection);
    connect(mContext.actions.action("uv.relax"), &QAction::triggered, &mContext.map,
            &MapController::relaxSelection);
}

void IslandActions::connectStacks()
{
    onTriggered("uv.stackCopies", [this](Document &document) { stack(document); });
    onTriggered("uv.unstackCopies", [this](Document &document) { unstack(document); });
    onTriggered("uv.makeUnique", [this](Document &document) {
        if (!hasSharedMeshes(document.state().scene))
            Q_EMIT said(tr("No objects share a mesh in the file of the model"));
        else if (pushCommand(std::make_unique<MakeUnique>(document)))
            Q_EMIT said(tr("Each object gets a mesh and a map of its own when the model is written"));
        else
            Q_EMIT said(tr("The meshes are unique already"));
    });
}

void IslandActions::stack(Document &document)
{
    const std::vector<int> islands = selectedIslands(document);
    if (islands.empty())
        return;
    const StackIslands::Found found = StackIslands::copiesAmong(document, islands);
    if (found.stacks.empty()) {
        Q_EMIT said(tr("No two of the islands are copies of each other"));
        return;
    }
    pushCommand(StackIslands::stack(document, found.stacks));
    QString message = document.undoStack().undoText();
    if (found.mirrored > 0)
        message += tr(", of them turned over, since they are mirror images: %1").arg(found.mirrored);
    Q_EMIT said(message);
}

void IslandActions::unstack(Document &document)
{
    const std::vector<int> islands = selectedIslands(document);
    if (islands.empty())
        return;
    if (pushCommand(StackIslands::unstack(document, islands)))
        Q_EMIT said(document.undoStack().undoText());
    else
        Q_EMIT said(tr("The islands are in no stack"));
}

void IslandActions::connectDialogs()
{
    onTriggered("uv.scatter", [this](Document &document) { askScatter(document); });
    onTriggered("uv.sendToTile", [this](Document &document) { askTile(document); });
    onTriggered("uv.lockTile", [this](Document &document) { lockTile(document); });
    onTriggered("select.tags", [this](Document &document) { askTag(document); });
    onTriggered("uv.packDensity", [this](Document &document) { askPackDensity(document); });
    onTriggered("uv.densitySet", [this](Document &document) { askDensity(document); });
}

void IslandActions::askScatter(Document &document)
{
    ScatterDialog dialog(mRanges, document.packingSettings().textureSize, mQuestions.window());
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    mRanges = dialog.ranges();
    const Pieces pieces = islandPieces(document.islands(), document.marks(), selectedIslands(document));
    if (pushCommand(movePieces(document, UvEdit::Scatter, pieces, scatteredPieces(pieces, mRanges))))
        Q_EMIT said(document.undoStack().undoText());
}

//! Moves the selected islands into a tile, to the same place in it.
void IslandActions::askTile(Document &document)
{
    NumberDialog dialog({tr("Send to a tile"),
                         tr("The selected islands keep their place in the tile, their scale and direction."),
                         tr("&Tile:"),
                         {},
                         tr("&Send"),
                         double(mTile),
                         PackingSettings::firstTile,
                         PackingSettings::lastTile,
                         0},
                        mQuestions.window());
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    mTile = static_cast<int>(dialog.number());
    const double height = document.packingSettings().tileHeight();
    const TileLayout layout =
        findTiles(document.mesh(), findCharts(document.mesh(), document.uv()), document.uv(), height);
    const Pieces pieces = islandPieces(document.islands(), document.marks(), selectedIslands(document));
    Transforms transforms;
    for (const IslandPiece &piece : pieces) {
        const int tile = layout.tile[piece.islands.front()];
        const Vec2 from = (tile > 0 ? udimTile(tile, height) : tileAt(piece.box.center(), height)).min();
        transforms.emplace_back(Eigen::Translation2d(udimTile(mTile, height).min() - from));
    }
    if (pushCommand(movePieces(document, UvEdit::Move, pieces, transforms)))
        Q_EMIT said(tr("Islands sent to tile %1: %2").arg(mTile).arg(pieces.size()));
}

//! Tags the selected islands, untags them, or selects the islands of a tag.
void IslandActions::askTag(Document &document)
{
    QStringList tags;
    for (const IslandTag &tag : document.marks().tags)
        tags << tag.name;
    const std::vector<int> islands = document.islands().islandsOf(document.selection().faces);
    TagDialog dialog(tags, static_cast<int>(islands.size()), mQuestions.window());
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    using Choice = TagDialog::Choice;
    const QString name = dialog.name();
    if (dialog.choice() != Choice::Select) {
        if (pushCommand(
                std::make_unique<SetIslandTag>(document, name, islands, dialog.choice() == Choice::Tag)))
            Q_EMIT said(document.undoStack().undoText());
        return;
    }
    if (const IslandTag *tag = document.marks().tag(name)) {
        Selection selection;
        selection.mode = SelectionMode::Islands;
        selection.faces = tag->faces;
        document.setSelection(selection);
        Q_EMIT said(tr("Islands selected: %1").arg(document.islands().islandsOf(tag->faces).size()));
    }
}

//! Locks all islands of the tiles in which selected ones are, or unlocks them when all are locked.
void IslandActions::lockTile(Document &document)
{
    const TileLayout layout = findTiles(document.mesh(), findCharts(document.mesh(), document.uv()),
                                        document.uv(), document.packingSettings().tileHeight());
    std::set<int> tiles;
    for (const int island : selectedIslands(document))
        tiles.insert(layout.tile[island]);
    tiles.erase(0);
    std::vector<int> islands;
    bool allLocked = true;
    for (int island = 0; island < document.islands().count(); ++island) {
        if (!tiles.contains(layout.tile[island]))
            continue;
        islands.push_back(island);
        allLocked = allLocked && document.marks().flagsOf(document.islands().faces(island)).locked != 0;
    }
    if (islands.empty()) {
        Q_EMIT said(tr("The selected islands belong to no tile"));
        return;
    }
    using Edit = SetIslandFlags::Edit;
    pushCommand(std::make_unique<SetIslandFlags>(document, allLocked ? Edit::Unlock : Edit::Lock, islands));
    Q_EMIT said(allLocked ? tr("Islands unlocked: %1").arg(islands.size())
                          : tr("Islands locked: %1").arg(islands.size()));
}

//! Of the selected islands, or of all when none are selected.
void IslandActions::askPackDensity(Document &document)
{
    std::vector<int> islands = document.islands().islandsOf(document.selection().faces);
    if (islands.empty()) {
        islands.resize(static_cast<std::size_t>(document.islands().count()));
        std::iota(islands.begin(), islands.end(), 0);
    }
    const MeshData &mesh = *document.weightedMesh();
    double area = 0;
    for (const int island : islands) {
        for (const int face : document.islands().faces(island)) {
            for (const int triangle : mesh.trianglesOf(face))
                area += mesh.targetArea(triangle);
        }
    }
    DensityDialog dialog(meanTexelDensity(document, islands), document.packingSettings(),
                         mQuestions.window());
    dialog.askForPacking(area);
    if (mQuestions.run(dialog) == QDialog::Accepted)
        mContext.map.packAtDensity(dialog.density());
}

void IslandActions::askDensity(Document &document)
{
    const std::vector<int> islands = selectedIslands(document);
    DensityDialog dialog(meanTexelDensity(document, islands), document.packingSettings(),
                         mQuestions.window());
    if (mQuestions.run(dialog) != QDialog::Accepted)
        return;
    if (pushCommand(setTexelDensity(document, islands, dialog.density())))
        Q_EMIT said(document.undoStack().undoText());
}

} // namespace autocuts
