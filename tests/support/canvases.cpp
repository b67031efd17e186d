#include "support/canvases.h"

#include <QMouseEvent>
#include <QTest>

namespace autocuts::test {

Canvases::Canvases()
    : preferences(folder.filePath(QStringLiteral("preferences.ini"))), shown(workspace),
      solver(workspace, shown), map(workspace, solver), context{workspace, shown, view, preferences, map, solver},
      tools(context), mesh(context, tools), uv(context, tools)
{
    mesh.setGeometry(20, 20, 500, 500);
    uv.setGeometry(560, 20, 500, 500);
    for (Canvas *canvas : {static_cast<Canvas *>(&mesh), static_cast<Canvas *>(&uv)}) {
        canvas->show();
        if (!QTest::qWaitForWindowExposed(canvas))
            qFatal("no window");
    }
}

Document &Canvases::open(std::unique_ptr<Document> document)
{
    workspace.open(std::move(document), {});
    QCoreApplication::processEvents();
    return *workspace.document();
}

void Canvases::lookFromFront()
{
    OrbitCamera camera;
    camera.frame(Vec3::Zero(), 1);
    camera.setDirection(0, 0);
    mesh.setCamera(camera);
}

QPoint Canvases::place(const Canvas &canvas, std::initializer_list<int> soupCorners)
{
    QPointF sum;
    for (int s : soupCorners)
        sum += canvas.screenOf(s).value_or(QPointF(-1e6, -1e6));
    return (sum / static_cast<double>(soupCorners.size())).toPoint();
}

QPoint Canvases::middle(const Canvas &canvas, int triangle)
{
    return place(canvas, {3 * triangle, 3 * triangle + 1, 3 * triangle + 2});
}

void Canvases::select(SelectionMode mode)
{
    Selection selection;
    selection.mode = mode;
    document().setSelection(selection);
}

void Canvases::moveMouse(Canvas &canvas, const QPoint &place, Qt::MouseButtons buttons)
{
    QMouseEvent event(QEvent::MouseMove, place, canvas.mapToGlobal(place), Qt::NoButton, buttons,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(&canvas, &event);
}

} // namespace autocuts::test
