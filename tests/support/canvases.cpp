#include "support/canvases.h"

#include "support/editsupport.h"
#include "views/tools/studiotools.h"

#include <QMouseEvent>
#include <QTest>

namespace autocuts::test {

Canvases::Canvases()
    : preferences(folder.filePath(QStringLiteral("preferences.ini"))), shown(workspace),
      solver(workspace, shown), map(workspace, solver, shown),
      files(workspace, solver, preferences, folder.filePath(QStringLiteral("recovery"))),
      actions(preferences), pictures(workspace, view),
      liveBake(workspace, shown), context{workspace, shown, view,    preferences, solver,
                                          map,       files, actions, pictures,    liveBake},
      tools(context), mesh(context, tools), uv(context, tools)
{
    addStudioTools(tools, context);
    mesh.setGeometry(20, 20, 500, 500);
    uv.setGeometry(560, 20, 500, 500);
    for (Canvas *canvas : {static_cast<Canvas *>(&mesh), static_cast<Canvas *>(&uv)}) {
        canvas->show();
        if (!QTest::qWaitForWindowExposed(canvas))
            qFatal("no window");
    }
}

std::unique_ptr<Canvases> Canvases::onGrid(int quadsPerSide)
{
    auto canvases = std::make_unique<Canvases>();
    canvases->open(layoutDocument(grid(quadsPerSide)));
    MapCamera camera;
    camera.setCentre(Vec2(1, 0.5));
    camera.setScale(200);
    canvases->uv.setCamera(camera);
    return canvases;
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

QPoint Canvases::middleOfEdge(const Canvas &canvas, int edge)
{
    const int side = canvas.content().topology().edgeSides[edge][0];
    return place(canvas, {side, nextSoupCorner(side)});
}

int Canvases::edgeBetween(const Vec3 &a, const Vec3 &b)
{
    const MeshAdjacency &adjacency = document().adjacency();
    const PositionMatrix &positions = document().mesh().positions;
    for (int e = 0; e < adjacency.edgeCount(); ++e) {
        const auto &ends = adjacency.edgeVertices(e);
        const Vec3 p = positions.row(ends[0]), q = positions.row(ends[1]);
        if (!adjacency.isDiagonal(e) && ((p == a && q == b) || (p == b && q == a)))
            return e;
    }
    return -1;
}

void Canvases::moveMouse(Canvas &canvas, const QPoint &place, Qt::MouseButtons buttons,
                         Qt::KeyboardModifiers modifiers)
{
    QMouseEvent event(QEvent::MouseMove, place, canvas.mapToGlobal(place), Qt::NoButton, buttons, modifiers);
    QCoreApplication::sendEvent(&canvas, &event);
}

void Canvases::drag(Canvas &canvas, const QList<QPoint> &places, Qt::KeyboardModifiers modifiers)
{
    constexpr int steps = 5; // between two places
    QTest::mousePress(&canvas, Qt::LeftButton, modifiers, places.first());
    for (qsizetype i = 1; i < places.size(); ++i) {
        for (int step = 1; step <= steps; ++step)
            moveMouse(canvas, places[i - 1] + (places[i] - places[i - 1]) * step / steps, Qt::LeftButton,
                      modifiers);
    }
    QTest::mouseRelease(&canvas, Qt::LeftButton, modifiers, places.last());
}

void Canvases::turnWheel(Canvas &canvas, const QPoint &place, int angle, Qt::KeyboardModifiers modifiers)
{
    QWheelEvent event(place, canvas.mapToGlobal(place), {}, {0, angle}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&canvas, &event);
}

int countNear(const QImage &picture, const QColor &color, int distance)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb c = picture.pixel(x, y);
            count += std::abs(qRed(c) - color.red()) + std::abs(qGreen(c) - color.green()) +
                         std::abs(qBlue(c) - color.blue()) <=
                     distance;
        }
    }
    return count;
}

} // namespace autocuts::test
