// Isotropic distortion densities: functions of the two singular values of the Jacobian.
#pragma once

#include <algorithm>
#include <cmath>

namespace autocuts::energy {

//! First and second derivatives of a density e(s1, s2), s1 >= s2 > 0, as its Hessian over the Jacobian needs
//! them.
struct DensityDerivatives
{
    double g1, g2;        //!< de/ds1, de/ds2
    double h11, h12, h22; //!< second derivatives, as a positive semidefinite matrix
    double twist;         //!< clamped to >= 0: curvature when the triangle rotates
    double flip;          //!< clamped to >= 0: curvature when it shears
};

//! Symmetric Dirichlet, s1^2 + s2^2 + s1^-2 + s2^-2: 4 at an isometry (paper, Eq. 5).
struct SymmetricDirichletDensity
{
    static double value(double s1, double s2)
    {
        const double a = s1 * s1;
        const double b = s2 * s2;
        return a + b + (a + b) / (a * b);
    }
    static DensityDerivatives derivatives(double s1, double s2)
    {
        const double i1 = 1 / s1, i2 = 1 / s2;
        const double q1 = i1 * i1 * i1, q2 = i2 * i2 * i2;
        const double g1 = 2 * (s1 - q1);
        const double g2 = 2 * (s2 - q2);
        return {g1,
                g2,
                2 + 6 * q1 * i1,
                0,
                2 + 6 * q2 * i2,
                std::max(0.0, (g1 + g2) / (s1 + s2)),
                2 * (1 + (s1 * s1 + s1 * s2 + s2 * s2) * q1 * q2)};
    }
};

//! Conformal AMIPS (Fu, Liu and Guo 2015): 4 exp(c + a - 1) with c = (s1/s2 + s2/s1) / 2 weighted 0.8 and the
//! area term a = (s1 s2 + 1 / (s1 s2)) / 2 weighted 0.2, so that shape counts four times as much as size.
//! Some area term is needed: without it the separation would shrink every triangle to a point. 4 at an
//! isometry. The two weights were chosen by hand.
struct AmipsDensity
{
    static constexpr double shape = 0.8;
    static constexpr double size = 0.2;

    static double exponent(double s1, double s2)
    {
        const double d = s1 * s2;
        return 0.5 * (shape * (s1 / s2 + s2 / s1) + size * (d + 1 / d)) - 1;
    }
    static double value(double s1, double s2) { return 4 * std::exp(std::min(exponent(s1, s2), 600.0)); }
    static DensityDerivatives derivatives(double s1, double s2)
    {
        const double e = value(s1, s2);
        const double i1 = 1 / s1, i2 = 1 / s2;
        // Derivatives of the exponent.
        const double p1 = 0.5 * (shape * (i2 - s2 * i1 * i1) + size * (s2 - i2 * i1 * i1));
        const double p2 = 0.5 * (shape * (i1 - s1 * i2 * i2) + size * (s1 - i1 * i2 * i2));
        const double p11 = (shape * s2 + size * i2) * i1 * i1 * i1;
        const double p22 = (shape * s1 + size * i1) * i2 * i2 * i2;
        const double p12 = 0.5 * (shape * (-i1 * i1 - i2 * i2) + size * (1 + i1 * i1 * i2 * i2));
        DensityDerivatives d{};
        d.g1 = e * p1;
        d.g2 = e * p2;
        d.h11 = e * (p11 + p1 * p1);
        d.h22 = e * (p22 + p2 * p2);
        d.h12 = e * (p12 + p1 * p2);
        projectPositive(d);
        d.twist = std::max(0.0, (d.g1 + d.g2) / (s1 + s2));
        // (p1 - p2) / (s1 - s2), written so that nothing cancels.
        const double ratio =
            0.5 * (shape * (s1 + s2) * (s1 + s2) * i1 * i1 * i2 * i2 + size * (-1 + i1 * i1 * i2 * i2));
        d.flip = std::max(0.0, e * ratio);
        return d;
    }

private:
    //! Nearest positive semidefinite 2 x 2 matrix, in closed form.
    static void projectPositive(DensityDerivatives &d)
    {
        const double mean = 0.5 * (d.h11 + d.h22);
        const double half = 0.5 * (d.h11 - d.h22);
        const double radius = std::hypot(half, d.h12);
        if (mean - radius >= 0)
            return;
        const double large = std::max(0.0, mean + radius);
        if (radius == 0) {
            d.h11 = d.h22 = large;
            d.h12 = 0;
            return;
        }
        // Keeps the larger eigenvalue only: large * v v^T with v v^T = (I + [half h12; h12 -half] / radius)
        // / 2.
        d.h11 = large * 0.5 * (1 + half / radius);
        d.h22 = large * 0.5 * (1 - half / radius);
        d.h12 = large * 0.5 * d.h12 / radius;
    }
};

} // namespace autocuts::energy
