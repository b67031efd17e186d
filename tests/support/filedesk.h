// What a window has for files, without the window, for tests of opening and writing.
#pragma once

#include "support/patience.h"
#include "views/control/files/filecontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/ui/preferences.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace autocuts::test {

//! What a window has for files, without the window.
struct FileDesk
{
    explicit FileDesk(const QTemporaryDir &folder)
        : preferences(folder.filePath(QStringLiteral("autocuts.ini"))),
          files(workspace, solver, preferences, folder.filePath(QStringLiteral("recovery")))
    {}

    Workspace workspace;
    ShownMap shown{workspace};
    SolverController solver{workspace, shown};
    Preferences preferences;
    FileController files;
    QSignalSpy opened{&files, &FileController::opened}, done{&files, &FileController::done},
        failed{&files, &FileController::failed};

    Document &document() { return *workspace.document(); }
    bool rests()
    {
        return QTest::qWaitFor([this] { return !files.jobs().isBusy() && !files.isSaving(); },
                               test::patience);
    }
};

} // namespace autocuts::test
