#include "solver/energy/distortion.h"

#include "solver/energy/isotropic.h"

#include <cmath>
#include <limits>

namespace autocuts {

namespace {

//! Singular values of a Jacobian with positive determinant, and the rotations that diagonalise it.
struct SingularValues
{
    double e, f, g, h;    // J = [e + f, g - h; g + h, e - f]
    double q, r;          // s1 = q + r, s2 = q - r
    double s1, s2;

    SingularValues(const double *p, const Soup::Basis &b)
    {
        const double j00 = p[0] * b[0] + p[2] * b[2] + p[4] * b[4];
        const double j01 = p[0] * b[1] + p[2] * b[3] + p[4] * b[5];
        const double j10 = p[1] * b[0] + p[3] * b[2] + p[5] * b[4];
        const double j11 = p[1] * b[1] + p[3] * b[3] + p[5] * b[5];
        e = 0.5 * (j00 + j11);
        f = 0.5 * (j00 - j11);
        g = 0.5 * (j10 + j01);
        h = 0.5 * (j10 - j01);
        q = std::sqrt(e * e + h * h);
        r = std::sqrt(f * f + g * g);
        s1 = q + r;
        // s2 = q - r loses its digits when they are close: the determinant is q^2 - r^2.
        s2 = (j00 * j11 - j01 * j10) / s1;
    }
};

//! Projects a mode M (2 x 2, row by row) of the Jacobian onto the triangle's six coordinates.
inline void modeVector(const Soup::Basis &b, double m00, double m01, double m10, double m11, double *v)
{
    for (int k = 0; k < 3; ++k) {
        v[2 * k] = m00 * b[2 * k] + m01 * b[2 * k + 1];
        v[2 * k + 1] = m10 * b[2 * k] + m11 * b[2 * k + 1];
    }
}

template <class Density>
class IsotropicTerm final : public DistortionTerm
{
public:
    explicit IsotropicTerm(std::shared_ptr<const Soup> soup) : mSoup(std::move(soup)) {}

    void setFactor(double factor) override { mFactor = factor; }

    double value(std::span<const double> x) const override
    {
        double sum = 0;
        for (int t = 0; t < mSoup->triangleCount(); ++t) {
            const SingularValues s(&x[6 * static_cast<std::size_t>(t)], mSoup->basis[t]);
            if (!(s.s2 > 0))
                return std::numeric_limits<double>::infinity();
            sum += mSoup->weight[t] * Density::value(s.s1, s.s2);
        }
        return mFactor * sum;
    }

    void addDerivatives(std::span<const double> x, std::span<double> gradient,
                        HessianBlocks &blocks) const override
    {
        for (int t = 0; t < mSoup->triangleCount(); ++t) {
            const std::size_t at = 6 * static_cast<std::size_t>(t);
            addTriangle(&x[at], mSoup->basis[t], mFactor * mSoup->weight[t], &gradient[at],
                        blocks.triangle[t]);
        }
    }

private:
    static void addTriangle(const double *p, const Soup::Basis &b, double weight, double *gradient,
                            std::array<double, 21> &block)
    {
        const SingularValues s(p, b);
        const DensityDerivatives d = Density::derivatives(s.s1, s.s2);
        // Unit directions of the rotational and the shearing part; the latter is arbitrary for a similarity.
        const double re = s.e / s.q, rh = s.h / s.q;
        const double sf = s.r > 0 ? s.f / s.r : 1, sg = s.r > 0 ? s.g / s.r : 0;
        constexpr double root = 0.70710678118654752440;
        double d1[6], d2[6], twist[6], flip[6];
        modeVector(b, 0.5 * (re + sf), 0.5 * (sg - rh), 0.5 * (rh + sg), 0.5 * (re - sf), d1);
        modeVector(b, 0.5 * (re - sf), 0.5 * (-rh - sg), 0.5 * (rh - sg), 0.5 * (re + sf), d2);
        modeVector(b, -root * rh, -root * re, root * re, -root * rh, twist);
        modeVector(b, -root * sg, root * sf, root * sf, root * sg, flip);
        for (int i = 0; i < 6; ++i)
            gradient[i] += weight * (d.g1 * d1[i] + d.g2 * d2[i]);
        int at = 0;
        for (int i = 0; i < 6; ++i) {
            const double a1 = weight * (d.h11 * d1[i] + d.h12 * d2[i]);
            const double a2 = weight * (d.h12 * d1[i] + d.h22 * d2[i]);
            const double at1 = weight * d.twist * twist[i];
            const double af = weight * d.flip * flip[i];
            for (int j = 0; j <= i; ++j)
                block[at++] += a1 * d1[j] + a2 * d2[j] + at1 * twist[j] + af * flip[j];
        }
    }

    std::shared_ptr<const Soup> mSoup;
    double mFactor = 1;
};

} // namespace

std::unique_ptr<DistortionTerm> makeDistortionTerm(std::shared_ptr<const Soup> soup, DistortionEnergy kind)
{
    if (kind == DistortionEnergy::Amips)
        return std::make_unique<IsotropicTerm<AmipsDensity>>(std::move(soup));
    return std::make_unique<IsotropicTerm<SymmetricDirichletDensity>>(std::move(soup));
}

std::vector<double> symmetricDirichlet(const Soup &soup, std::span<const double> x)
{
    std::vector<double> result(soup.triangleCount());
    for (int t = 0; t < soup.triangleCount(); ++t) {
        const SingularValues s(&x[6 * static_cast<std::size_t>(t)], soup.basis[t]);
        result[t] = s.s2 > 0 ? SymmetricDirichletDensity::value(s.s1, s.s2)
                             : std::numeric_limits<double>::infinity();
    }
    return result;
}

double maxFlipFreeStep(const Soup &soup, std::span<const double> x, std::span<const double> direction,
                       double limit)
{
    double step = limit;
    for (int t = 0; t < soup.triangleCount(); ++t) {
        const double *p = &x[6 * static_cast<std::size_t>(t)];
        const double *d = &direction[6 * static_cast<std::size_t>(t)];
        const double u1 = p[2] - p[0], v1 = p[3] - p[1], u2 = p[4] - p[0], v2 = p[5] - p[1];
        const double du1 = d[2] - d[0], dv1 = d[3] - d[1], du2 = d[4] - d[0], dv2 = d[5] - d[1];
        // Area along the step: a s^2 + b s + c, c > 0.
        const double a = du1 * dv2 - dv1 * du2;
        const double b = u1 * dv2 - v1 * du2 + du1 * v2 - dv1 * u2;
        const double c = u1 * v2 - v1 * u2;
        // No root before `step` when the parabola's bound from below stays positive.
        if (c + std::min(0.0, b) * step + std::min(0.0, a) * step * step > 0)
            continue;
        const double discriminant = b * b - 4 * a * c;
        if (discriminant < 0)
            continue;
        // The smallest positive root, in the form that does not cancel: 2c / (-b + sqrt) for c > 0.
        const double denominator = -b + std::sqrt(discriminant);
        if (denominator > 0)
            step = std::min(step, 2 * c / denominator);
    }
    return step;
}

} // namespace autocuts
