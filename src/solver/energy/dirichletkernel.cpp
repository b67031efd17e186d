#include "solver/energy/dirichletkernel.h"

#include "solver/base/simd.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace autocuts::energy {

namespace {

//! Upper bound on Hessian entries: they and their products must stay finite in single precision.
constexpr double largestEntry = 1e15;

//! Coordinates of the places after the last triangle: the right triangle mapped to itself.
constexpr double padding[6] = {0, 0, 1, 0, 0, 1};

//! Edge vectors of eight triangles: u and v from corner 0 to corners 1 and 2.
struct Edges
{
    DoubleLanes u1, v1, u2, v2;
};

inline void loadEdges(const double *x, int triangles, Edges &e)
{
    alignas(DoubleLanes) double u1[laneCount], v1[laneCount], u2[laneCount], v2[laneCount];
    for (int lane = 0; lane < laneCount; ++lane) {
        const double *p = lane < triangles ? x + 6 * lane : padding;
        u1[lane] = p[2] - p[0];
        v1[lane] = p[3] - p[1];
        u2[lane] = p[4] - p[0];
        v2[lane] = p[5] - p[1];
    }
    std::memcpy(&e.u1, u1, sizeof u1);
    std::memcpy(&e.v1, v1, sizeof v1);
    std::memcpy(&e.u2, u2, sizeof u2);
    std::memcpy(&e.v2, v2, sizeof v2);
}

struct Jacobian
{
    DoubleLanes j00, j01, j10, j11;
};

inline void jacobian(const DirichletBlock &block, const Edges &e, Jacobian &j)
{
    j.j00 = e.u1 * block.basis[0] + e.u2 * block.basis[2];
    j.j01 = e.u1 * block.basis[1] + e.u2 * block.basis[3];
    j.j10 = e.v1 * block.basis[0] + e.v2 * block.basis[2];
    j.j11 = e.v1 * block.basis[1] + e.v2 * block.basis[3];
}

//! Adds the weighted energies to `sum`. Lowers `smallest` to the smallest determinant, or to NaN when one is
//! NaN.
inline void energies(const DirichletBlock &block, const Jacobian &j, DoubleLanes &sum, DoubleLanes &smallest)
{
    const DoubleLanes det = j.j00 * j.j11 - j.j01 * j.j10;
    const DoubleLanes squares = j.j00 * j.j00 + j.j01 * j.j01 + j.j10 * j.j10 + j.j11 * j.j11;
    sum += block.weight * (squares + squares / (det * det));
    smallest = smallest > det ? det : smallest;
}

inline double total(const DoubleLanes &sum, const DoubleLanes &smallest)
{
    double result = 0;
    for (int lane = 0; lane < laneCount; ++lane) {
        if (!(smallest[lane] > 0))
            return std::numeric_limits<double>::infinity();
        result += sum[lane];
    }
    return std::isnan(result) ? std::numeric_limits<double>::infinity() : result;
}

inline void roots(const DoubleLanes &a, DoubleLanes &root)
{
    for (int lane = 0; lane < laneCount; ++lane)
        root[lane] = std::sqrt(a[lane]);
}

inline void narrow(const DoubleLanes &a, Lanes &result)
{
    result = __builtin_convertvector(a, Lanes);
}

//! Symmetric 4 x 4 matrix over the Jacobian's entries (00, 01, 10, 11): sum of scale * mode mode^T.
struct JacobianHessian
{
    Lanes k[4][4]; //!< lower triangle

