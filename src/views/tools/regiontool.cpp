#include "views/tools/regiontool.h"

#include "commands/setuvs.h"
#include "views/canvas/mapcamera.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/editing/cleanfaces.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
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

RegionTool::RegionTool(const StudioContext &context, QObject *parent)
    : AbstractTool(context, QStringLiteral("region"), parent)
{
    connect(&context.workspace, &Workspace::selectionChanged, this, &AbstractTool::hintChanged);
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] { mGoOn = false; });
    connect(&mSearch, &JobRunner::failed, this, [this] { setState(State::Idle); });
}

QCursor RegionTool::cursor() const
{
    return mState == State::Searching ? Qt::BusyCursor : Qt::ArrowCursor;
}

void RegionTool::setState(State state)
{
    mState = state;
    Q_EMIT hintChanged(); // this also updates the cursor
}

QString RegionTool::hint() const
{
    const Document *document = context().workspace.document();
    if (mState == State::Searching)
        return tr("Looking for the largest part without overlaps; Escape: cancel");
    if (document && !document->selection().faces.isEmpty() && !mOneIsEnough)
        return tr("Overlap region: drag it away, then click the rest, which still covers itself; no single "
                  "region takes all overlaps away");
    return document && !document->selection().faces.isEmpty()
               ? tr("Overlap region: drag the selection away in the UV view; click elsewhere for another "
                    "region, Shift adds")
               : tr("Overlap region: click where the largest part without overlaps is wanted");
}

void RegionTool::press(const ToolEvent &event)
{
    if (mState == State::Searching)
        cancel();
    if (event.button != Qt::LeftButton || mState != State::Idle)
        return;
    setState(State::Pressed);
    mCanvas = &event.canvas;
    mStart = event.position;
    mTriangle = event.pick.triangle;
}

void RegionTool::move(const ToolEvent &event)
{
    if (mState == State::Idle || mState == State::Searching || &event.canvas != mCanvas)
        return;
    const QPointF moved = event.position - mStart;
    if (mState == State::Pressed && std::hypot(moved.x(), moved.y()) >= dragDistance) {
        mState = State::Waiting;
        mGoOn = mGoOn || context().solver.isRunning();
        context().solver.whenPaused([this] { begin(); });
    }
    if (mState == State::Moving)
        moveTo(event.position);
}

void RegionTool::begin()
{
    if (mState != State::Waiting)
        return; // released or cancelled while the solver was pausing
    const Document &document = *context().workspace.document();
    const QList<int> &selected = document.selection().faces;
    const bool onSelection = mTriangle >= 0 && std::binary_search(selected.begin(), selected.end(),
                                                                  document.mesh().triangleFace[mTriangle]);
    if (!onSelection || !asMap(mCanvas.data()))
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
    const MapCamera &camera = *asMap(mCanvas.data())->mapCamera();
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
    if (event.button != Qt::LeftButton || mState == State::Idle || mState == State::Searching ||
        &event.canvas != mCanvas)
        return;
    const State state = mState;
    if (state == State::Pressed) {
        const bool add = event.modifiers.testFlag(Qt::ShiftModifier);
        mGoOn = mGoOn || context().solver.isRunning();
        setState(State::Searching);
        context().solver.whenPaused([this, triangle = mTriangle, add, number = ++mSearches] {
            if (number == mSearches && mState == State::Searching)
                search(triangle, add);
        });
        return;
    }
    setState(State::Idle);
    if (state == State::Moving) {
        moveTo(event.position);
        mGesture = 0;
        if (std::exchange(mGoOn, false))
            context().solver.run();
    }
}

void RegionTool::search(int triangle, bool add)
{
    if (triangle < 0) {
        setState(State::Idle);
        mOneIsEnough = true;
        select({}, add);
        return;
    }
    mSearch.start(
        tr("Looking for a region"),
        [map = MapWithSeams(*context().workspace.document(), context().shownMap),
         triangle](JobControl &control) { return cleanPart(map, triangle, &control.stop()); },
        [this, add, token = context().workspace.document()->token()](const CleanPart &part) {
            setState(State::Idle);
            mOneIsEnough = part.restIsClean;
            if (context().workspace.hasMapOf(token))
                select(part.faces, add);
        });
}

void RegionTool::select(const QList<int> &faces, bool add)
{
    Document &document = *context().workspace.document();
    Selection region;
    region.mode = SelectionMode::Faces;
    region.faces = faces;
    Selection current = document.selection();
    current.mode = SelectionMode::Faces;
    document.setSelection(combined(current, region, add ? Combine::Add : Combine::Replace));
}

void RegionTool::cancel()
{
    Document *document = context().workspace.document();
    if (mState == State::Moving && document)
        cancelGesture(*document, mGesture);
    mSearch.abandon();
    setState(State::Idle);
    mGesture = 0;
}

} // namespace autocuts
