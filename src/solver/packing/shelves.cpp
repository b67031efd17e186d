#include "solver/packing/shelves.h"

#include <algorithm>
#include <numbers>

namespace autocuts::packing {

namespace {

struct Block
{
    int island;
    double angle;
    Vec2 low, size; //!< box around the turned outline, relative to its centre
};

Block makeBlock(const PackProblem &problem, int island, double scale)
{
    const Outline &outline = problem.outlines[island];
    Block block{island, problem.smallBoxAngle(island), {}, {}};
    Vec2 size = rotatedBox(outline.hull, block.angle);
    // A box on its longer side makes a lower shelf.
    const bool fits = size.y() * scale <= problem.size().x() && size.x() * scale <= problem.size().y();
    const bool mayLie = problem.directions(island) % 4 == 0; // also when it turns freely
    if (mayLie && size.y() > size.x() && fits)
        block.angle += 0.5 * std::numbers::pi;
    const Turn turn(block.angle, scale);
    Eigen::AlignedBox2d box;
    for (const Vec2 &p : outline.hull)
        box.extend(turn(p));
    block.low = box.min();
    block.size = box.sizes();
    return block;
}

} // namespace

std::optional<Layout> packShelves(const PackProblem &problem, double scale, WorkMeter &work)
{
    // Slack for rounding, so that gutter and border are kept exactly.
    const double slack = 1e-12 * (problem.upper.cwiseAbs() + problem.lower.cwiseAbs()).maxCoeff();
    const double gap = problem.gutter * (1 + 1e-9) + slack;
    const Vec2 lower = problem.lower + Vec2::Constant(slack), upper = problem.upper - Vec2::Constant(slack);
    std::vector<Block> blocks;
    std::vector<Eigen::AlignedBox2d> obstacles;
    double points = 0;
    for (int i = 0; i < problem.count(); ++i) {
        if (problem.movable(i)) {
            blocks.push_back(makeBlock(problem, i, scale));
            points += static_cast<double>(problem.outlines[i].hull.size());
        } else if (problem.locked[i]) {
            Eigen::AlignedBox2d box;
            for (const Vec2 &p : problem.outlines[i].hull)
                box.extend(p * problem.unit + problem.given[i].position);
            obstacles.push_back(box);
        }
    }
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const Block &a, const Block &b) { return a.size.y() > b.size.y(); });
    Layout layout{scale, problem.given};
    Vec2 at = lower;
    double shelf = 0;
    for (std::size_t next = 0; next < blocks.size();) {
        const Block &block = blocks[next];
        shelf = std::max(shelf, block.size.y());
        if (!(at.y() + block.size.y() <= upper.y()) || !(block.size.x() <= upper.x() - lower.x()))
            return std::nullopt;
        const Eigen::AlignedBox2d box(at, at + block.size);
        if (!(box.max().x() <= upper.x())) {
            at = Vec2(lower.x(), at.y() + shelf + gap);
            shelf = 0;
            continue;
        }
        const auto hit = std::find_if(obstacles.begin(), obstacles.end(),
                                      [&](const Eigen::AlignedBox2d &o) { return areNear(o, box, gap); });
        if (hit != obstacles.end()) {
            at.x() = hit->max().x() + gap * (1 + 1e-6) + slack;
            continue;
        }
        layout.poses[block.island] = {block.angle, at - block.low};
        at.x() = box.max().x() + gap;
        ++next;
    }
    work.add(100 * static_cast<double>(blocks.size()) + 20 * points +
             2.0 * static_cast<double>(obstacles.size() * blocks.size()));
    return layout;
}

} // namespace autocuts::packing