    inline void set(const Lanes &scale, const Lanes *mode)
    {
        for (int a = 0; a < 4; ++a) {
            const Lanes scaled = scale * mode[a];
            for (int b = 0; b <= a; ++b)
                k[a][b] = scaled * mode[b];
        }
    }
    inline void add(const Lanes &scale, const Lanes *mode)
    {
        for (int a = 0; a < 4; ++a) {
            const Lanes scaled = scale * mode[a];
            for (int b = 0; b <= a; ++b)
                k[a][b] += scaled * mode[b];
        }
    }
    //! The 2 x 2 block, row by row, between a corner with gradient g and a corner with gradient h.
    inline void between(const Lanes *g, const Lanes *h, Lanes *out) const
    {
        out[0] = g[0] * (k[0][0] * h[0] + k[1][0] * h[1]) + g[1] * (k[1][0] * h[0] + k[1][1] * h[1]);
        out[1] = g[0] * (k[2][0] * h[0] + k[3][0] * h[1]) + g[1] * (k[2][1] * h[0] + k[3][1] * h[1]);
        out[2] = h[0] * (k[2][0] * g[0] + k[3][0] * g[1]) + h[1] * (k[2][1] * g[0] + k[3][1] * g[1]);
        out[3] = g[0] * (k[2][2] * h[0] + k[3][2] * h[1]) + g[1] * (k[3][2] * h[0] + k[3][3] * h[1]);
    }
};

//! The matrix over the edge vectors instead. g and h are the gradients of corners 1 and 2.
inline void hessianOverEdges(const JacobianHessian &k, const Lanes *g, const Lanes *h, EdgeMatrix &out)
{
    Lanes a[4], b[4], c[4]; // corners 1-1, 2-1, 2-2
    k.between(g, g, a);
    k.between(h, g, b);
    k.between(h, h, c);
    out[0] = a[0];
    out[1] = b[0];
    out[2] = c[0];
    out[3] = a[2];
    out[4] = b[1];
    out[5] = a[3];
    out[6] = b[2];
    out[7] = c[2];
    out[8] = b[3];
    out[9] = c[3];
}

} // namespace

std::vector<DirichletBlock> dirichletBlocks(const Soup &soup)
{
    std::vector<DirichletBlock> blocks((soup.triangleCount() + laneCount - 1) / laneCount);
    for (int t = 0; t < static_cast<int>(blocks.size()) * laneCount; ++t) {
        DirichletBlock &block = blocks[t / laneCount];
        const bool real = t < soup.triangleCount();
        for (int i = 0; i < 4; ++i)
            block.basis[i][t % laneCount] = real ? soup.basis[t][2 + i] : double(i == 0 || i == 3);
        block.weight[t % laneCount] = real ? soup.weight[t] : 0;
    }
    return blocks;
}

AUTOCUTS_CLONES
double dirichletSum(const DirichletBlock *blocks, const double *x, int triangles)
{
    DoubleLanes sum{}, smallest = DoubleLanes{} + 1;
    for (int t = 0; t < triangles; t += laneCount) {
        const DirichletBlock &block = blocks[t / laneCount];
        Edges edges{};
        Jacobian j;
        loadEdges(x + 6 * static_cast<std::ptrdiff_t>(t), triangles - t, edges);
        jacobian(block, edges, j);
        energies(block, j, sum, smallest);
    }
    return total(sum, smallest);
}

