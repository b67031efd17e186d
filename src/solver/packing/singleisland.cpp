#include "solver/packing/singleisland.h"

#include <algorithm>
#include <numbers>

namespace autocuts::packing {

namespace {

double scaleAtAngle(const PackProblem &problem, const Outline &outline, double angle)
{
    const Vec2 box = rotatedBox(outline.hull, angle);
    double scale = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 2; ++axis) {
        if (box[axis] > 0)
            scale = std::min(scale, problem.size()[axis] / box[axis]);
    }
    return scale;
}

//! Golden-section search around a sampled maximum.
double refineAngle(const PackProblem &problem, const Outline &outline, double angle, double width)
{
    constexpr double ratio = 0.6180339887498949;
    double low = angle - width, high = angle + width;
    for (int i = 0; i < 40; ++i) {
        const double a = high - ratio * (high - low), b = low + ratio * (high - low);
        if (scaleAtAngle(problem, outline, a) >= scaleAtAngle(problem, outline, b))
            high = b;
        else
            low = a;
    }
    return 0.5 * (low + high);
}

double bestAngle(const PackProblem &problem, int island, WorkMeter &work)
{
    const Outline &outline = problem.outlines[island];
    const double right = 0.5 * std::numbers::pi;
    std::vector<double> angles{problem.turnsFreely(island) ? 0 : problem.angleOf(island, 0)};
    // The box is the same after half a turn.
    for (int k = 1; 2 * k < problem.directions(island); ++k)
        angles.push_back(problem.angleOf(island, k));
    if (problem.turnsFreely(island)) {
        angles.push_back(right);
        constexpr int samples = 720;
        const double width = std::numbers::pi / samples;
        int best = 0;
        for (int i = 1; i < samples; ++i) {
            if (scaleAtAngle(problem, outline, i * width) > scaleAtAngle(problem, outline, best * width))
                best = i;
        }
        angles.push_back(refineAngle(problem, outline, best * width, width));
        angles.push_back(outline.boxAngle);
        angles.push_back(outline.boxAngle + right);
        work.add(6.0 * samples * static_cast<double>(outline.hull.size()));
    }
    return *std::max_element(angles.begin(), angles.end(), [&](double a, double b) {
        return scaleAtAngle(problem, outline, a) < scaleAtAngle(problem, outline, b);
    });
}

} // namespace

std::optional<Layout> fitSingleIsland(const PackProblem &problem, double ceiling, WorkMeter &work)
{
    int only = -1;
    for (int i = 0; i < problem.count(); ++i) {
        if (problem.outlines[i].points.empty())
            continue;
        if (only >= 0 || problem.locked[i])
            return std::nullopt;
        only = i;
    }
    if (only < 0 || !(problem.outlines[only].radius > 0))
        return std::nullopt;
    const Outline &outline = problem.outlines[only];
    const double angle = bestAngle(problem, only, work);
    Layout layout{std::min(ceiling, scaleAtAngle(problem, outline, angle) * (1 - 1e-12)), problem.given};
    const Turn turn(angle, layout.scale);
    Eigen::AlignedBox2d box;
    for (const Vec2 &p : outline.hull)
        box.extend(turn(p));
    layout.poses[only] = {angle, 0.5 * (problem.lower + problem.upper) - 0.5 * (box.min() + box.max())};
    if (!isValidLayout(problem, layout, work))
        return std::nullopt;
    return layout;
}

} // namespace autocuts::packing
