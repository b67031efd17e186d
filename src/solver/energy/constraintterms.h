// Pins and rectangles as terms of the energy.
#pragma once

#include "model/plain/snapshot.h"
#include "solver/energy/energyterm.h"

#include <vector>

namespace autocuts::energy {

//! Springs that pull soup corners to their targets: weight / 2 * |x - target|^2 for each pin.
class PinTerm final : public EnergyTerm
{
public:
    explicit PinTerm(std::vector<Pin> pins) : mPins(std::move(pins)) {}

    double value(std::span<const double> x) const override;
    double addDerivatives(std::span<const double> x, std::span<double> gradient,
                          HessianBlocks &blocks) const override;

private:
    std::vector<Pin> mPins;
};

//! Factor on the squared distances outside a rectangle: beta times the rectangle's own weight, 100 times that
//! when the rectangle is hard.
double boxStiffness(const UvRectangle &box, double beta);

//! Box energy B (paper, Eq. 10 and 11): squared distance outside the rectangle, per coordinate, over the
//! corners that the rectangle acts on, times boxStiffness(). Continuously differentiable; the second
//! derivative jumps at the sides.
class BoxTerm final : public EnergyTerm
{
public:
    BoxTerm(std::vector<UvRectangle> rectangles, double weight)
        : mRectangles(std::move(rectangles)), mWeight(weight)
    {}

    double value(std::span<const double> x) const override;
    double addDerivatives(std::span<const double> x, std::span<double> gradient,
                          HessianBlocks &blocks) const override;

private:
    std::vector<UvRectangle> mRectangles;
    double mWeight;
};

} // namespace autocuts::energy