// One long function, because the gradient and the Hessian share most of the computation.
AUTOCUTS_CLONES
double dirichletDerivatives(const DirichletBlock *blocks, const double *x, int triangles, double factor,
                            double *gradient, EdgeMatrix *hessian)
{
    DoubleLanes sum{}, smallest = DoubleLanes{} + 1;
    for (int t = 0; t < triangles; t += laneCount) {
        const DirichletBlock &block = blocks[t / laneCount];
        Edges edges{};
        Jacobian j;
        loadEdges(x + 6 * static_cast<std::ptrdiff_t>(t), triangles - t, edges);
        jacobian(block, edges, j);
        energies(block, j, sum, smallest);

        const DoubleLanes e = 0.5 * (j.j00 + j.j11), f = 0.5 * (j.j00 - j.j11);
        const DoubleLanes g = 0.5 * (j.j10 + j.j01), h = 0.5 * (j.j10 - j.j01);
        DoubleLanes q, r;
        roots(e * e + h * h, q);
        roots(f * f + g * g, r);
        // q - r cancels when q and r are close; the determinant is s1 * s2, hence s2 = det / s1.
        const DoubleLanes s1 = q + r, det = j.j00 * j.j11 - j.j01 * j.j10;
        const DoubleLanes i1 = 1 / s1, s2 = det * i1, i2 = s1 / det;
        const DoubleLanes c1 = i1 * i1 * i1, c2 = i2 * i2 * i2;
        const DoubleLanes weight = factor * block.weight;
        const DoubleLanes turn = weight * ((s1 - c1) + (s2 - c2)) / q;
        const DoubleLanes flip = 2 * weight * (1 + (s1 * s1 + s1 * s2 + s2 * s2) * c1 * c2);

        // Gradient with respect to the Jacobian: turn * its rotation part + flip * its shearing part.
        const DoubleLanes te = turn * e, th = turn * h, ff = flip * f, fg = flip * g;
        const DoubleLanes g00 = te + ff, g01 = fg - th, g10 = th + fg, g11 = te - ff;
        const DoubleLanes gu1 = g00 * block.basis[0] + g01 * block.basis[1];
        const DoubleLanes gv1 = g10 * block.basis[0] + g11 * block.basis[1];
        const DoubleLanes gu2 = g00 * block.basis[2] + g01 * block.basis[3];
        const DoubleLanes gv2 = g10 * block.basis[2] + g11 * block.basis[3];
        double *out = gradient + 6 * static_cast<std::ptrdiff_t>(t);
        for (int lane = 0; lane < std::min(laneCount, triangles - t); ++lane, out += 6) {
            out[0] -= gu1[lane] + gu2[lane];
            out[1] -= gv1[lane] + gv2[lane];
            out[2] += gu1[lane];
            out[3] += gv1[lane];
            out[4] += gu2[lane];
            out[5] += gv2[lane];
        }

        Lanes curvature1, curvature2, turning, flipping, re, rh, sf, sg, b[4];
        const DoubleLanes slope = block.basis[0] * block.basis[0] + block.basis[1] * block.basis[1] +
                                  block.basis[2] * block.basis[2] + block.basis[3] * block.basis[3];
        const DoubleLanes large = largestEntry / (1 + slope);
        const auto limited = [&large](const DoubleLanes &a, Lanes &result) {
            const DoubleLanes clamped = a > large ? large : a;
            narrow(clamped, result);
        };
        limited(weight * (2 + 6 * c1 * i1), curvature1);
        limited(weight * (2 + 6 * c2 * i2), curvature2);
        limited(turn > 0 ? turn : DoubleLanes{}, turning);
        limited(flip, flipping);
        // Unit directions of the two parts. For a similarity the shearing part is zero and its direction
        // arbitrary.
        const DoubleLanes iq = 1 / q, ir = r > 0 ? 1 / r : DoubleLanes{};
        narrow(e * iq, re);
        narrow(h * iq, rh);
        narrow(r > 0 ? f * ir : DoubleLanes{} + 1, sf);
        narrow(g * ir, sg);
        for (int i = 0; i < 4; ++i)
            narrow(block.basis[i], b[i]);
        // 1 / sqrt(2), which gives the modes unit length.
        constexpr float root = 0.70710678f;
        const Lanes first[4] = {0.5f * (re + sf), 0.5f * (sg - rh), 0.5f * (rh + sg), 0.5f * (re - sf)};
        const Lanes second[4] = {0.5f * (re - sf), -0.5f * (rh + sg), 0.5f * (rh - sg), 0.5f * (re + sf)};
        const Lanes twist[4] = {-root * rh, -root * re, root * re, -root * rh};
        const Lanes shear[4] = {-root * sg, root * sf, root * sf, root * sg};
        JacobianHessian k;
        k.set(curvature1, first);
        k.add(curvature2, second);
        k.add(turning, twist);
        k.add(flipping, shear);
        hessianOverEdges(k, b, b + 2, hessian[t / laneCount]);
    }
    return total(sum, smallest);
}

AUTOCUTS_CLONES
double flipFreeStep(const double *x, const double *direction, int triangles, double limit)
{
    double step = limit;
    for (int t = 0; t < triangles; t += laneCount) {
        Edges p{}, d{};
        loadEdges(x + 6 * static_cast<std::ptrdiff_t>(t), triangles - t, p);
        loadEdges(direction + 6 * static_cast<std::ptrdiff_t>(t), triangles - t, d);
        // Twice the area along the step: a s^2 + b s + c with c > 0.
        const DoubleLanes a = d.u1 * d.v2 - d.v1 * d.u2;
        const DoubleLanes b = p.u1 * d.v2 - p.v1 * d.u2 + d.u1 * p.v2 - d.v1 * p.u2;
        const DoubleLanes c = p.u1 * p.v2 - p.v1 * p.u2;
        // There is no root before `step` when this lower bound of the parabola is positive.
        const DoubleLanes zero{};
        const DoubleLanes bound = c + (b < 0 ? b : zero) * step + (a < 0 ? a : zero) * step * step;
        for (int lane = 0; lane < std::min(laneCount, triangles - t); ++lane) {
            if (bound[lane] > 0)
                continue;
            const double discriminant = b[lane] * b[lane] - 4 * a[lane] * c[lane];
            if (discriminant < 0)
                continue;
            // The smallest positive root, in the form that does not cancel: 2c / (-b + sqrt) for c > 0.
            const double denominator = -b[lane] + std::sqrt(discriminant);
            if (denominator > 0)
                step = std::min(step, 2 * c[lane] / denominator);
        }
    }
    return step;
}

} // namespace autocuts::energy
