#include "solver/energy/distortion.h"

#include "solver/energy/dirichletkernel.h"
#include "solver/energy/isotropic.h"

#include <cmath>
#include <limits>

namespace autocuts::energy {

namespace {

//! Singular values of a Jacobian with positive determinant, and the rotations that diagonalise it.
struct SingularValues
{
    double e, f, g, h; // J = [e + f, g - h; g + h, e - f]
    double q, r;       // s1 = q + r, s2 = q - r
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
        // q - r cancels when q and r are close; the determinant is s1 * s2.
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

//! Positions of the entries of an EdgeMatrix in a triangle's 6 x 6 block. Moving all three corners alike
//! changes nothing, so the rows of corners 1 and 2 contain everything.
constexpr std::array<int, 10> overEdges{5, 12, 14, 8, 13, 9, 17, 19, 18, 20};

template <class Density>
class IsotropicTerm : public DistortionTerm
{
public:
    explicit IsotropicTerm(std::shared_ptr<const Soup> soup, ThreadTeam *team)
        : mSoup(std::move(soup)), mTeam(team)
    {}

    void setFactor(double factor) override { mFactor = factor; }

    double value(std::span<const double> x) const override
    {
        return mFactor * sumInOrder(mTeam, mSoup->triangleCount(),
                                    [&](int first, int end) { return sumOf(x, first, end); });
    }

    double addDerivatives(std::span<const double> x, std::span<double> gradient,
                          HessianBlocks &blocks) const override
    {
        return mFactor * sumInOrder(mTeam, mSoup->triangleCount(), [&](int first, int end) {
                   for (int t = first; t < end; ++t) {
                       const std::size_t at = 6 * static_cast<std::size_t>(t);
                       std::array<double, 21> block{};
                       addTriangle(&x[at], mSoup->basis[t], mFactor * mSoup->weight[t], &gradient[at], block);
                       if (!blocks.triangle.empty()) {
                           for (int i = 0; i < 21; ++i)
                               blocks.triangle[t][i] += block[i];
                       } else {
                           for (int i = 0; i < 10; ++i)
                               blocks.lanes[t / laneCount][i][t % laneCount] =
                                   static_cast<float>(block[overEdges[i]]);
                       }
                   }
                   return sumOf(x, first, end);
               });
    }

protected:
    const Soup &soup() const { return *mSoup; }
    ThreadTeam *team() const { return mTeam; }
    double factor() const { return mFactor; }

private:
    double sumOf(std::span<const double> x, int first, int end) const
    {
        double sum = 0;
        for (int t = first; t < end; ++t) {
            const SingularValues s(&x[6 * static_cast<std::size_t>(t)], mSoup->basis[t]);
            if (!(s.s2 > 0))
                return std::numeric_limits<double>::infinity();
            sum += mSoup->weight[t] * Density::value(s.s1, s.s2);
        }
        return sum;
    }

    static void addTriangle(const double *p, const Soup::Basis &b, double weight, double *gradient,
                            std::array<double, 21> &block)
    {
        const SingularValues s(p, b);
        const DensityDerivatives d = Density::derivatives(s.s1, s.s2);
        // Unit directions of the rotation and the shearing part. For a similarity the latter is zero and its
        // direction arbitrary.
        const double re = s.e / s.q, rh = s.h / s.q;
        const double sf = s.r > 0 ? s.f / s.r : 1, sg = s.r > 0 ? s.g / s.r : 0;
        // 1 / sqrt(2), which gives the modes unit length.
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
    ThreadTeam *mTeam;
    double mFactor = 1;
};

//! The symmetric Dirichlet term. Where single precision is enough for the Hessian it is computed for eight
//! triangles at a time.
class SymmetricDirichletTerm final : public IsotropicTerm<SymmetricDirichletDensity>
{
public:
    SymmetricDirichletTerm(std::shared_ptr<const Soup> soup, ThreadTeam *team)
        : IsotropicTerm(std::move(soup), team), mBlocks(dirichletBlocks(this->soup()))
    {}

    double value(std::span<const double> x) const override
    {
        return factor() * sumInOrder(team(), soup().triangleCount(), [&](int first, int end) {
                   return dirichletSum(&mBlocks[first / laneCount], &x[6 * static_cast<std::size_t>(first)],
                                       end - first);
               });
    }

    double addDerivatives(std::span<const double> x, std::span<double> gradient,
                          HessianBlocks &blocks) const override
    {
        if (!blocks.triangle.empty())
            return IsotropicTerm::addDerivatives(x, gradient, blocks);
        return factor() * sumInOrder(team(), soup().triangleCount(), [&](int first, int end) {
                   const std::size_t at = 6 * static_cast<std::size_t>(first);
                   return dirichletDerivatives(&mBlocks[first / laneCount], &x[at], end - first, factor(),
                                               &gradient[at], &blocks.lanes[first / laneCount]);
               });
    }

private:
    std::vector<DirichletBlock> mBlocks;
};

} // namespace

std::unique_ptr<DistortionTerm> makeDistortionTerm(std::shared_ptr<const Soup> soup, DistortionEnergy kind,
                                                   ThreadTeam *team)
{
    if (kind == DistortionEnergy::Amips)
        return std::make_unique<IsotropicTerm<AmipsDensity>>(std::move(soup), team);
    return std::make_unique<SymmetricDirichletTerm>(std::move(soup), team);
}

std::vector<double> symmetricDirichlet(const Soup &soup, std::span<const double> x)
{
    std::vector<double> result(soup.triangleCount());
    for (int t = 0; t < soup.triangleCount(); ++t) {
        const SingularValues s(&x[6 * static_cast<std::size_t>(t)], soup.basis[t]);
        result[t] =
            s.s2 > 0 ? SymmetricDirichletDensity::value(s.s1, s.s2) : std::numeric_limits<double>::infinity();
    }
    return result;
}

double maxFlipFreeStep(const Soup &soup, std::span<const double> x, std::span<const double> direction,
                       double limit, ThreadTeam *team)
{
    std::vector<double> steps(jobCount(soup.triangleCount()));
    runOn(team, static_cast<int>(steps.size()), [&](int i) {
        const int first = i * jobSize;
        const std::size_t at = 6 * static_cast<std::size_t>(first);
        steps[i] =
            flipFreeStep(&x[at], &direction[at], std::min(jobSize, soup.triangleCount() - first), limit);
    });
    double step = limit;
    for (const double own : steps)
        step = std::min(step, own);
    return step;
}

} // namespace autocuts::energy
