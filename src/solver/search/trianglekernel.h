// Energy of one triangle, in closed form (Smith, de Goes and Kim 2019).
#pragma once

#include "solver/base/soup.h"
#include "solver/energy/isotropic.h"

#include <array>
#include <cmath>
#include <limits>

namespace autocuts::search {

//! Symmetric Dirichlet energy density |J|^2 + |J^-1|^2: 4 at an isometry, infinite when flipped.
//! \param p u and v of the three corners
//! \param b maps them to the Jacobian J
inline double triangleEnergy(const double *p, const Soup::Basis &b)
{
    const double j00 = p[0] * b[0] + p[2] * b[2] + p[4] * b[4];
    const double j01 = p[0] * b[1] + p[2] * b[3] + p[4] * b[5];
    const double j10 = p[1] * b[0] + p[3] * b[2] + p[5] * b[4];
    const double j11 = p[1] * b[1] + p[3] * b[3] + p[5] * b[5];
    const double det = j00 * j11 - j01 * j10;
    if (!(det > 0))
        return std::numeric_limits<double>::infinity();
    const double squares = j00 * j00 + j01 * j01 + j10 * j10 + j11 * j11;
    return squares + squares / (det * det);
}

//! Smallest step at which a triangle loses its area; `limit` when it does not before that.
//! \param edges u and v of its second and third corner, seen from the first \param moves how these change
//! \pre the triangle is not flipped
inline double flipFreeTriangleStep(const std::array<double, 4> &edges, const std::array<double, 4> &moves,
                                   double limit)
{
    const auto [u1, v1, u2, v2] = edges;
    const auto [du1, dv1, du2, dv2] = moves;
    // Twice the signed area after a step of length s is a s^2 + b s + c, with c > 0.
    const double a = du1 * dv2 - dv1 * du2;
    const double b = u1 * dv2 - v1 * du2 + du1 * v2 - dv1 * u2;
    const double c = u1 * v2 - v1 * u2;
    if (c + std::min(0.0, b) * limit + std::min(0.0, a) * limit * limit > 0)
        return limit;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0)
        return limit;
    const double denominator = -b + std::sqrt(discriminant);
    return denominator > 0 ? std::min(limit, 2 * c / denominator) : limit;
}

//! The singular values of the Jacobian of a triangle and the modes of its change.
struct TriangleModes
{
    double s1, s2; //!< s1 >= s2 > 0
    //! Change of s1, of s2, twist and flip, as unit vectors over the entries of the Jacobian, row by row.
    std::array<std::array<double, 4>, 4> mode;

    //! \pre the triangle is not flipped
    TriangleModes(const double *p, const Soup::Basis &b)
    {
        const double j00 = p[0] * b[0] + p[2] * b[2] + p[4] * b[4];
        const double j01 = p[0] * b[1] + p[2] * b[3] + p[4] * b[5];
        const double j10 = p[1] * b[0] + p[3] * b[2] + p[5] * b[4];
        const double j11 = p[1] * b[1] + p[3] * b[3] + p[5] * b[5];
        const double e = 0.5 * (j00 + j11), f = 0.5 * (j00 - j11);
        const double g = 0.5 * (j10 + j01), h = 0.5 * (j10 - j01);
        const double q = std::sqrt(e * e + h * h), r = std::sqrt(f * f + g * g);
        s1 = q + r;
        s2 = (j00 * j11 - j01 * j10) / s1; // equals q - r, without the cancellation
        const double iq = 1 / q;
        const double re = e * iq, rh = h * iq;
        const double ir = r > 0 ? 1 / r : 0;
        const double sf = r > 0 ? f * ir : 1, sg = g * ir;
        constexpr double root = 0.70710678118654752440;
        mode = {{{0.5 * (re + sf), 0.5 * (sg - rh), 0.5 * (rh + sg), 0.5 * (re - sf)},
                 {0.5 * (re - sf), 0.5 * (-rh - sg), 0.5 * (rh - sg), 0.5 * (re + sf)},
                 {-root * rh, -root * re, root * re, -root * rh},
                 {-root * sg, root * sf, root * sf, root * sg}}};
    }
};

