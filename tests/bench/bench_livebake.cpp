// How often a bake follows the map while the map changes without a pause.
//
//   bench_livebake MESH [SECONDS]
//
// Prints a line of JSON per map: how long the first picture and all samples took, then updates per second
// while a solve runs and the map moves, with both views drawn and with drawing left out, because software
// OpenGL says nothing about a real machine.
#include "support/studiosession.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/pictures/livebake.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/state/viewstate.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTextStream>
#include <QTimer>

using namespace autocuts;

namespace {

constexpr int patience = 600'000; // milliseconds

//! Pictures per second while the solver runs, and the shown map moves 50 times a second.
double rateOf(test::StudioSession &studio, double seconds)
{
    LiveBake &live = studio.context.liveBake;
    ShownMap &shown = studio.context.shownMap;
    studio.action("uv.restart")->trigger();
    studio.press(Qt::Key_Space);
    QTimer mover;
    int moves = 0;
    QObject::connect(&mover, &QTimer::timeout, [&] {
        const auto map = studio.context.solver.map();
        if (!map)
            return;
        shown.showMap(map->uv.array() + (moves++ % 2 == 0 ? 0.001 : -0.001));
    });
    mover.start(20);
    QElapsedTimer clock;
    clock.start();
    const int before = live.updates();
    QTest::qWait(int(1e3 * seconds));
    const double rate = (live.updates() - before) / (1e-3 * double(clock.elapsed()));
    mover.stop();
    studio.press(Qt::Key_Space);
    studio.solverRests();
    return rate;
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    QTextStream out(stdout);
    if (argc < 2) {
        out << "bench_livebake MESH [SECONDS]\n";
        return 2;
    }
    const double seconds = argc > 2 ? QString::fromLocal8Bit(argv[2]).toDouble() : 5;
    for (const char *map : {"ao", "normal"}) {
        test::StudioSession studio(test::Look::Full);
        studio.context.files.open(QString::fromLocal8Bit(argv[1]));
        studio.jobsRest();
        LiveBake &live = studio.context.liveBake;
        QElapsedTimer clock;
        clock.start();
        studio.press(Qt::Key_Space); // a first map
        if (!QTest::qWaitFor([&] { return studio.context.shownMap.isLive(); }, patience))
            return 1;
        studio.press(Qt::Key_Space);
        studio.solverRests();
        clock.restart();
        live.start({}, QString::fromLatin1(map));
        if (!QTest::qWaitFor([&] { return live.updates() > 0; }, patience))
            return 1;
        const qint64 first = clock.elapsed();
        if (!QTest::qWaitFor([&] { return !live.isRefining(); }, patience))
            return 1;
        const qint64 all = clock.elapsed();
        ViewOptions options = studio.context.view.options();
        options.pattern = Pattern::Baked;
        studio.context.view.setOptions(options);
        const double drawn = rateOf(studio, seconds);
        studio.window.meshView().setUpdatesEnabled(false);
        studio.window.uvView().setUpdatesEnabled(false);
        const double hidden = rateOf(studio, seconds);
        out << "{\"map\": \"" << map << "\", \"triangles\": " << studio.document()->mesh().triangleCount()
            << ", \"first_ms\": " << first << ", \"all_ms\": " << all << ", \"updates_per_s\": " << drawn
            << ", \"updates_per_s_undrawn\": " << hidden << "}" << Qt::endl;
    }
    return 0;
}
