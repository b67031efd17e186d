#include "solver/search/patchkernel.h"

#include "solver/base/simd.h"

#include <algorithm>
#include <cstring>

namespace autocuts::search {

namespace {

[[gnu::always_inline]] inline void loadCorners(std::size_t block, const std::vector<int> &point,
                                               const std::vector<double> &position, TriangleLanes *p)
{
    alignas(triangleAlignment) double at[6][triangleLanes];
    const std::size_t first = 3 * triangleLanes * block, last = point.size() - 3;
    for (std::size_t lane = 0; lane < triangleLanes; ++lane) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double *corner =
                &position[2 * static_cast<std::size_t>(point[std::min(first + 3 * lane, last) + k])];
            at[2 * k][lane] = corner[0];
            at[2 * k + 1][lane] = corner[1];
        }
    }
    std::memcpy(p, at, sizeof at);
}

} // namespace

AUTOCUTS_CLONES
void blockEnergies(const std::vector<TriangleBlock> &blocks, const std::vector<int> &point,
                   const std::vector<double> &position, bool rigid, std::vector<double> &energy)
{
    TriangleLanes p[6];
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const TriangleBlock &block = blocks[i];
        loadCorners(i, point, position, p);
        TriangleLanes density;
        setDirichletDensity(p, block.basis, density);
        if (rigid)
            density = 4.0 + block.stiffness * (density - 4);
        const TriangleLanes weighted = block.weight * density;
        std::memcpy(&energy[triangleLanes * i], &weighted, sizeof weighted);
    }
}

AUTOCUTS_CLONES
void blockDerivatives(const std::vector<TriangleBlock> &blocks, std::size_t which,
                      const std::vector<int> &point, const std::vector<double> &position,
                      BlockDerivatives &derivatives)
{
    const TriangleBlock &block = blocks[which];
    TriangleLanes p[6];
    loadCorners(which, point, position, p);
    dirichletDerivatives(p, block.basis, TriangleLanes(block.stiffness * block.weight), derivatives.gradient,
                         derivatives.hessian);
}

} // namespace autocuts::search
