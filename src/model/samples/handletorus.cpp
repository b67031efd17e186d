// A torus with three handles on top: genus 4.
#include "model/samples/samplemodels.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::samples {

namespace {

constexpr int handles = 3;
constexpr int sectorsPerHandle = 6; // two for each foot, one between the feet, one before the next handle
constexpr int sectors = handles * sectorsPerHandle;
constexpr int sides = 8;
constexpr int ringsPerHandle = 6;
constexpr double ringRadius = 1.5, tubeRadius = 0.5;

//! Connects two feet (sets of faces) by a tube that turns by 180 degrees around the radial axis between them.
void addHandle(PolygonModel &model, const std::vector<int> &from, const std::vector<int> &to, double angle)
{
    const std::vector<int> start = model.border(from);
    std::vector<int> end = model.border(to);
    // Seen from inside the tube, both borders now have the same direction.
    std::reverse(end.begin(), end.end());
    const Vec3 axis(std::cos(angle), 0, std::sin(angle));
    Vec3 pivot = Vec3::Zero();
    for (std::size_t i = 0; i < start.size(); ++i)
        pivot += (model.points[start[i]] + model.points[end[i]]) / (2.0 * static_cast<double>(start.size()));
    const auto turned = [&](const Vec3 &p, double by) -> Vec3 {
        return pivot + Eigen::AngleAxisd(by, axis) * (p - pivot);
    };
    // The point of the second foot that is nearest to the first point of the first foot after half a turn.
    std::size_t shift = 0;
    for (std::size_t i = 1; i < end.size(); ++i) {
        const auto distance = [&](std::size_t k) {
            return (turned(model.points[start[0]], std::numbers::pi) - model.points[end[k]]).norm();
        };
        if (distance(i) < distance(shift))
            shift = i;
    }
    std::rotate(end.begin(), end.begin() + static_cast<std::ptrdiff_t>(shift), end.end());

    // Up from the first foot, then down to the second.
    const Vec3 side = axis.cross(Vec3::UnitY());
    const double sense = side.dot(model.points[start[0]] - pivot) > 0 ? -1 : 1;
    Vec3 foot = Vec3::Zero();
    for (int v : start)
        foot += model.points[v] / static_cast<double>(start.size());
    std::vector<int> last = start;
    for (int k = 1; k <= ringsPerHandle; ++k) {
        const double s = double(k) / ringsPerHandle;
        const double slimness = 1 - 0.35 * std::sin(std::numbers::pi * s);
        std::vector<int> ring = end;
        for (std::size_t i = 0; i < ring.size() && k < ringsPerHandle; ++i) {
            const Vec3 goal = turned(model.points[end[i]], -sense * std::numbers::pi);
            const Vec3 mixed = (1 - s) * model.points[start[i]] + s * goal;
            ring[i] = model.addPoint(turned(foot + slimness * (mixed - foot), sense * std::numbers::pi * s));
        }
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::size_t j = (i + 1) % ring.size();
            model.addFace({last[i], last[j], ring[j], ring[i]});
        }
        last = std::move(ring);
    }
}

} // namespace

PolygonModel makeHandleTorus()
{
    PolygonModel model;
    model.beginObject(QStringLiteral("torus"));
    model.useMaterial(QStringLiteral("clay"));
    for (int i = 0; i < sectors; ++i) {
        for (int j = 0; j < sides; ++j) {
            const double a = 2 * std::numbers::pi * i / sectors;
            const double b = 2 * std::numbers::pi * j / sides;
            const double r = ringRadius + tubeRadius * std::cos(b);
            model.addPoint({r * std::cos(a), tubeRadius * std::sin(b), r * std::sin(a)});
        }
    }
    const auto at = [&](int i, int j) { return (i % sectors) * sides + j % sides; };
    for (int i = 0; i < sectors; ++i) {
        for (int j = 0; j < sides; ++j)
            model.addFace({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
    // A foot is two sectors of the two rows of faces on top of the tube.
    const auto foot = [&](int sector) {
        const int f = sector * sides + 1;
        return std::vector<int>{f, f + 1, f + sides, f + sides + 1};
    };
    std::vector<int> removed;
    for (int h = 0; h < handles; ++h) {
        const int first = h * sectorsPerHandle;
        const std::vector<int> left = foot(first), right = foot(first + 3);
        addHandle(model, left, right, 2 * std::numbers::pi * (first + 2.5) / sectors);
        removed.insert(removed.end(), left.begin(), left.end());
        removed.insert(removed.end(), right.begin(), right.end());
    }
    model.removeFaces(removed);
    model.subdivide();
    model.subdivide();
    return model;
}

} // namespace autocuts::samples
