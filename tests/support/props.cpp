#include "support/props.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace autocuts::test::props {

void Model::add(const Model &other)
{
    const int first = static_cast<int>(points.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (std::vector<int> face : other.faces) {
        for (int &vertex : face)
            vertex += first;
        faces.push_back(std::move(face));
    }
}

Model box(const Vec3 &low, const Vec3 &size)
{
    Model model;
    for (int i = 0; i < 8; ++i)
        model.points.push_back(low + Vec3(i & 1 ? size.x() : 0, i & 2 ? size.y() : 0, i & 4 ? size.z() : 0));
    model.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return model;
}

Model column(int sides, double bottom, double top, double height, int rows)
{
    Model model;
    for (int row = 0; row <= rows; ++row) {
        const double share = double(row) / rows, radius = bottom + share * (top - bottom);
        if (radius == 0) {
            model.points.push_back({0, 0, height});
            break;
        }
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            model.points.push_back({radius * std::cos(angle), radius * std::sin(angle), share * height});
        }
    }
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < sides; ++i) {
            const int a = row * sides + i, b = row * sides + (i + 1) % sides;
            if (row + 1 == rows && top == 0)
                model.faces.push_back({a, b, rows * sides});
            else
                model.faces.push_back({a, b, b + sides, a + sides});
        }
    }
    std::vector<int> low, high;
    for (int i = 0; i < sides; ++i) {
        low.push_back(sides - 1 - i);
        high.push_back(rows * sides + i);
    }
    model.faces.push_back(low);
    if (top > 0)
        model.faces.push_back(high);
    return model;
}

Model house()
{
    Model model;
    model.points = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0},     {0, 0, 2},
                    {4, 0, 2}, {4, 3, 2}, {0, 3, 2}, {0, 1.5, 3.2}, {4, 1.5, 3.2}};
    model.faces = {{3, 2, 1, 0},    {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 9, 5},
                   {3, 0, 4, 8, 7}, {4, 5, 9, 8}, {6, 7, 8, 9}};
    return model;
}

Model stairs(int steps)
{
    Model model;
    std::vector<int> left, right;
    const auto point = [&](double x, double z) {
        model.points.push_back({x, 0, z});
        model.points.push_back({x, 3, z});
        left.push_back(static_cast<int>(model.points.size()) - 2);
        right.push_back(static_cast<int>(model.points.size()) - 1);
    };
    point(0, 0);
    for (int i = 0; i < steps; ++i) {
        point(i, i + 1);
        point(i + 1, i + 1);
    }
    point(steps, 0);
    const int count = static_cast<int>(left.size());
    for (int i = 0; i < count; ++i) {
        const int next = (i + 1) % count;
        model.faces.push_back({left[i], right[i], right[next], left[next]});
    }
    model.faces.push_back({left.rbegin(), left.rend()});
    model.faces.push_back(right);
    for (std::vector<int> &face : model.faces)
        std::reverse(face.begin(), face.end());
    return model;
}

Model shelf()
{
    Model model = box({0, 0, 0}, {0.1, 1, 4});
    model.add(box({3, 0, 0}, {0.1, 1, 4}));
    for (int i = 0; i < 4; ++i)
        model.add(box({0.1, 0, 0.5 + i}, {2.9, 1, 0.1}));
    return model;
}

Model sphere(int rows, double radius)
{
    Model model;
    const int columns = 2 * rows;
    model.points.push_back({0, 0, -radius});
    for (int r = 1; r < rows; ++r) {
        const double up = std::numbers::pi * r / rows;
        for (int c = 0; c < columns; ++c) {
            const double angle = 2 * std::numbers::pi * c / columns;
            model.points.push_back(
                radius * Vec3(std::sin(up) * std::cos(angle), std::sin(up) * std::sin(angle), -std::cos(up)));
        }
    }
    model.points.push_back({0, 0, radius});
    const int last = static_cast<int>(model.points.size()) - 1;
    for (int c = 0; c < columns; ++c) {
        const int next = (c + 1) % columns;
        model.faces.push_back({0, 1 + next, 1 + c});
        for (int r = 0; r + 2 < rows; ++r)
            model.faces.push_back({1 + r * columns + c, 1 + r * columns + next, 1 + (r + 1) * columns + next,
                                   1 + (r + 1) * columns + c});
        model.faces.push_back({last, 1 + (rows - 2) * columns + c, 1 + (rows - 2) * columns + next});
    }
    return model;
}

