// A cube with smooth bumps on its faces and sharp edges between them, as in figure 6 of the paper.
#include "model/samples/samplemodels.h"

#include <cmath>
#include <map>
#include <numbers>

namespace autocuts::samples {

namespace {

constexpr int quadsPerSide = 27;
constexpr int bumpsPerSide = 3;
constexpr double bumpHeight = 0.13; // for a cube with sides of length 2

//! Height of the bumps; zero on the sides of the unit square, so that the cube's edges stay straight.
double bump(double u, double v)
{
    const double a = std::sin(bumpsPerSide * std::numbers::pi * u);
    const double b = std::sin(bumpsPerSide * std::numbers::pi * v);
    return bumpHeight * a * a * b * b;
}

} // namespace

PolygonModel makeBumpyCube()
{
    PolygonModel model;
    model.beginObject(QStringLiteral("bumpycube"));
    model.useMaterial(QStringLiteral("clay"));
    std::map<std::array<int, 3>, int> known; // points by their coordinates on the undisplaced lattice
    constexpr int n = quadsPerSide;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1}) {
            const int across = (axis + (sign > 0 ? 1 : 2)) % 3;
            const int up = 3 - axis - across;
            const auto pointAt = [&](int i, int j) {
                std::array<int, 3> place{};
                place[axis] = sign > 0 ? n : 0;
                place[across] = i;
                place[up] = j;
                const auto [found, isNew] = known.try_emplace(place, 0);
                if (isNew) {
                    Vec3 p(2.0 * place[0] / n - 1, 2.0 * place[1] / n - 1, 2.0 * place[2] / n - 1);
                    p[axis] += sign * bump(double(i) / n, double(j) / n);
                    found->second = model.addPoint(p);
                }
                return found->second;
            };
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    const int a = pointAt(i, j), b = pointAt(i + 1, j);
                    const int c = pointAt(i + 1, j + 1), d = pointAt(i, j + 1);
                    // Diagonals alternate, so that they do not suggest a direction for seams.
                    if ((i + j) % 2 == 0) {
                        model.addFace({a, b, c});
                        model.addFace({a, c, d});
                    } else {
                        model.addFace({a, b, d});
                        model.addFace({b, c, d});
                    }
                }
            }
        }
    }
    return model;
}

} // namespace autocuts::samples
