// A pump on a base plate: many hard-surface parts in several objects, with n-gons, fans and long thin faces.
#include "model/samples/samplemodels.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace autocuts::samples {

namespace {

std::vector<Vec2> rectangle(double width, double depth)
{
    const double a = width / 2, b = depth / 2;
    return {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
}

std::vector<Vec2> regularPolygon(int corners, double radius)
{
    std::vector<Vec2> profile;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        profile.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return profile;
}

Frame upright(double x, double y, double z)
{
    return {{x, y, z}, Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()};
}

void addBase(PolygonModel &model)
{
    model.beginObject(QStringLiteral("base"));
    model.useMaterial(QStringLiteral("paint"));
    model.addPrism(upright(0, 0, 0), rectangle(1.3, 2.9), 0.12, 0.03);
    for (const double x : {-1.0, 1.0}) {
        for (const double z : {-0.42, 0.42})
            model.addPrism(upright(x, -0.14, z), rectangle(0.22, 0.34), 0.14);
    }
    model.useMaterial(QStringLiteral("steel"));
    for (const double x : {-1.3, 1.3}) {
        for (const double z : {-0.5, 0.5})
            model.addPrism(upright(x, 0.12, z), regularPolygon(6, 0.07), 0.06, 0.012);
    }
}

//! A cylinder body along x with cooling fins, a fan cover and a foot at each end.
void addMotor(PolygonModel &model)
{
    model.beginObject(QStringLiteral("motor"));
    model.useMaterial(QStringLiteral("paint"));
    const Frame axis = frameAlong({-1.2, 0.62, 0}, Vec3::UnitX());
    model.addLathe(axis, {{0.36, 0}, {0.40, 0.04}, {0.40, 0.86}, {0.36, 0.90}, {0.22, 0.92}}, 32);
    model.addLathe(frameAlong({-1.22, 0.62, 0}, -Vec3::UnitX()),
                   {{0.38, 0}, {0.38, 0.12}, {0.33, 0.19}, {0.2, 0.23}, {0, 0.25}}, 24);
    for (int i = 0; i < 10; ++i) { // long thin faces, on purpose
        const double angle = std::numbers::pi * (0.02 + 0.96 * i / 9.0);
        const Vec3 out(0, std::sin(angle), std::cos(angle));
        Frame fin = axis;
        fin.origin += 0.405 * out + 0.08 * Vec3::UnitX();
        fin.x = out;
        fin.y = fin.z.cross(fin.x);
        model.addPrism(fin, {{0, -0.008}, {0.09, -0.005}, {0.09, 0.005}, {0, 0.008}}, 0.74);
    }
    // Feet with a saddle: their two ends are concave polygons.
    for (const double x : {-1.05, -0.6}) {
        Frame foot{{x, 0.125, 0}, -Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX()};
        model.addPrism(foot,
                       {{-0.42, 0},
                        {0.42, 0},
                        {0.42, 0.06},
                        {0.26, 0.07},
                        {0.2, 0.13},
                        {-0.2, 0.13},
                        {-0.26, 0.07},
                        {-0.42, 0.06}},
                       0.14);
    }
    model.useMaterial(QStringLiteral("rubber"));
    model.addPrism(upright(-0.75, 1.05, 0), rectangle(0.3, 0.4), 0.14, 0.02);
}

void addTransmission(PolygonModel &model)
{
    model.beginObject(QStringLiteral("transmission"));
    model.useMaterial(QStringLiteral("steel"));
    model.addPrism(frameAlong({-0.27, 0.62, 0}, Vec3::UnitX()), regularPolygon(12, 0.06), 0.62);
    model.addGear(frameAlong({-0.16, 0.62, 0}, Vec3::UnitX()), 16, 0.23, 0.29, 0.10, 0.012);
    model.addGear(frameAlong({-0.15, 0.35, 0.27}, Vec3::UnitX()), 8, 0.09, 0.15, 0.08);
    model.addPrism(frameAlong({-0.19, 0.35, 0.27}, Vec3::UnitX()), regularPolygon(8, 0.035), 0.65);
    model.addLathe(frameAlong({0.0, 0.62, 0}, Vec3::UnitX()),
                   {{0.09, 0}, {0.16, 0.02}, {0.16, 0.10}, {0.11, 0.12}, {0.11, 0.16}}, 20);
}

void addPump(PolygonModel &model)
{
    model.beginObject(QStringLiteral("pump"));
    model.useMaterial(QStringLiteral("paint"));
    model.addLathe(
        frameAlong({0.37, 0.62, 0}, Vec3::UnitX()),
        {{0.2, 0}, {0.42, 0.05}, {0.46, 0.12}, {0.46, 0.36}, {0.42, 0.43}, {0.18, 0.50}, {0.18, 0.62}}, 28);
    model.addPrism(upright(0.62, 0.125, 0), rectangle(0.6, 0.34), 0.06, 0.015);
    model.addPrism(
        {{0.54, 0.19, -0.03}, Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},
        {{-0.14, 0}, {0.3, 0}, {0.2, 0.06}, {0.12, 0.10}, {0.1, 0.14}, {-0.02, 0.14}, {-0.05, 0.08}}, 0.06);
    model.useMaterial(QStringLiteral("steel"));
    for (int i = 0; i < 8; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / 8;
        const Vec3 centre(0.845, 0.62 + 0.3 * std::sin(angle), 0.3 * std::cos(angle));
        model.addPrism(frameAlong(centre, {1, 0, 0}), regularPolygon(6, 0.035), 0.04);
    }
    model.addPrism(frameAlong({1.0, 0.62, 0}, Vec3::UnitX()), regularPolygon(20, 0.26), 0.06, 0.01);
}

void addPipes(PolygonModel &model)
{
    model.beginObject(QStringLiteral("pipes"));
    model.useMaterial(QStringLiteral("copper"));
    std::vector<Vec3> path{{0.62, 1.02, 0}, {0.62, 1.2, 0}, {0.62, 1.36, 0}};
    for (int i = 1; i <= 6; ++i) { // a quarter bend
        const double angle = std::numbers::pi / 2 * i / 6;
        path.emplace_back(0.62 - 0.2 * (1 - std::cos(angle)), 1.36 + 0.2 * std::sin(angle), 0);
    }
    path.emplace_back(0.1, 1.56, 0);
    path.emplace_back(-0.3, 1.56, 0);
    model.addTube(path, 0.09, 16);
    model.useMaterial(QStringLiteral("steel"));
    model.addPrism(upright(0.62, 1.06, 0), regularPolygon(16, 0.17), 0.05);
    model.addPrism(frameAlong({-0.3, 1.56, 0}, -Vec3::UnitX()), regularPolygon(16, 0.17), 0.05);
    // A valve with a hand wheel: a cone of triangles and a thin wheel.
    model.addLathe(upright(0.1, 1.63, 0), {{0.1, 0}, {0.06, 0.08}, {0.03, 0.2}, {0, 0.24}}, 12);
    model.useMaterial(QStringLiteral("rubber"));
    model.addGear(upright(0.1, 1.78, 0), 6, 0.15, 0.19, 0.03);
}

} // namespace

PolygonModel makeMachine()
{
    PolygonModel model;
    addBase(model);
    addMotor(model);
    addTransmission(model);
    addPump(model);
    addPipes(model);
    return model;
}

} // namespace autocuts::samples
