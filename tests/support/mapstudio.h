// The studio's jobs on a map, without a window.
#pragma once

#include "commands/setseamstate.h"
#include "commands/setuvs.h"
#include "model/samples/samples.h"
#include "support/editsupport.h"
#include "support/patience.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <QSignalSpy>
#include <QTest>

#include <array>
#include <cmath>
#include <memory>

namespace autocuts::test {

//! A document with a sample or a mesh, and all that works on its map.
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
    explicit MapStudio(const MeshPtr &mesh) { workspace.open(std::make_unique<Document>(sceneOf(mesh)), {}); }
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
    //! Side of the cell that layOut() has for a face. With more than one tile, each would be packed by
    //! itself.
    double cell() const { return 1 / std::ceil(std::sqrt(workspace.document()->mesh().faceCount())); }
    //! A quick map in the first tile: every face on its own, side by side or on top of each other as they
    //! come.
    void layOut(bool overlapping)
    {
        const MeshData &mesh = document().mesh();
        UvMatrix uv(mesh.cornerCount(), 2);
        const int perRow = static_cast<int>(std::lround(1 / cell()));
        for (int f = 0; f < mesh.faceCount(); ++f) {
            const int first = mesh.faceStart[f];
            const Vec3 o = mesh.cornerPosition(first), a = mesh.cornerPosition(first + 1) - o;
            const Vec3 x = a.normalized();
            const Vec3 n = a.cross(Vec3(mesh.cornerPosition(first + 2) - o)).normalized();
            for (int c = first; c < mesh.faceStart[f + 1]; ++c) {
                const Vec3 p = mesh.cornerPosition(c) - o;
                uv.row(c) = cell() * (Vec2(0.25, 0.25) + Vec2(p.dot(x), p.dot(n.cross(x))) / 6);
                if (!overlapping)
                    uv.row(c) += cell() * Vec2(f % perRow, f / perRow);
            }
        }
        pushCommand(std::make_unique<SetUvs>(document(), UvEdit::Move, uv));
    }
};

} // namespace autocuts::test
