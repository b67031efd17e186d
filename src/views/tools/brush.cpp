#include "views/tools/brush.h"

#include "views/canvas/scenecontent.h"
#include "views/canvas/toolcanvas.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/studiocontext.h"

#include <QCoreApplication>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_set>

namespace autocuts {

namespace {

struct BrushTexts
{
    Q_DECLARE_TR_FUNCTIONS(Brush)
};

//! Collects the sides of faces under a brush.
class Footprint
{
public:
    Footprint(const ToolCanvas &canvas, const QPointF &middle, double radius)
        : mCanvas(canvas), mTopology(canvas.content().topology()), mMiddle(middle), mRadius(radius)
    {}

    //! Visits faces across the sides under the brush.
    void flood(int face)
    {
        const bool front = isFront(face);
        faces.push_back({face, mRadius});
        std::vector<int> queue{face};
        std::unordered_set<int> seen{face};
        for (std::size_t head = 0; head < queue.size(); ++head) {
            for (int neighbour : addFace(queue[head], faces[head].distance)) {
                if (!seen.insert(neighbour).second || isFront(neighbour) != front)
                    continue;
                queue.push_back(neighbour);
                faces.push_back({neighbour, mRadius});
            }
        }
    }

    //! \param nearest receives the distance of the nearest side under the brush
    //! \returns the faces on the other sides of the edges under the brush
    std::vector<int> addFace(int face, double &nearest)
    {
        std::vector<int> neighbours;
        const auto &triangleFace = mCanvas.content().mesh()->triangleFace;
        const auto pairCount = static_cast<int>(mCanvas.content().mesh()->edgePairs.size());
        for (const int s : mCanvas.content().mesh()->soupCornersOf(face)) {
            const int edge = mTopology.sideEdge[s];
            if (edge < 0 || edge >= pairCount)
                continue; // diagonals and boundaries
            const double distance = distanceTo(s);
            if (!(distance < mRadius))
                continue;
            touches.push_back({edge, distance});
            nearest = std::min(nearest, distance);
            if (mCanvas.kind() == ToolCanvas::Kind::Map && mCanvas.studio().shownMap.isSeam(edge))
                continue;
            for (int side : mTopology.edgeSides[edge]) {
                if (triangleFace[side / 3] != face)
                    neighbours.push_back(triangleFace[side / 3]);
            }
        }
        return neighbours;
    }

    std::vector<BrushTouch> touches;
    std::vector<BrushTouch> faces;

private:
    double distanceTo(int side) const
    {
        const auto a = mCanvas.screenOf(side), b = mCanvas.screenOf(nextSoupCorner(side));
        if (!a || !b)
            return mRadius;
        return nearestOnSegment(mMiddle.x(), mMiddle.y(), a->x(), a->y(), b->x(), b->y()).distance;
    }

    bool isFront(int face) const
    {
        double area = 0;
        for (const int t : mCanvas.content().mesh()->trianglesOf(face)) {
            const auto a = mCanvas.screenOf(3 * t), b = mCanvas.screenOf(3 * t + 1),
                       c = mCanvas.screenOf(3 * t + 2);
            if (a && b && c)
                area += (b->x() - a->x()) * (c->y() - a->y()) - (b->y() - a->y()) * (c->x() - a->x());
        }
        return area < 0; // the y axis of the screen points down
    }

    const ToolCanvas &mCanvas;
    const SoupTopology &mTopology;
    const QPointF mMiddle;
    const double mRadius;
};

} // namespace

double Brush::effectAt(double distance) const
{
    const double full = hardness * radius;
    if (distance <= full)
        return strength;
    if (!(distance < radius))
        return 0;
    const double t = (radius - distance) / (radius - full);
    return strength * t * t * (3 - 2 * t);
}

bool Brush::takeWheel(const QWheelEvent &event)
{
    // Some platforms report horizontal scrolling while Alt is held.
    const QPoint angle = event.angleDelta();
    const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
    if (event.modifiers() == Qt::ShiftModifier)
        radius = std::clamp(radius * std::pow(1.15, notches), minRadius, maxRadius);
    else if (event.modifiers() == Qt::ControlModifier)
        strength = std::clamp(strength + 0.05 * notches, 0.05, 1.0);
    else if (event.modifiers() == Qt::AltModifier)
        hardness = std::clamp(hardness + 0.05 * notches, 0.0, 1.0);
    else
        return false;
    return true;
}

std::vector<ToolOption> brushOptions(const Brush &brush, const std::function<void(const Brush &)> &set)
{
    const auto percent = [](double share) { return std::round(100 * share); };
    const auto field = [&](double Brush::*member, double unit) {
        return [=](double value) {
            Brush changed = brush;
            changed.*member = value / unit;
            set(changed);
        };
    };
    return {ToolOption::number(BrushTexts::tr("Size"), BrushTexts::tr("Radius of the brush; Shift+wheel"),
                               brush.radius, Brush::minRadius, Brush::maxRadius, BrushTexts::tr(" px"),
                               field(&Brush::radius, 1)),
            ToolOption::number(BrushTexts::tr("Strength"), BrushTexts::tr("Effect in the middle; Ctrl+wheel"),
                               percent(brush.strength), 5, 100, BrushTexts::tr(" %"),
                               field(&Brush::strength, 100)),
            ToolOption::number(BrushTexts::tr("Hardness"),
                               BrushTexts::tr("Share of the brush with full strength; Alt+wheel"),
                               percent(brush.hardness), 0, 100, BrushTexts::tr(" %"),
                               field(&Brush::hardness, 100))};
}

namespace {

//! The sides of faces under a brush; nothing beside the model.
std::optional<Footprint> footprintOf(const ToolCanvas &canvas, const QPointF &middle, const PickResult &pick,
                                     double radius)
{
    const MeshData *mesh = canvas.content().mesh();
    const int triangle = pick.triangle >= 0 ? pick.triangle : pick.side >= 0 ? pick.side / 3 : -1;
    if (!mesh || triangle < 0)
        return std::nullopt;
    Footprint footprint(canvas, middle, radius);
    footprint.flood(mesh->triangleFace[triangle]);
    return footprint;
}

} // namespace

std::vector<QPointF> dabsBetween(const QPointF &from, const QPointF &to, double radius)
{
    constexpr int mostDabs = 8; // chosen by hand
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    const int dabs = std::clamp(static_cast<int>(std::ceil(length / (0.3 * radius))), 1, mostDabs);
    std::vector<QPointF> middles;
    for (int i = 1; i < dabs; ++i)
        middles.push_back(from + way * i / dabs);
    middles.push_back(to);
    return middles;
}

std::vector<BrushTouch> edgesUnderBrush(const ToolCanvas &canvas, const QPointF &middle,
                                        const PickResult &pick, double radius)
{
    std::optional<Footprint> footprint = footprintOf(canvas, middle, pick, radius);
    return footprint ? std::move(footprint->touches) : std::vector<BrushTouch>();
}

std::vector<BrushTouch> facesUnderBrush(const ToolCanvas &canvas, const QPointF &middle,
                                        const PickResult &pick, double radius)
{
    std::optional<Footprint> footprint = footprintOf(canvas, middle, pick, radius);
    if (!footprint)
        return {};
    if (pick.triangle >= 0)
        footprint->faces.front().distance = 0;
    return std::move(footprint->faces);
}

} // namespace autocuts
