#include "views/actions/actionstates.h"

#include "model/document/makesnapshot.h"
#include "views/actions/actionregistry.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"

#include <QFileInfo>

namespace autocuts {

ActionStates::ActionStates(const StudioContext &context, QObject *parent) : QObject(parent), mContext(context)
{
    // Updated at once instead of in the event loop, because the next key press must find the right actions.
    connect(&context.workspace, &Workspace::documentReplaced, this, &ActionStates::refresh);
    connect(&context.workspace, &Workspace::selectionChanged, this, &ActionStates::refresh);
    connect(&context.workspace, &Workspace::historyChanged, this, &ActionStates::refresh);
    connect(&context.solver, &SolverController::stateChanged, this, &ActionStates::refresh);
    connect(&context.map, &MapController::figuresChanged, this, &ActionStates::refresh);
    connect(&context.map.jobs(), &JobRunner::busyChanged, this, &ActionStates::refresh);
    connect(&context.files.jobs(), &JobRunner::busyChanged, this, &ActionStates::refresh);
    refresh();
}

//! UVs are searched for again only after they have changed.
bool ActionStates::hasUvs() const
{
    if (mContext.workspace.hasMapOf(mUvToken))
        return mHasUvs;
    const Document &document = *mContext.workspace.document();
    mUvToken = document.token();
    mHasUvs = autocuts::hasUvs(document);
    return mHasUvs;
}

int ActionStates::met() const
{
    int met = mContext.map.jobs().isBusy() || mContext.files.jobs().isBusy() ? NeedsJob : NeedsIdle;
    const Document *document = mContext.workspace.document();
    if (!document)
        return met;
    const auto add = [&met](bool holds, ActionNeed need) { met |= holds ? need : 0; };
    const SolverController &solver = mContext.solver;
    const Selection &selection = document->selection();
    add(true, NeedsDocument);
    add(hasUvs() || solver.isRunning() || solver.isPausing() || solver.soup(), NeedsUvs);
    add(!selection.isEmpty(), NeedsSelection);
    add(!selection.edges.isEmpty(), NeedsSelectedEdges);
    add(!selection.faces.isEmpty(), NeedsSelectedFaces);
    add(!selection.edges.isEmpty() || !selection.faces.isEmpty(), NeedsEdgesOrFaces);
    add(!document->hidden().empty(), NeedsHidden);
    add(QFileInfo(document->state().scene.path).isAbsolute(), NeedsFile);
    add(document->uvSets().size() > 1, NeedsSeveralSets);
    // A running solve can be undone: pausing first makes it an entry.
    add(document->undoStack().canUndoFurther() || solver.isRunning() || solver.isPausing(), NeedsUndo);
    add(document->undoStack().canRedo(), NeedsRedo);
    const MapFigures *figures = mContext.map.figures();
    add(figures && mContext.map.figuresAreFresh() && !figures->overlapping.empty(), NeedsOverlaps);
    return met;
}

void ActionStates::refresh()
{
    mContext.actions.setMet(met());
}

} // namespace autocuts