Model turnedShape(const std::vector<Vec2> &profile, int sides)
{
    Model model;
    const int rows = static_cast<int>(profile.size());
    for (const Vec2 &ring : profile) {
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            model.points.push_back({ring.x() * std::cos(angle), ring.x() * std::sin(angle), ring.y()});
        }
    }
    for (int row = 0; row + 1 < rows; ++row) {
        for (int i = 0; i < sides; ++i) {
            const int a = row * sides + i, b = row * sides + (i + 1) % sides;
            model.faces.push_back({a, b, b + sides, a + sides});
        }
    }
    std::vector<int> low, high;
    for (int i = 0; i < sides; ++i) {
        low.push_back(sides - 1 - i);
        high.push_back((rows - 1) * sides + i);
    }
    model.faces.push_back(low);
    model.faces.push_back(high);
    return model;
}

Model tube(const std::vector<Vec2> &path, double radius, int sides)
{
    // The faces are those of a turned shape with as many rings.
    Model model = turnedShape(std::vector<Vec2>(path.size(), Vec2(1, 0)), sides);
    const auto at = [&](std::size_t i) { return path[std::min(i, path.size() - 1)]; };
    for (std::size_t row = 0; row < path.size(); ++row) {
        const Vec2 along = (at(row + 1) - at(row > 0 ? row - 1 : 0)).normalized();
        const Vec3 middle(path[row].x(), 0, path[row].y()), across(along.y(), 0, -along.x());
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            model.points[row * sides + i] =
                middle + radius * (std::cos(angle) * across + std::sin(angle) * Vec3::UnitY());
        }
    }
    return model;
}

Model bolt()
{
    Model model = column(6, 1, 1, 0.8);
    model.add(moved(column(24, 0.5, 0.5, 4), {0, 0, 0.8}));
    return model;
}

Model table()
{
    Model model = box({0, 0, 2}, {4, 2, 0.2});
    for (const double x : {0.1, 3.7}) {
        for (const double y : {0.1, 1.7})
            model.add(box({x, y, 0}, {0.2, 0.2, 2}));
    }
    return model;
}

namespace {

//! Adds points of an arc. \param from, to angles in radians, without the first point
void addArc(std::vector<Vec2> &path, const Vec2 &centre, double radius, double from, double to, int steps)
{
    for (int i = 1; i <= steps; ++i) {
        const double angle = from + (to - from) * i / steps;
        path.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
}

} // namespace

Model pipe()
{
    constexpr double quarter = std::numbers::pi / 2;
    std::vector<Vec2> path{{0, 0}, {0, 1.5}, {0, 3}};
    addArc(path, {1, 3}, 1, 2 * quarter, quarter, 6);
    path.push_back({2.5, 4});
    path.push_back({4, 4});
    addArc(path, {4, 5}, 1, -quarter, 0, 6);
    path.push_back({5, 7});
    return tube(path, 0.4, 12);
}

Model bicycle()
{
    Model model;
    for (const double x : {0.0, 3.2}) {
        // A ring of a square section.
        Model wheel;
        constexpr int sides = 24;
        for (const double r : {1.0, 1.1}) {
            for (const double y : {-0.05, 0.05}) {
                for (int i = 0; i < sides; ++i) {
                    const double angle = 2 * std::numbers::pi * i / sides;
                    wheel.points.push_back({x + r * std::cos(angle), y, r * std::sin(angle)});
                }
            }
        }
        const auto band = [&](int from, int to) {
            for (int i = 0; i < sides; ++i) {
                const int next = (i + 1) % sides;
                wheel.faces.push_back(
                    {from * sides + i, to * sides + i, to * sides + next, from * sides + next});
            }
        };
        band(0, 1);
        band(1, 3);
        band(3, 2);
        band(2, 0);
        model.add(wheel);
    }
    const std::vector<std::vector<Vec2>> frame{{{0, 0}, {0.9, 1.4}},     {{0, 0}, {1.4, 0.1}},
                                               {{1.4, 0.1}, {0.9, 1.6}}, {{0.9, 1.4}, {2.7, 1.4}},
                                               {{1.4, 0.1}, {2.7, 1.3}}, {{2.6, 1.8}, {3.2, 0}}};
    for (const std::vector<Vec2> &line : frame)
        model.add(tube(line, 0.06, 8));
    return model;
}

Model bottle()
{
    return turnedShape(
        {{1, 0}, {1.05, 0.5}, {1.05, 1.5}, {1, 2}, {0.7, 2.5}, {0.4, 2.8}, {0.3, 3}, {0.3, 3.6}}, 24);
}

namespace {

//! Adds quads by the positions of their corners; points at the same place become one.
class Builder
{
public:
    void add(std::vector<Vec3> corners)
    {
        std::vector<int> face;
        for (const Vec3 &p : corners) {
            const std::array<long, 3> key{std::lround(1e6 * p.x()), std::lround(1e6 * p.y()),
                                          std::lround(1e6 * p.z())};
            const auto [found, isNew] = mPoint.emplace(key, static_cast<int>(mModel.points.size()));
            if (isNew)
                mModel.points.push_back(p);
            face.push_back(found->second);
        }
        mModel.faces.push_back(std::move(face));
    }
    //! A grid of quads. \param at the position for u and v in [0, 1]
    template <typename Position>
    void addGrid(int columns, int rows, Position at)
    {
        const auto place = [&](int i, int j) { return Vec3(at(double(i) / columns, double(j) / rows)); };
        for (int i = 0; i < columns; ++i) {
            for (int j = 0; j < rows; ++j)
                add({place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)});
        }
    }
    const Model &model() const { return mModel; }

private:
    std::map<std::array<long, 3>, int> mPoint;
    Model mModel;
};

} // namespace

