#include "views/tools/rectangles.h"

#include "views/tools/snapping.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace autocuts {

namespace {

constexpr double handleRadius = 8, outlineRadius = 5; //!< pixels
constexpr QSizeF nameSize(70, 20);                    //!< size of the area of the name

} // namespace

QRectF screenBox(const LayoutRectangle &rectangle, const MapCamera &camera)
{
    return QRectF(camera.toScreen(rectangle.lower), camera.toScreen(rectangle.upper)).normalized();
}

QPointF handleOf(const QRectF &box, int x, int y)
{
    return box.center() + QPointF(x * box.width() / 2, -y * box.height() / 2);
}

RectangleGrip gripAt(const std::vector<LayoutRectangle> &rectangles, int active, const MapCamera &camera,
                     const QPointF &pixel)
{
    for (const LayoutRectangle &rectangle : rectangles) {
        if (rectangle.id != active)
            continue;
        // Corners are tested first, so that they can be reached when a side is short.
        for (const auto &[x, y] :
             {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            const QPointF offset = handleOf(screenBox(rectangle, camera), x, y) - pixel;
            if (std::max(std::abs(offset.x()), std::abs(offset.y())) <= handleRadius)
                return {active, x, y};
        }
    }
    for (auto it = rectangles.rbegin(); it != rectangles.rend(); ++it) { // the last one is drawn on top
        const QRectF box = screenBox(*it, camera);
        const qreal r = outlineRadius;
        const bool onOutline =
            box.adjusted(-r, -r, r, r).contains(pixel) && !box.adjusted(r, r, -r, -r).contains(pixel);
        if (onOutline || QRectF(box.topLeft(), nameSize.boundedTo(box.size())).contains(pixel))
            return {it->id, 0, 0};
    }
    return {};
}

int rectangleAround(const std::vector<LayoutRectangle> &rectangles, const Vec2 &uv)
{
    int found = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (const LayoutRectangle &rectangle : rectangles) {
        const double area = (rectangle.upper - rectangle.lower).prod();
        if ((uv.array() >= rectangle.lower.array()).all() && (uv.array() <= rectangle.upper.array()).all() &&
            area <= smallest) {
            smallest = area;
            found = rectangle.id;
        }
    }
    return found;
}

LayoutRectangle dragged(LayoutRectangle rectangle, const RectangleGrip &grip, const Vec2 &by,
                        const Vec2 &snapStep)
{
    if (!grip.isHandle()) {
        const Vec2 move = snappedMove(by, Eigen::AlignedBox2d(rectangle.lower, rectangle.upper), snapStep);
        rectangle.lower += move;
        rectangle.upper += move;
        return rectangle;
    }
    const int sides[] = {grip.x, grip.y};
    for (int axis = 0; axis < 2; ++axis) {
        if (sides[axis] == 0)
            continue;
        double &side = sides[axis] < 0 ? rectangle.lower[axis] : rectangle.upper[axis];
        side += by[axis];
        if (snapStep[axis] > 0)
            side = std::round(side / snapStep[axis]) * snapStep[axis];
    }
    return rectangle;
}

std::unique_ptr<EditRectangles> assignFaces(Document &document, int id, const QList<int> &faces)
{
    std::vector<LayoutRectangle> changed;
    for (LayoutRectangle rectangle : document.constraints().rectangles) {
        QList<int> after;
        if (rectangle.id == id)
            std::set_union(rectangle.faces.begin(), rectangle.faces.end(), faces.begin(), faces.end(),
                           std::back_inserter(after));
        else
            std::set_difference(rectangle.faces.begin(), rectangle.faces.end(), faces.begin(), faces.end(),
                                std::back_inserter(after));
        if (after == rectangle.faces)
            continue;
        rectangle.faces = std::move(after);
        changed.push_back(std::move(rectangle));
    }
    return std::make_unique<EditRectangles>(document, EditRectangles::Edit::Assign, changed);
}

} // namespace autocuts
