// The studio without its window, for tests of menus and dialogs.
#pragma once

#include "support/answers.h"
#include "views/actions/actionregistry.h"
#include "views/actions/studioactions.h"
#include "views/canvas/toolmanager.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/pictures/livebake.h"
#include "views/control/pictures/modelpictures.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/state/viewstate.h"
#include "views/ui/preferences.h"

#include <QTemporaryDir>
#include <QTest>

namespace autocuts::test {

//! Controllers and actions with empty preferences, in a folder of their own.
struct StudioParts
{
    QTemporaryDir folder;
    Preferences preferences{path("autocuts.ini")};
    ActionRegistry registry{preferences};
    Workspace workspace;
    ShownMap shownMap{workspace};
    ViewState view;
    SolverController solver{workspace, shownMap};
    MapController map{workspace, solver, shownMap};
    FileController files{workspace, solver, preferences, path("recovery")};
    ModelPictures pictures{workspace, view};
    LiveBake liveBake{workspace, shownMap};
    StudioContext context{workspace, shownMap, view,     preferences, solver,
                          map,       files,    registry, pictures,    liveBake};
    Answers answers;
    ToolManager tools{context};
    StudioActions actions{context, answers, tools, path("recovery")};

    StudioParts()
    {
        QObject::connect(&files, &FileController::failed, &files,
                         [this](const Error &error) { answers.showError(error); });
    }

    QString path(const char *name) const { return folder.filePath(QString::fromUtf8(name)); }
    Document &document() { return *workspace.document(); }
    QAction *action(const char *id) { return registry.action(id); }
    void trigger(const char *id) { action(id)->trigger(); }
    //! Waits until nothing runs.
    bool rests()
    {
        return QTest::qWaitFor(
            [this] {
                return !solver.isRunning() && !solver.isPausing() && !map.jobs().isBusy() &&
                       !files.jobs().isBusy() && !files.isSaving();
            },
            60'000);
    }
};

} // namespace autocuts::test
