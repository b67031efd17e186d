#include "solver/energy/constraintterms.h"

namespace autocuts::energy {

double PinTerm::value(std::span<const double> x) const
{
    double sum = 0;
    for (const Pin &pin : mPins) {
        const std::size_t at = 2 * static_cast<std::size_t>(pin.soupCorner);
        const double du = x[at] - pin.target.x();
        const double dv = x[at + 1] - pin.target.y();
        sum += 0.5 * pin.weight * (du * du + dv * dv);
    }
    return sum;
}

double PinTerm::addDerivatives(std::span<const double> x, std::span<double> gradient,
                               HessianBlocks &blocks) const
{
    std::vector<double> &ground = blocks.addedGround();
    for (const Pin &pin : mPins) {
        for (int i = 0; i < 2; ++i) {
            const std::size_t at = 2 * static_cast<std::size_t>(pin.soupCorner) + i;
            gradient[at] += pin.weight * (x[at] - pin.target[i]);
            ground[at] += pin.weight;
        }
    }
    return value(x);
}

namespace {

//! How many times stiffer a hard rectangle is than a soft one. Chosen by hand.
constexpr double hardBoxFactor = 100;

//! Signed distance outside [lower, upper]: negative below, positive above, 0 inside.
inline double outside(double value, double lower, double upper)
{
    return value < lower ? value - lower : value > upper ? value - upper : 0;
}

} // namespace

double boxStiffness(const UvRectangle &box, double beta)
{
    return beta * box.weight * (box.hard ? hardBoxFactor : 1);
}

double BoxTerm::value(std::span<const double> x) const
{
    double sum = 0;
    for (const UvRectangle &box : mRectangles) {
        double squares = 0;
        for (const int corner : box.soupCorners) {
            for (int i = 0; i < 2; ++i) {
                const double d =
                    outside(x[2 * static_cast<std::size_t>(corner) + i], box.lower[i], box.upper[i]);
                squares += d * d;
            }
        }
        sum += boxStiffness(box, mWeight) * squares;
    }
    return sum;
}

double BoxTerm::addDerivatives(std::span<const double> x, std::span<double> gradient,
                               HessianBlocks &blocks) const
{
    std::vector<double> &ground = blocks.addedGround();
    for (const UvRectangle &box : mRectangles) {
        const double weight = boxStiffness(box, mWeight);
        for (const int corner : box.soupCorners) {
            for (int i = 0; i < 2; ++i) {
                const std::size_t at = 2 * static_cast<std::size_t>(corner) + i;
                const double d = outside(x[at], box.lower[i], box.upper[i]);
                if (d == 0)
                    continue;
                gradient[at] += 2 * weight * d;
                ground[at] += 2 * weight;
            }
        }
    }
    return value(x);
}

} // namespace autocuts::energy
