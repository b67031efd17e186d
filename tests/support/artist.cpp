#include "support/artist.h"

#include "support/canvases.h"
#include "support/editsupport.h"
#include "views/actions/studioactions.h"

#include <QElapsedTimer>

namespace autocuts::test {

namespace {

constexpr int stepsPerDrag = 12; // between two places
constexpr int searchStep = 12;   // pixels

} // namespace

Artist::Artist(const QSize &window, Look look) : studio(look)
{
    studio.setQuality(unwrap::UnwrapQuality::Standard);
    studio.window.resize(window);
    QCoreApplication::processEvents();
}

Canvas &Artist::model()
{
    return studio.window.meshView();
}

Canvas &Artist::map()
{
    return studio.window.uvView();
}

bool Artist::open(const QString &path)
{
    studio.window.actions().file().openFile(path);
    return QTest::qWaitFor([&] { return studio.document() && !studio.context.files.jobs().isBusy(); },
                           patience);
}

bool Artist::runJob(const char *action)
{
    studio.action(action)->trigger();
    return studio.jobsRest() && studio.measured();
}

QString Artist::undoAndRedo()
{
    const DocumentState after = withoutSelection(document().state());
    const QString text = document().undoStack().undoText();
    studio.action("edit.undo")->trigger();
    if (withoutSelection(document().state()) == after)
        return QStringLiteral("undo changed nothing: ") + text;
    studio.action("edit.redo")->trigger();
    if (!(withoutSelection(document().state()) == after))
        return QStringLiteral("redo is not what was undone: ") + text;
    return document().validate();
}

template <class Pick>
QList<QPoint> Artist::found(const Canvas &canvas, int count, Pick pick) const
{
    QList<QPoint> all;
    for (int y = searchStep; y < canvas.height(); y += searchStep) {
        for (int x = searchStep; x < canvas.width(); x += searchStep) {
            const std::optional<QPoint> place = pick(QPoint(x, y));
            if (place && canvas.rect().contains(*place))
                all << *place;
        }
    }
    QList<QPoint> some;
    for (int i = 0; i < count && !all.isEmpty(); ++i)
        some << all[static_cast<qsizetype>((i + 0.5) * double(all.size()) / count)];
    return some;
}

QList<QPoint> Artist::placesOn(const Canvas &canvas, int count) const
{
    return found(canvas, count, [&](const QPoint &place) -> std::optional<QPoint> {
        return canvas.pick(place).triangle >= 0 ? std::optional(place) : std::nullopt;
    });
}

QList<QPoint> Artist::edgesOn(const Canvas &canvas, int count) const
{
    return found(canvas, count, [&](const QPoint &place) -> std::optional<QPoint> {
        const PickResult pick = canvas.pick(place);
        const auto &adjacency = studio.context.workspace.document()->adjacency();
        if (pick.triangle < 0 || pick.edge < 0 || adjacency.isBoundary(pick.edge))
            return std::nullopt;
        return Canvases::place(canvas, {pick.side, nextSoupCorner(pick.side)});
    });
}

QPoint Artist::emptyPlace(int radius)
{
    const Canvas &canvas = studio.window.uvView();
    for (int y = radius; y + radius < canvas.height(); y += searchStep) {
        for (int x = radius; x + radius < canvas.width(); x += searchStep) {
            if (canvas.pickBox(QRectF(x - radius, y - radius, 2 * radius, 2 * radius)).corners.empty() &&
                canvas.pick(QPoint(x, y)).triangle < 0)
                return {x, y};
        }
    }
    return canvas.rect().center();
}

QPoint Artist::pixelOf(const Vec2 &uv)
{
    return studio.window.uvView().camera().toScreen(uv).toPoint();
}

template <class Events>
void Artist::timed(const char *gesture, Events events)
{
    QElapsedTimer clock;
    clock.start();
    events();
    QCoreApplication::processEvents();
    mTimes[QString::fromUtf8(gesture)].push_back(double(clock.nsecsElapsed()) * 1e-6);
}

void Artist::hover(const char *gesture, Canvas &canvas, const QList<QPoint> &places)
{
    for (const QPoint &place : places)
        timed(gesture, [&] { Canvases::moveMouse(canvas, place); });
}

void Artist::click(const char *gesture, Canvas &canvas, const QPoint &place, Qt::KeyboardModifiers modifiers)
{
    Canvases::moveMouse(canvas, place, Qt::NoButton, modifiers);
    timed(gesture, [&] { QTest::mouseClick(&canvas, Qt::LeftButton, modifiers, place); });
}

void Artist::doubleClick(const char *gesture, Canvas &canvas, const QPoint &place)
{
    click(gesture, canvas, place);
    timed(gesture, [&] { QTest::mouseDClick(&canvas, Qt::LeftButton, {}, place); });
}

void Artist::drag(const char *gesture, Canvas &canvas, const QList<QPoint> &places,
                  Qt::KeyboardModifiers modifiers)
{
    Canvases::moveMouse(canvas, places.first(), Qt::NoButton, modifiers);
    timed(gesture, [&] { QTest::mousePress(&canvas, Qt::LeftButton, modifiers, places.first()); });
    for (qsizetype i = 1; i < places.size(); ++i) {
        for (int step = 1; step <= stepsPerDrag; ++step) {
            const QPoint place = places[i - 1] + (places[i] - places[i - 1]) * step / stepsPerDrag;
            timed(gesture, [&] { Canvases::moveMouse(canvas, place, Qt::LeftButton, modifiers); });
        }
    }
    timed(gesture, [&] { QTest::mouseRelease(&canvas, Qt::LeftButton, modifiers, places.last()); });
}

void Artist::type(const char *gesture, Canvas &canvas, const QString &keys)
{
    for (const QChar key : keys)
        timed(gesture, [&] { QTest::keyClick(&canvas, key.toLatin1()); });
}

} // namespace autocuts::test
