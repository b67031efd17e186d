// An artist at the studio: gestures with real events, each of which is timed.
#pragma once

#include "support/studiosession.h"
#include "views/canvas/canvas.h"

#include <map>
#include <vector>

namespace autocuts::test {

//! Works in the whole window. What a gesture took is kept by its name: the milliseconds that the GUI thread
//! was busy with each of its events and what followed from them at once.
class Artist
{
public:
    using Times = std::map<QString, std::vector<double>>;

    explicit Artist(const QSize &window, Look look = Look::Quick);

    StudioSession studio;
    Canvas &model();
    Canvas &map();
    Document &document() { return *studio.document(); }
    const Times &times() const { return mTimes; }

    bool open(const QString &path);
    void use(const char *tool) { studio.action(tool)->trigger(); }
    //! Triggers an action and waits until no job runs any more.
    bool runJob(const char *action);
    //! Takes the last edit back and does it again. Returns what is wrong; empty: nothing.
    QString undoAndRedo();

    //! Pixels where the model or the map is seen, spread over the canvas.
    QList<QPoint> placesOn(const Canvas &canvas, int count) const;
    //! Pixels of edges (of polygons) that are seen, spread over the canvas.
    QList<QPoint> edgesOn(const Canvas &canvas, int count) const;
    //! A pixel of the map with nothing within some pixels around; the middle when there is none.
    QPoint emptyPlace(int radius);
    //! Pixel of a place in the map.
    QPoint pixelOf(const Vec2 &uv);

    void hover(const char *gesture, Canvas &canvas, const QList<QPoint> &places);
    void click(const char *gesture, Canvas &canvas, const QPoint &place,
               Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void doubleClick(const char *gesture, Canvas &canvas, const QPoint &place);
    //! Drags in many small steps through all places.
    void drag(const char *gesture, Canvas &canvas, const QList<QPoint> &places,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void type(const char *gesture, Canvas &canvas, const QString &keys);

private:
    template <class Pick>
    QList<QPoint> found(const Canvas &canvas, int count, Pick pick) const;
    template <class Events>
    void timed(const char *gesture, Events events);

    Times mTimes;
};

} // namespace autocuts::test
