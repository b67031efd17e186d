#include "solver/homotopy/initialuv.h"

#include "solver/base/cornerat.h"
#include "solver/base/cutmesh.h"
#include "solver/base/random.h"
#include "solver/energy/distortion.h"
#include "solver/search/tutte.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts::homotopy {

namespace {

//! A triangle with a greater symmetric Dirichlet energy is placed undistorted instead of being used as a
//! start. Chosen by hand.
constexpr double worstStartDistortion = 1e4;

//! Writes triangle t undistorted, rotated by `angle`, with its centroid at `centre`.
void placeRigid(const Soup &soup, int t, double angle, const Vec2 &centre, std::vector<double> &x)
{
    const auto &s = soup.restShape[t];
    const Vec2 middle((s[0] + s[2] + s[4]) / 3, (s[1] + s[3] + s[5]) / 3);
    const double c = std::cos(angle), d = std::sin(angle);
    for (int k = 0; k < 3; ++k) {
        const Vec2 arm = cornerAt(s, k) - middle;
        cornerAt(x, 3 * t + k) =
            Vec2(centre.x() + c * arm.x() - d * arm.y(), centre.y() + d * arm.x() + c * arm.y());
    }
}

//! Replaces triangles that are flipped or far too distorted by undistorted ones, with the rotation and
//! centroid that the map gives them.
void repairTriangles(const Soup &soup, std::vector<double> &x)
{
    const std::vector<double> energy = energy::symmetricDirichlet(soup, x);
    for (int t = 0; t < soup.triangleCount(); ++t) {
        if (energy[t] <= worstStartDistortion)
            continue;
        const double *p = &x[6 * static_cast<std::size_t>(t)];
        Vec2 centre((p[0] + p[2] + p[4]) / 3, (p[1] + p[3] + p[5]) / 3);
        const Soup::Basis &b = soup.basis[t];
        // Entries of the rotation part of the Jacobian, not normalised.
        const double e = p[0] * b[0] + p[2] * b[2] + p[4] * b[4] + p[1] * b[1] + p[3] * b[3] + p[5] * b[5];
        const double h = p[1] * b[0] + p[3] * b[2] + p[5] * b[4] - p[0] * b[1] - p[2] * b[3] - p[4] * b[5];
        double angle = std::atan2(h, e);
        if (!centre.allFinite() || !std::isfinite(angle)) {
            centre.setZero();
            angle = 0;
        }
        placeRigid(soup, t, angle, centre, x);
    }
}

} // namespace

std::vector<double> initialUv(const Soup &soup, const Snapshot &snapshot)
{
    std::vector<double> x(soup.coordinateCount());
    switch (snapshot.settings.start) {
    case StartMode::Rigid:
        for (int t = 0; t < soup.triangleCount(); ++t)
            placeRigid(soup, t, 0, Vec2::Zero(), x);
        break;
    case StartMode::Random: {
        Random random(snapshot.settings.seed);
        for (int t = 0; t < soup.triangleCount(); ++t) {
            const double angle = random.uniform(0, 2 * std::numbers::pi);
            const double u = random.uniform(-1, 1);
            const double v = random.uniform(-1, 1);
            placeRigid(soup, t, angle, Vec2(u, v), x);
        }
        break;
    }
    case StartMode::Tutte:
        x = search::tutteEmbedding(soup, CutMesh(*soup.mesh, cutToDisks(*soup.mesh)));
        repairTriangles(soup, x);
        break;
    case StartMode::ExistingUv:
        if (snapshot.startUv && snapshot.startUv->rows() == soup.mesh->soupCornerCount()) {
            for (int c = 0; c < soup.mesh->soupCornerCount(); ++c)
                cornerAt(x, c) = snapshot.startUv->row(c).transpose();
        }
        repairTriangles(soup, x);
        break;
    }
    return x;
}

} // namespace autocuts::homotopy
