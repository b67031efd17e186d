#include "views/tools/regiontool.h"

#include "commands/setuvs.h"
#include "views/canvas/uvview.h"
#include "views/control/cleanfaces.h"
#include "views/control/shownmap.h"
#include "views/control/solvercontroller.h"
#include "views/control/workspace.h"
#include "views/tools/pickedelements.h"

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

//! The corners of the selected faces, without those of locked islands and those without UVs.
std::vector<int> movableCorners(const Document &document)
{
    const MeshData &mesh = document.mesh();
    const Islands &islands = document.islands();
    std::vector<bool> locked(islands.count());
    for (int island : islands.islandsOf(document.selection().faces))
        locked[island] = document.marks().flagsOf(islands.faces(island)).locked != 0;
    std::vector<int> corners;
    for (int face : document.selection().faces) {
        const int island = islands.islandOfFace(face);
        if (island < 0 || locked[island])
            continue;
        for (int corner = mesh.faceStart[face]; corner < mesh.faceStart[face + 1]; ++corner)
            corners.push_back(corner);
    }
    return corners;
}

} // namespace

RegionTool::RegionTool(const CanvasContext &context, QObject *parent)
    : AbstractTool(context, QStringLiteral("region"), parent)
{
    connect(&context.workspace, &Workspace::selectionChanged, this, &AbstractTool::hintChanged);
}

QString RegionTool::hint() const
{
    const Document *document = context().workspace.document();
    return document && !document->selection().faces.isEmpty()
               ? tr("Overlap region: drag the selection away in the UV view; click elsewhere for another "
                    "region, Shift adds")
               : tr("Overlap region: click where the largest part without overlaps is wanted");
}

void RegionTool::press(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mState != State::Idle)
        return;
    mState = State::Pressed;
    mCanvas = &event.canvas;
    mStart = event.position;
    mTriangle = event.pick.triangle;
}

void RegionTool::move(const ToolEvent &event)
{
    if (mState == State::Idle || &event.canvas != mCanvas)
        return;
    const QPointF moved = event.position - mStart;
    if (mState == State::Pressed && std::hypot(moved.x(), moved.y()) >= dragDistance) {
        mState = State::Waiting;
        context().solver.whenSettled([this] { begin(); });
    }
    if (mState == State::Moving)
        moveTo(event.position);
}

void RegionTool::begin()
{
    if (mState != State::Waiting)
        return; // released or cancelled while the solver came to rest
    const Document &document = *context().workspace.document();
    const QList<int> &selected = document.selection().faces;
    const bool onSelection = mTriangle >= 0 && std::binary_search(selected.begin(), selected.end(),
                                                                  document.mesh().triangleFace[mTriangle]);
    if (!onSelection || !qobject_cast<UvView *>(mCanvas))
        return;
    mCorners = movableCorners(document);
    mFrom.resize(static_cast<Eigen::Index>(mCorners.size()), 2);
    for (std::size_t i = 0; i < mCorners.size(); ++i)
        mFrom.row(static_cast<Eigen::Index>(i)) = document.uv().row(mCorners[i]);
    mGesture = context().workspace.document()->undoStack().newGesture();
    mState = State::Moving;
}

void RegionTool::moveTo(const QPointF &position)
{
    Document &document = *context().workspace.document();
    const MapCamera &camera = qobject_cast<UvView *>(mCanvas)->camera();
    const Vec2 way = camera.toUv(position) - camera.toUv(mStart);
    UvMatrix uv = document.uv();
    UvEditExtras extras;
    extras.count = 1;
    for (std::size_t i = 0; i < mCorners.size(); ++i) {
        uv.row(mCorners[i]) = mFrom.row(static_cast<Eigen::Index>(i)) + way.transpose();
        if (const UvPin *pin = document.constraints().pin(mCorners[i])) {
            extras.pins.push_back(*pin);
            extras.pins.back().position += Vec2(uv.row(mCorners[i]) - document.uv().row(mCorners[i]));
        }
    }
    auto command = std::make_unique<SetUvs>(document, UvEdit::Move, uv, extras);
    command->setGesture(mGesture);
    pushCommand(std::move(command));
}

void RegionTool::release(const ToolEvent &event)
{
    if (event.button != Qt::LeftButton || mState == State::Idle || &event.canvas != mCanvas)
        return;
    const State state = std::exchange(mState, State::Idle);
    if (state == State::Moving) {
        moveTo(event.position);
        mGesture = 0;
    } else if (state == State::Pressed) {
        const bool add = event.modifiers.testFlag(Qt::ShiftModifier);
        context().solver.whenSettled([this, triangle = mTriangle, add] { select(triangle, add); });
    }
}

void RegionTool::select(int triangle, bool add)
{
    Document &document = *context().workspace.document();
    Selection region;
    region.mode = SelectionMode::Faces;
    if (triangle >= 0)
        region.faces = cleanFaces(document, context().shownMap, triangle);
    Selection current = document.selection();
    current.mode = SelectionMode::Faces;
    document.setSelection(combined(current, region, add ? Combine::Add : Combine::Replace));
}

void RegionTool::cancel()
{
    Document *document = context().workspace.document();
    if (mState == State::Moving && document)
        cancelGesture(*document, mGesture);
    mState = State::Idle;
    mGesture = 0;
}

} // namespace autocuts
