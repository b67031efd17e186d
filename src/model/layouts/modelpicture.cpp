#include "model/layouts/modelpicture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autocuts {

namespace {

constexpr int oversampling = 2;    //!< pixels that are drawn for one of the picture, along each side
constexpr double turn = 0.6;       //!< radians to the right
constexpr double lift = 0.45;      //!< radians up
constexpr double filled = 0.92;    //!< part of the picture that the model fills
constexpr double darkest = 0.35;   //!< brightness of what is seen from the side
constexpr QRgb surface = 0x8DB4EE; //!< the colour of the program's icon

//! The positions as the camera sees them, in pixels; z grows to the camera.
std::vector<Vec3> seenFrom(const MeshData &mesh, int side)
{
    Eigen::Matrix3d camera;
    camera = Eigen::AngleAxisd(lift, Vec3::UnitX()) * Eigen::AngleAxisd(-turn, Vec3::UnitY());
    // Coordinates of any size: they are brought to at most 1 before they are squared.
    const double largest = std::max(mesh.positions.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
    std::vector<Vec3> seen;
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::max()), high = -low;
    for (int corner = 0; corner < mesh.cornerCount(); ++corner) {
        seen.push_back(camera * (mesh.cornerPosition(corner) / largest));
        low = low.cwiseMin(seen.back());
        high = high.cwiseMax(seen.back());
    }
    const double extent = std::max((high - low).head<2>().maxCoeff(), std::numeric_limits<double>::min());
    const Vec3 centre = (low + high) / 2;
    for (Vec3 &point : seen) {
        point = (point - centre) * (filled * side / extent);
        point = Vec3(point.x() + side / 2.0, side / 2.0 - point.y(), point.z());
    }
    return seen;
}

QRgb shaded(const Vec3 &normal)
{
    const double brightness = darkest + (1 - darkest) * std::abs(normal.z());
    const auto part = [&](int value) { return int(std::lround(value * brightness)); };
    return qRgb(part(qRed(surface)), part(qGreen(surface)), part(qBlue(surface)));
}

//! A picture with the depth of each pixel.
class Canvas
{
public:
    explicit Canvas(int side)
        : image(side, side, QImage::Format_ARGB32_Premultiplied),
          mDepth(std::size_t(side) * side, -std::numeric_limits<double>::max())
    {
        image.fill(Qt::transparent);
    }

    void draw(const Vec3 &a, const Vec3 &b, const Vec3 &c)
    {
        const Vec3 normal = (b - a).cross(c - a);
        if (normal.z() == 0 || !std::isfinite(normal.z()))
            return; // seen from the side
        const int side = image.width();
        const auto bounded = [side](double x) { return int(std::clamp(x, 0.0, side - 1.0)); };
        const int left = bounded(std::floor(std::min({a.x(), b.x(), c.x()})));
        const int right = bounded(std::ceil(std::max({a.x(), b.x(), c.x()})));
        const int top = bounded(std::floor(std::min({a.y(), b.y(), c.y()})));
        const int bottom = bounded(std::ceil(std::max({a.y(), b.y(), c.y()})));
        const QRgb colour = shaded(normal.normalized());
        const auto twiceArea = [](const Vec3 &p, const Vec3 &q, double x, double y) {
            return (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
        };
        for (int y = top; y <= bottom; ++y) {
            auto *row = reinterpret_cast<QRgb *>(image.scanLine(y));
            for (int x = left; x <= right; ++x) {
                const double inA = twiceArea(b, c, x + 0.5, y + 0.5) / normal.z();
                const double inB = twiceArea(c, a, x + 0.5, y + 0.5) / normal.z();
                const double inC = 1 - inA - inB;
                if (inA < 0 || inB < 0 || inC < 0)
                    continue;
                const double depth = inA * a.z() + inB * b.z() + inC * c.z();
                double &nearest = mDepth[std::size_t(y) * side + x];
                if (depth > nearest) {
                    nearest = depth;
                    row[x] = colour;
                }
            }
        }
    }

    QImage image;

private:
    std::vector<double> mDepth;
};

} // namespace

QImage modelPicture(const MeshData &mesh, int side)
{
    const std::vector<Vec3> seen = seenFrom(mesh, side * oversampling);
    Canvas canvas(side * oversampling);
    for (const auto &[a, b, c] : mesh.triangles)
        canvas.draw(seen[a], seen[b], seen[c]);
    return canvas.image.scaled(side, side, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

} // namespace autocuts
