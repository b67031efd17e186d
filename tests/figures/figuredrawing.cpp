#include "figures/figuredrawing.h"

#include "solver/search/trianglekernel.h"

#include <Eigen/Geometry>

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace autocuts::figures {

namespace {

constexpr int panelSize = 300, captionHeight = 62, gap = 10;
constexpr double blueAt = 6; // energy
constexpr double redFrom = 0.05;

//! The edge pair at each triangle side, -1 at borders.
std::vector<int> edgesOfSides(const MeshData &mesh)
{
    std::vector<int> edges(mesh.soupCornerCount(), -1);
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        for (int which = 0; which < 2; ++which)
            edges[3 * mesh.edgePairs[e].triangle[which] + mesh.edgePairs[e].side(which)] =
                static_cast<int>(e);
    }
    return edges;
}

//! Maps a box of points into a rectangle, as large as it fits.
class Fit
{
public:
    Fit(const std::vector<Vec2> &points, const QRectF &place)
    {
        Vec2 low = points.front(), high = low;
        for (const Vec2 &p : points) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        mMiddle = 0.5 * (low + high);
        mScale = 0.94 * std::min(place.width() / std::max(high.x() - low.x(), 1e-12),
                                 place.height() / std::max(high.y() - low.y(), 1e-12));
        mCentre = place.center();
    }
    QPointF operator()(const Vec2 &p) const
    {
        return mCentre + QPointF(mScale * (p.x() - mMiddle.x()), -mScale * (p.y() - mMiddle.y()));
    }

private:
    Vec2 mMiddle;
    double mScale;
    QPointF mCentre;
};

//! Colours of a surface, of the fill and the lines of a map, and of red lines on white and on both.
QColor surfaceColor(double light)
{
    return QColor(static_cast<int>(225 * light), static_cast<int>(222 * light),
                  static_cast<int>(214 * light));
}

QColor mapColor(double part)
{
    return QColor(static_cast<int>(245 - 185 * part), static_cast<int>(243 - 140 * part),
                  static_cast<int>(238 - 38 * part));
}

//! What the pictures are made of: smaller files than with all colours, and smoother than with the usual 216.
QList<QRgb> palette()
{
    QList<QRgb> colors;
    const auto ramp = [&](const QColor &from, const QColor &to, int count) {
        for (int i = 0; i < count; ++i) {
            const double t = double(i) / (count - 1);
            colors << qRgb(static_cast<int>(std::lround(from.red() + t * (to.red() - from.red()))),
                           static_cast<int>(std::lround(from.green() + t * (to.green() - from.green()))),
                           static_cast<int>(std::lround(from.blue() + t * (to.blue() - from.blue()))));
        }
    };
    const QColor red(205, 25, 25);
    ramp(surfaceColor(0.28), surfaceColor(1), 64);
    ramp(surfaceColor(1), Qt::white, 8);
    ramp(mapColor(0), mapColor(1), 56);
    ramp(mapColor(0).darker(112), mapColor(1).darker(112), 32);
    ramp(mapColor(0), Qt::white, 6);
    ramp(mapColor(1), Qt::white, 8);
    ramp(red, Qt::white, 16);
    ramp(red, mapColor(1), 12);
    ramp(red, surfaceColor(0.45), 16);
    ramp(red, surfaceColor(0.95), 16);
    ramp(Qt::black, Qt::white, 16);
    return colors;
}

void drawTriangle(QPainter &painter, const std::array<QPointF, 3> &p, const QColor &fill)
{
    painter.setPen(QPen(fill.darker(112), 0.4));
    painter.setBrush(fill);
    painter.drawConvexPolygon(p.data(), 3);
}

void drawRed(QPainter &painter, const QPointF &a, const QPointF &b, double redness)
{
    if (redness < redFrom)
        return;
    painter.setPen(QPen(QColor(205, 25, 25, static_cast<int>(255 * std::min(1.0, redness))), 1.7));
    painter.drawLine(a, b);
}

} // namespace

double energyOf(const Soup &soup, const std::vector<double> &x, int triangle)
{
    return search::triangleEnergy(&x[6 * static_cast<std::size_t>(triangle)], soup.basis[triangle]);
}