//! Gradient and Hessian over the corners from those over the Jacobian, see triangleDerivatives().
//! \param g1,g2 derivatives by the singular values
//! \param m Hessian over the entries of the Jacobian
inline void toCorners(const TriangleModes &modes, double g1, double g2, const double (&m)[4][4],
                      const Soup::Basis &b, double *gradient, double *hessian)
{
    const auto &mode = modes.mode;
    const double d00 = g1 * mode[0][0] + g2 * mode[1][0], d01 = g1 * mode[0][1] + g2 * mode[1][1];
    const double d10 = g1 * mode[0][2] + g2 * mode[1][2], d11 = g1 * mode[0][3] + g2 * mode[1][3];
    for (int k = 0; k < 3; ++k) {
        gradient[2 * k] = d00 * b[2 * k] + d01 * b[2 * k + 1];
        gradient[2 * k + 1] = d10 * b[2 * k] + d11 * b[2 * k + 1];
    }
    int at = 0;
    for (int k = 0; k < 3; ++k) {
        const double x = b[2 * k], y = b[2 * k + 1];
        double row[2][4];
        for (int j = 0; j < 4; ++j) {
            row[0][j] = x * m[0][j] + y * m[1][j];
            row[1][j] = x * m[2][j] + y * m[3][j];
        }
        for (int i = 0; i < 2; ++i) {
            for (int l = 0; l <= k; ++l) {
                hessian[at++] = row[i][0] * b[2 * l] + row[i][1] * b[2 * l + 1];
                if (l < k || i == 1)
                    hessian[at++] = row[i][2] * b[2 * l] + row[i][3] * b[2 * l + 1];
            }
        }
    }
}

//! Gradient (6 numbers) and positive semidefinite Hessian (lower triangle of 6 x 6, row by row) of the
//! symmetric Dirichlet energy, both times `weight`. The eigenvalues of the Hessian in the Jacobian's space
//! are known in closed form; only the twist mode can be negative and is clamped to zero.
//! \pre the triangle is not flipped
inline void triangleDerivatives(const double *p, const Soup::Basis &b, double weight, double *gradient,
                                double *hessian)
{
    const TriangleModes modes(p, b);
    const double s1 = modes.s1, s2 = modes.s2;
    const double i1 = 1 / s1, i2 = 1 / s2;
    const double c1 = i1 * i1 * i1, c2 = i2 * i2 * i2;
    const double g1 = weight * 2 * (s1 - c1), g2 = weight * 2 * (s2 - c2);
    const double h1 = weight * (2 + 6 * c1 * i1), h2 = weight * (2 + 6 * c2 * i2);
    const double twist = std::max(0.0, (g1 + g2) / (s1 + s2));
    const double flip = weight * 2 * (1 + (s1 * s1 + s1 * s2 + s2 * s2) * c1 * c2);
    const std::array<double, 4> curvature{h1, h2, twist, flip};
    double m[4][4];
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j <= i; ++j) {
            double sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += curvature[k] * modes.mode[k][i] * modes.mode[k][j];
            m[i][j] = m[j][i] = sum;
        }
    }
    toCorners(modes, g1, g2, m, b, gradient, hessian);
}

//! Conformal AMIPS, as triangleEnergy().
inline double amipsEnergy(const double *p, const Soup::Basis &b)
{
    const double area = (p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0]);
    if (!(area * (b[2] * b[5] - b[3] * b[4]) > 0))
        return std::numeric_limits<double>::infinity();
    const TriangleModes modes(p, b);
    return energy::AmipsDensity::value(modes.s1, modes.s2);
}

//! Conformal AMIPS, as triangleDerivatives().
inline void amipsDerivatives(const double *p, const Soup::Basis &b, double weight, double *gradient,
                             double *hessian)
{
    const TriangleModes modes(p, b);
    const energy::DensityDerivatives d = energy::AmipsDensity::derivatives(modes.s1, modes.s2);
    const std::array<double, 4> curvature{d.h11, d.h22, d.twist, d.flip};
    double m[4][4];
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            double sum = d.h12 * (modes.mode[0][i] * modes.mode[1][j] + modes.mode[1][i] * modes.mode[0][j]);
            for (int k = 0; k < 4; ++k)
                sum += curvature[k] * modes.mode[k][i] * modes.mode[k][j];
            m[i][j] = weight * sum;
        }
    }
    toCorners(modes, weight * d.g1, weight * d.g2, m, b, gradient, hessian);
}

} // namespace autocuts::search
