// How long the GUI's event loop is blocked while a model is opened, looked at and drawn in all ways.
//
//   bench_drawing MESH [PICTURE]
//
// Prints the OpenGL that draws, then a line of JSON per phase: the gaps between turns of the event loop, the
// processor time that the GUI thread took in each, and the events of the worst one, in milliseconds. Each
// event has a turn of its own, and time to be drawn. With software OpenGL the gaps say nothing about a real
// machine.
#include "bench/loopwatch.h"
#include "support/studiosession.h"
#include "views/actions/studioactions.h"
#include "views/canvas/meshview.h"
#include "views/canvas/uvview.h"

#include <QApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QTextStream>
#include <QWheelEvent>

using namespace autocuts;
using namespace autocuts::bench;
using namespace Qt::Literals::StringLiterals;

namespace {

QTextStream &out()
{
    static QTextStream stream(stdout);
    return stream;
}

//! Does something and watches what comes of it.
template <class Action>
void watch(const QString &phase, Action action, int restMilliseconds = 300)
{
    const LoopWatch loop;
    action();
    QTest::qWait(restMilliseconds);
    out() << loop.told(phase) << Qt::endl;
}

constexpr int steps = 40;
constexpr int stepTime = 20; // milliseconds

void turnWheel(QWidget &view)
{
    for (int step = 0; step < steps; ++step) {
        const QPointF at = view.rect().center();
        QWheelEvent event(at, view.mapToGlobal(at), {}, {0, step < steps / 2 ? 120 : -120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &event);
        QTest::qWait(stepTime);
    }
}

void drag(QWidget &view, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    const QPoint from = view.rect().center();
    if (button != Qt::NoButton)
        QTest::mousePress(&view, button, modifiers, from);
    for (int step = 0; step < steps; ++step) {
        const QPoint to = from + QPoint(step, step < steps / 2 ? step : steps - step) * 3;
        QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(&view, &event);
        QTest::qWait(stepTime);
    }
    if (button != Qt::NoButton)
        QTest::mouseRelease(&view, button, modifiers, from);
}

} // namespace

int main(int argc, char *argv[])
{
    TimedApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 2) {
        out() << "usage: bench_drawing MESH [PICTURE]" << Qt::endl;
        return 2;
    }
    test::StudioSession studio(test::Look::Full);
    MeshView &model = studio.window.meshView();
    UvView &map = studio.window.uvView();
    QTest::qWait(500);
    model.makeCurrent();
    out() << reinterpret_cast<const char *>(
                 QOpenGLContext::currentContext()->functions()->glGetString(GL_RENDERER))
          << Qt::endl;
    model.doneCurrent();
    watch(
        u"open"_s,
        [&] {
            studio.window.actions().file().openFile(arguments[1]);
            (void)QTest::qWaitFor([&] { return studio.document() != nullptr; }, test::patience);
        },
        3000);
    if (!studio.document()) {
        out() << studio.answers->errors.join(QLatin1Char('\n')) << Qt::endl;
        return 1;
    }
    out() << "{\"triangles\": " << studio.document()->mesh().triangleCount() << "}" << Qt::endl;
    if (!studio.measured())
        out() << "not measured in time" << Qt::endl;
    for (Canvas *view : {static_cast<Canvas *>(&model), static_cast<Canvas *>(&map)}) {
        const auto named = [&](const char *phase) {
            return QLatin1String(phase) + QLatin1String(view == &map ? " of the map" : " of the model");
        };
        watch(named("wheel"), [&] { turnWheel(*view); });
        watch(named("hover"), [&] { drag(*view, Qt::NoButton, {}); });
        watch(named("orbit or pan"), [&] { drag(*view, Qt::MiddleButton, {}); });
        watch(named("pan"), [&] { drag(*view, Qt::MiddleButton, Qt::ShiftModifier); });
    }
    watch(u"resize"_s, [&] {
        const QSize size = studio.window.size();
        for (int step = 1; step <= 10; ++step) {
            studio.window.resize(size + QSize(8 * step, 6 * step));
            QTest::qWait(4 * stepTime);
        }
        studio.window.resize(size);
    });
    const auto show = [&](const QString &phase, auto change) {
        watch(
            phase,
            [&] {
                ViewOptions options = studio.context.view.options();
                change(options);
                studio.context.view.setOptions(options);
            },
            1500);
    };
    show(u"checker"_s, [](ViewOptions &options) { options.pattern = Pattern::Checker; });
    show(u"letters"_s, [](ViewOptions &options) { options.pattern = Pattern::Lettered; });
    if (arguments.size() > 2) {
        show(u"picture"_s, [&](ViewOptions &options) {
            options.texturePath = arguments[2];
            options.pattern = Pattern::Texture;
        });
    }
    show(u"no pattern"_s, [](ViewOptions &options) { options.pattern = Pattern::None; });
    show(u"stretch"_s, [](ViewOptions &options) { options.coloring = Coloring::SignedStretch; });
    show(u"islands"_s, [](ViewOptions &options) { options.coloring = Coloring::Islands; });
    show(u"x-ray"_s, [](ViewOptions &options) { options.xray = true; });
    show(u"smooth"_s, [](ViewOptions &options) {
        options.xray = false;
        options.smoothShading = true;
    });
    watch(u"select all"_s, [&] { studio.press(Qt::Key_A); });
    return 0;
}