void drawSurface(QPainter &painter, const QRectF &place, const Soup &soup, const std::vector<double> &redness,
                 const View &view)
{
    const MeshData &mesh = *soup.mesh;
    const std::vector<int> edgeOf = edgesOfSides(mesh);
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(view.pitch * std::numbers::pi / 180, Vec3::UnitX()) *
                                  Eigen::AngleAxisd(view.yaw * std::numbers::pi / 180, Vec3::UnitY()))
                                     .toRotationMatrix();
    std::vector<Vec3> seen;
    std::vector<Vec2> flat;
    for (int c = 0; c < mesh.soupCornerCount(); ++c) {
        seen.push_back(turn * mesh.cornerPosition(mesh.cornerOfSoup(c)));
        flat.emplace_back(seen.back().x(), seen.back().y());
    }
    const Fit fit(flat, place);
    std::vector<int> order(mesh.triangleCount());
    std::iota(order.begin(), order.end(), 0);
    const auto depth = [&](int t) { return seen[3 * t].z() + seen[3 * t + 1].z() + seen[3 * t + 2].z(); };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth(a) < depth(b); });
    for (const int t : order) {
        const Vec3 normal =
            (seen[3 * t + 1] - seen[3 * t]).cross(seen[3 * t + 2] - seen[3 * t]).stableNormalized();
        if (normal.z() <= 0)
            continue;
        const double light = 0.35 + 0.65 * std::max(0.0, normal.dot(Vec3(0.3, 0.5, 0.8).normalized()));
        const std::array<QPointF, 3> p{fit(flat[3 * t]), fit(flat[3 * t + 1]), fit(flat[3 * t + 2])};
        drawTriangle(painter, p, surfaceColor(light));
        for (int k = 0; k < 3; ++k) {
            const int e = edgeOf[3 * t + k];
            if (e >= 0)
                drawRed(painter, p[k], p[(k + 1) % 3], redness[e]);
        }
    }
}

void drawMap(QPainter &painter, const QRectF &place, const Soup &soup, const Panel &panel)
{
    const MeshData &mesh = *soup.mesh;
    const std::vector<int> edgeOf = edgesOfSides(mesh);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < panel.x.size(); i += 2)
        points.emplace_back(panel.x[i], panel.x[i + 1]);
    const Fit fit(points, place);
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        const double energy = energyOf(soup, panel.x, t);
        const double part = std::clamp((energy - 4) / (blueAt - 4), 0.0, 1.0);
        const std::array<QPointF, 3> p{fit(points[3 * t]), fit(points[3 * t + 1]), fit(points[3 * t + 2])};
        drawTriangle(painter, p, mapColor(part));
    }
    for (int side = 0; side < mesh.soupCornerCount(); ++side) {
        const int e = edgeOf[side];
        drawRed(painter, fit(points[side]), fit(points[side / 3 * 3 + (side + 1) % 3]),
                e < 0 ? 1 : panel.redness[e]);
    }
}

bool drawFigure(const QString &path, const Soup &soup, const std::vector<Panel> &panels, const View &view)
{
    const int count = static_cast<int>(panels.size());
    QImage image(count * (panelSize + gap) + gap, 2 * (panelSize + gap) + captionHeight,
                 QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(14);
    painter.setFont(font);
    for (int i = 0; i < count; ++i) {
        const double left = gap + i * (panelSize + gap);
        drawSurface(painter, QRectF(left, gap, panelSize, panelSize), soup, panels[i].redness, view);
        drawMap(painter, QRectF(left, panelSize + 2 * gap, panelSize, panelSize), soup, panels[i]);
        painter.setPen(Qt::black);
        painter.drawText(QRectF(left, 2 * (panelSize + gap), panelSize, captionHeight), Qt::AlignCenter,
                         panels[i].caption);
    }
    painter.end();
    // Few colours make small files.
    return image.convertToFormat(QImage::Format_Indexed8, palette(), Qt::ThresholdDither).save(path);
}

} // namespace autocuts::figures
