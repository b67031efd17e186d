// How long the GUI's event loop is blocked while the studio works, and how quickly it cancels.
//
//   bench_latency MESH [SECONDS]
//
// Prints one line of JSON per phase: the gaps between turns of the event loop, and the processor time that
// the GUI thread took in each, in milliseconds. First the solver runs with both views drawn; then drawing is
// left out by switching the views' updates off, because software OpenGL says nothing about the latency on a
// real machine. Putting the window together still goes through it: where gaps are long and the processor time
// is short, the GUI thread waited for software OpenGL or for a processor.
#include "bench/loopwatch.h"
#include "support/studiosession.h"
#include "views/actions/studioactions.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTextStream>

using namespace autocuts;
using namespace autocuts::bench;
using namespace autocuts::unwrap;

namespace {

QTextStream &out()
{
    static QTextStream stream(stdout);
    return stream;
}

void tell(const char *phase, const LoopWatch &watch)
{
    out() << watch.told(QLatin1String(phase)) << Qt::endl;
}

template <class Until>
void watchLoop(const char *phase, Until until)
{
    LoopWatch watch;
    (void)QTest::qWaitFor(until, test::patience);
    tell(phase, watch);
}

template <class Action, class Until>
void timeUntil(const char *phase, Action action, Until until)
{
    QElapsedTimer clock;
    clock.start();
    action();
    while (!until() && clock.elapsed() < test::patience)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
    out() << "{\"phase\": \"" << phase << "\", \"ms\": " << clock.elapsed() << "}" << Qt::endl;
}

} // namespace

int main(int argc, char *argv[])
{
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 2) {
        out() << "usage: bench_latency MESH [SECONDS]" << Qt::endl;
        return 2;
    }
    const int milliseconds = 1000 * arguments.value(2, QStringLiteral("10")).toInt();

    test::StudioSession studio(test::Look::Full);
    const auto &solver = studio.context.solver;
    const auto waited = [&](int time) {
        return [clock = QElapsedTimer(), time]() mutable {
            if (!clock.isValid())
                clock.start();
            return clock.elapsed() > time;
        };
    };
    {
        LoopWatch watch;
        studio.window.actions().file().openFile(arguments[1]);
        (void)QTest::qWaitFor([&] { return studio.document() != nullptr; }, test::patience);
        tell("open", watch);
    }
    if (!studio.document()) {
        out() << studio.answers->errors.join(QLatin1Char('\n')) << Qt::endl;
        return 1;
    }
    out() << "{\"triangles\": " << studio.document()->mesh().triangleCount() << "}" << Qt::endl;
    int meshFrames = 0, uvFrames = 0;
    QObject::connect(&studio.window.meshView(), &QOpenGLWidget::frameSwapped, [&] { ++meshFrames; });
    QObject::connect(&studio.window.uvView(), &QOpenGLWidget::frameSwapped, [&] { ++uvFrames; });
    const auto solve = [&](const char *phase) {
        studio.context.solver.restart();
        const int first = solver.status().iteration;
        meshFrames = uvFrames = 0;
        watchLoop(phase, waited(milliseconds));
        const double seconds = 1e-3 * milliseconds;
        out() << "{\"steps_per_second\": " << (solver.status().iteration - first) / seconds
              << ", \"frames_per_second_3d\": " << meshFrames / seconds
              << ", \"frames_per_second_uv\": " << uvFrames / seconds << "}" << Qt::endl;
    };
    solve("solve, both views drawn");
    studio.window.meshView().setUpdatesEnabled(false);
    studio.window.uvView().setUpdatesEnabled(false);
    solve("solve");
    watchLoop("edit while solving", [&, wait = waited(milliseconds / 2), n = 0]() mutable {
        if (++n % 10 == 0)
            studio.action(n % 20 ? "uv.lambdaMore" : "uv.lambdaLess")->trigger();
        return wait();
    });
    timeUntil(
        "pause", [&] { studio.context.solver.pause(); }, [&] { return !solver.isRunning(); });
    watchLoop("settle", [&] { return !solver.isPausing(); });
    watchLoop("measure", [&] { return studio.context.map.figuresAreFresh(); });
    studio.context.map.unwrap(UnwrapQuality::Standard);
    watchLoop("unwrap", waited(milliseconds / 2));
    timeUntil(
        "cancel unwrap", [&] { studio.context.map.cancel(); },
        [&] { return !studio.context.map.jobs().isBusy(); });
    studio.context.map.pack(PackScope::All);
    watchLoop("pack", waited(200));
    timeUntil(
        "cancel pack", [&] { studio.context.map.cancel(); },
        [&] { return !studio.context.map.jobs().isBusy(); });
    return 0;
}
