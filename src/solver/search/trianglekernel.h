// Energy of a triangle, in closed form (Smith, de Goes and Kim 2019).
//
// Templates take numbers, or vectors with one number per triangle: all steps are the same, and so are the
// bits.
#pragma once

#include "solver/base/soup.h"
#include "solver/energy/isotropic.h"

#include <array>
#include <cmath>
#include <limits>

namespace autocuts::search {

//! Several numbers, one per triangle.
constexpr int triangleLanes = 4;
//! Alignment in memory, see laneAlignment.
constexpr std::size_t triangleAlignment = triangleLanes * sizeof(double);
using TriangleLanes = double __attribute__((vector_size(triangleLanes * sizeof(double))));

inline void takeRoot(double &a)
{
    a = std::sqrt(a);
}
[[gnu::always_inline]] inline void takeRoot(TriangleLanes &a)
{
    for (int lane = 0; lane < triangleLanes; ++lane)
        a[lane] = std::sqrt(a[lane]);
}

//! The Jacobian of a triangle.
//! \param p u and v of the three corners
//! \param b maps them to it, see Soup::Basis
template <class T>
struct TriangleJacobian
{
    T j00, j01, j10, j11, determinant;

    [[gnu::always_inline]] TriangleJacobian(const T *p, const T *b)
        : j00(p[0] * b[0] + p[2] * b[2] + p[4] * b[4]), j01(p[0] * b[1] + p[2] * b[3] + p[4] * b[5]),
          j10(p[1] * b[0] + p[3] * b[2] + p[5] * b[4]), j11(p[1] * b[1] + p[3] * b[3] + p[5] * b[5]),
          determinant(j00 * j11 - j01 * j10)
    {}
};

//! Symmetric Dirichlet energy density |J|^2 + |J^-1|^2: 4 at an isometry, infinite when flipped.
//! \param p,b see TriangleJacobian
template <class T>
[[gnu::always_inline]] inline void setDirichletDensity(const T *p, const T *b, T &density)
{
    const TriangleJacobian<T> j(p, b);
    const T squares = j.j00 * j.j00 + j.j01 * j.j01 + j.j10 * j.j10 + j.j11 * j.j11;
    const T flipped = T{} + std::numeric_limits<double>::infinity();
    density = j.determinant > T{} ? squares + squares / (j.determinant * j.determinant) : flipped;
}
inline double triangleEnergy(const double *p, const Soup::Basis &b)
{
    double density = 0;
    setDirichletDensity(p, b.data(), density);
    return density;
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
template <class T>
struct TriangleModes
{
    T s1, s2; //!< s1 >= s2 > 0
    //! Change of s1, of s2, twist and flip, as unit vectors over the entries of the Jacobian, row by row.
    std::array<std::array<T, 4>, 4> mode;

    //! \pre the triangle is not flipped
    [[gnu::always_inline]] TriangleModes(const T *p, const T *b)
    {
        const TriangleJacobian<T> j(p, b);
        const T e = 0.5 * (j.j00 + j.j11), f = 0.5 * (j.j00 - j.j11);
        const T g = 0.5 * (j.j10 + j.j01), h = 0.5 * (j.j10 - j.j01);
        T q = e * e + h * h, r = f * f + g * g;
        takeRoot(q);
        takeRoot(r);
        s1 = q + r;
        s2 = j.determinant / s1; // equals q - r, without the cancellation
        const T none{}, one = none + 1;
        const T iq = one / q;
        const T re = e * iq, rh = h * iq;
        const T ir = r > none ? one / r : none;
        const T sf = r > none ? f * ir : one, sg = g * ir;
        constexpr double root = 0.70710678118654752440;
        mode = {{{0.5 * (re + sf), 0.5 * (sg - rh), 0.5 * (rh + sg), 0.5 * (re - sf)},
                 {0.5 * (re - sf), 0.5 * (-rh - sg), 0.5 * (rh - sg), 0.5 * (re + sf)},
                 {-root * rh, -root * re, root * re, -root * rh},
                 {-root * sg, root * sf, root * sf, root * sg}}};
    }
};

//! Gradient and Hessian over the corners from those over the Jacobian, see dirichletDerivatives().
//! \param g1,g2 derivatives by the singular values
//! \param m Hessian over the entries of the Jacobian
template <class T>
[[gnu::always_inline]] inline void toCorners(const TriangleModes<T> &modes, const T &g1, const T &g2,
                                             const T (&m)[4][4], const T *b, T *gradient, T *hessian)
{
    const auto &mode = modes.mode;
    const T d00 = g1 * mode[0][0] + g2 * mode[1][0], d01 = g1 * mode[0][1] + g2 * mode[1][1];
    const T d10 = g1 * mode[0][2] + g2 * mode[1][2], d11 = g1 * mode[0][3] + g2 * mode[1][3];
    for (int k = 0; k < 3; ++k) {
        gradient[2 * k] = d00 * b[2 * k] + d01 * b[2 * k + 1];
        gradient[2 * k + 1] = d10 * b[2 * k] + d11 * b[2 * k + 1];
    }
    int at = 0;
    for (int k = 0; k < 3; ++k) {
        const T x = b[2 * k], y = b[2 * k + 1];
        T row[2][4];
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
//! \param p,b see TriangleJacobian \pre the triangle is not flipped
template <class T>
[[gnu::always_inline]] inline void dirichletDerivatives(const T *p, const T *b, const T &weight, T *gradient,
                                                        T *hessian)
{
    const TriangleModes<T> modes(p, b);
    const T s1 = modes.s1, s2 = modes.s2;
    const T none{}, one = none + 1;
    const T i1 = one / s1, i2 = one / s2;
    const T c1 = i1 * i1 * i1, c2 = i2 * i2 * i2;
    const T g1 = weight * 2 * (s1 - c1), g2 = weight * 2 * (s2 - c2);
    const T h1 = weight * (2 + 6 * c1 * i1), h2 = weight * (2 + 6 * c2 * i2);
    const T spin = (g1 + g2) / (s1 + s2);
    const T twist = none < spin ? spin : none;
    const T flip = weight * 2 * (1 + (s1 * s1 + s1 * s2 + s2 * s2) * c1 * c2);
    const std::array<T, 4> curvature{h1, h2, twist, flip};
    T m[4][4];
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j <= i; ++j) {
            T sum{};
            for (int k = 0; k < 4; ++k)
                sum += curvature[k] * modes.mode[k][i] * modes.mode[k][j];
            m[i][j] = m[j][i] = sum;
        }
    }
    toCorners(modes, g1, g2, m, b, gradient, hessian);
}
inline void triangleDerivatives(const double *p, const Soup::Basis &b, double weight, double *gradient,
                                double *hessian)
{
    dirichletDerivatives(p, b.data(), weight, gradient, hessian);
}

//! Conformal AMIPS, as triangleEnergy().
inline double amipsEnergy(const double *p, const Soup::Basis &b)
{
    const double area = (p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0]);
    if (!(area * (b[2] * b[5] - b[3] * b[4]) > 0))
        return std::numeric_limits<double>::infinity();
    const TriangleModes<double> modes(p, b.data());
    return energy::AmipsDensity::value(modes.s1, modes.s2);
}

//! Conformal AMIPS, as triangleDerivatives().
inline void amipsDerivatives(const double *p, const Soup::Basis &b, double weight, double *gradient,
                             double *hessian)
{
    const TriangleModes<double> modes(p, b.data());
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
    toCorners(modes, weight * d.g1, weight * d.g2, m, b.data(), gradient, hessian);
}

} // namespace autocuts::search
