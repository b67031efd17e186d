#include "solver/overlap/predicates.h"

#include <array>
#include <cmath>
#include <limits>

namespace autocuts::overlap {

namespace {

//! A sum of doubles without rounding (Shewchuk 1997): components that do not overlap, the smallest first.
class ExactSum
{
public:
    void add(double value)
    {
        int kept = 0;
        for (int i = 0; i < mSize; ++i) {
            const double sum = value + mPart[i];
            const double other = sum - value;
            const double rest = (value - (sum - other)) + (mPart[i] - other);
            if (rest != 0)
                mPart[kept++] = rest;
            value = sum;
        }
        if (value != 0)
            mPart[kept++] = value;
        mSize = kept;
    }

    void addProduct(double a, double b)
    {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }

    //! The largest component is greater than the sum of all others.
    int sign() const { return mSize == 0 ? 0 : mPart[mSize - 1] > 0 ? 1 : -1; }

private:
    std::array<double, 16> mPart{};
    int mSize = 0;
};

int exactOrientation(const Vec2 &a, const Vec2 &b, const Vec2 &c)
{
    ExactSum sum;
    sum.addProduct(a.x(), b.y());
    sum.addProduct(-a.y(), b.x());
    sum.addProduct(b.x(), c.y());
    sum.addProduct(-b.y(), c.x());
    sum.addProduct(c.x(), a.y());
    sum.addProduct(-c.y(), a.x());
    return sum.sign();
}

} // namespace

int orientation(const Vec2 &a, const Vec2 &b, const Vec2 &c)
{
    // Each of the two products has three rounding errors of half an ulp, their difference one more.
    constexpr double half = std::numeric_limits<double>::epsilon() / 2;
    constexpr double bound = (3 + 16 * half) * half;
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    const double area = left - right;
    const double uncertain = bound * (std::abs(left) + std::abs(right));
    if (area > uncertain)
        return 1;
    if (area < -uncertain)
        return -1;
    // Equal points are common where triangles share corners, and need no further arithmetic.
    if (a == c || b == c || a == b)
        return 0;
    return exactOrientation(a, b, c);
}

} // namespace autocuts::overlap
