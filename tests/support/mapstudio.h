// The studio's jobs on a map, without a window.
#pragma once

#include "commands/setseamstate.h"
#include "commands/setuvs.h"
#include "model/samples/samples.h"
#include "support/patience.h"
#include "views/control/mapcontroller.h"
#include "views/control/shownmap.h"
#include "views/control/solvercontroller.h"
#include "views/control/workspace.h"

#include <QSignalSpy>
#include <QTest>

#include <array>
#include <memory>

namespace autocuts::test {

//! A document with a sample, and all that works on its map.
struct MapStudio
{
    Workspace workspace;
    ShownMap shown{workspace};
    SolverController solver{workspace, shown};
    MapController map{workspace, solver, shown};
    QSignalSpy done{&map, &MapController::done}, failed{&map, &MapController::failed};

    explicit MapStudio(const char *sample = "bumpycube")
    {
        workspace.open(std::make_unique<Document>(makeSample(QString::fromLatin1(sample)).value()), {});
    }
    Document &document() { return *workspace.document(); }
    UndoStack &stack() { return document().undoStack(); }
    bool ends()
    {
        return QTest::qWaitFor([&] { return !map.jobs().isBusy() && done.count() + failed.count() > 0; },
                               patience);
    }
    bool measures()
    {
        return QTest::qWaitFor([&] { return map.figuresAreFresh(); }, patience);
    }
    void cut(int edgePair)
    {
        pushCommand(std::make_unique<SetSeamState>(
            document(), SetSeamState::Edit::Cut,
            IndexRanges::fromSorted(std::array{2 * edgePair, 2 * edgePair + 1})));
    }
    //! A quick map: every face of the box on its own, side by side and on top of each other as they come.
    void layOut(bool overlapping)
    {
        const MeshData &mesh = document().mesh();
        UvMatrix uv(mesh.cornerCount(), 2);
        for (int f = 0; f < mesh.faceCount(); ++f) {
            const int first = mesh.faceStart[f];
            const Vec3 o = mesh.cornerPosition(first), a = mesh.cornerPosition(first + 1) - o;
            const Vec3 x = a.normalized();
            const Vec3 n = a.cross(Vec3(mesh.cornerPosition(first + 2) - o)).normalized();
            for (int c = first; c < mesh.faceStart[f + 1]; ++c) {
                const Vec3 p = mesh.cornerPosition(c) - o;
                uv.row(c) = 0.05 * Vec2(p.dot(x), p.dot(n.cross(x)));
                if (!overlapping)
                    uv.row(c) += Vec2(0.3 * (f % 40), 0.3 * (f / 40));
            }
        }
        pushCommand(std::make_unique<SetUvs>(document(), UvEdit::Move, uv));
    }
};

} // namespace autocuts::test