Model cushion(double bulge, int cells)
{
    Builder builder;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            builder.addGrid(cells, cells, [&](double u, double v) {
                const double x = 2 * u - 1, y = 2 * v - 1;
                Vec3 point = Vec3::Zero();
                point[axis] = sign * (1 + bulge * (1 - x * x) * (1 - y * y));
                point[(axis + 1) % 3] = sign * x;
                point[(axis + 2) % 3] = y;
                return point;
            });
        }
    }
    return builder.model();
}

Model door(double bulge, double bevel, double back)
{
    const int columns = 20, rows = 12;
    const double width = 1, height = 0.6; // halves
    const auto front = [&](double u, double v) {
        const double x = (2 * u - 1) * (width - bevel), y = (2 * v - 1) * (height - bevel);
        return Vec3(x, y, bulge * (1 - 0.3 * std::pow(x / width, 2) - std::pow(y / height, 2)));
    };
    const auto rim = [&](double u, double v, bool high) {
        return Vec3((2 * u - 1) * width, (2 * v - 1) * height, high ? front(u, v).z() - bevel : -0.5);
    };
    Builder builder;
    builder.addGrid(columns, rows, front);
    builder.addGrid(columns, rows, [&](double u, double v) {
        const double x = 1 - 2 * u, y = 2 * v - 1;
        return Vec3(x * width, y * height, -0.5 - back * (1 - x * x) * (1 - y * y));
    });
    std::vector<Vec2> around;
    for (int i = 0; i < columns; ++i)
        around.push_back({double(i) / columns, 0});
    for (int j = 0; j < rows; ++j)
        around.push_back({1, double(j) / rows});
    for (int i = 0; i < columns; ++i)
        around.push_back({1 - double(i) / columns, 1});
    for (int j = 0; j < rows; ++j)
        around.push_back({0, 1 - double(j) / rows});
    for (std::size_t i = 0; i < around.size(); ++i) {
        const Vec2 a = around[i], b = around[(i + 1) % around.size()];
        const Vec3 highA = rim(a.x(), a.y(), true), highB = rim(b.x(), b.y(), true);
        if (bevel > 0)
            builder.add({front(b.x(), b.y()), front(a.x(), a.y()), highA, highB});
        builder.add({highB, highA, rim(a.x(), a.y(), false), rim(b.x(), b.y(), false)});
    }
    return builder.model();
}

Model moved(Model model, const Vec3 &by)
{
    for (Vec3 &point : model.points)
        point += by;
    return model;
}

Model mirrored(Model model)
{
    for (Vec3 &point : model.points)
        point.x() = -point.x();
    for (std::vector<int> &face : model.faces)
        std::reverse(face.begin(), face.end());
    return model;
}

Model turned(Model model, double angle)
{
    for (Vec3 &point : model.points)
        point = {std::cos(angle) * point.x() - std::sin(angle) * point.y(),
                 std::sin(angle) * point.x() + std::cos(angle) * point.y(), point.z()};
    return model;
}

} // namespace autocuts::test::props
