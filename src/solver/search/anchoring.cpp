#include "solver/search/anchoring.h"

#include "solver/base/cornerat.h"
#include "solver/base/cutmesh.h"
#include "solver/base/rigidfit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace autocuts::search {

namespace {

// Chosen by hand.
constexpr double hardPinWeight = 100; // of a hard pin against a soft one of weight 1, when a chart is placed
constexpr int angles = 24;        // directions in a quarter turn in which a chart is fitted to a rectangle
constexpr double boxShare = 0.98; // of the rectangle that a fitted chart takes at most
constexpr double firstStiffness = 10; // springs of hard pins: 10, 100 ... 100,000
constexpr int stiffnessLevels = 5;
constexpr int stepsPerLevel = 6;
constexpr double atPin = 1e-9;     // solver units: nearer corners lie on their pin
constexpr double rounding = 1e-11; // of a scale, and of a place in solver units

//! A similarity: scale, turn, move.
struct Placement
{
    Vec2 centre = Vec2::Zero(), target = Vec2::Zero();
    double c = 1, s = 0;

    Vec2 operator()(const Vec2 &p) const
    {
        const Vec2 d = p - centre;
        return target + Vec2(c * d.x() - s * d.y(), s * d.x() + c * d.y());
    }
};

//! The placement into a box that scales the points down least.
Placement fitToBox(const std::vector<Vec2> &points, const Vec2 &lower, const Vec2 &upper)
{
    Placement best;
    double bestScale = 0;
    for (int i = 0; i < angles && bestScale < 1; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / angles;
        const double c = std::cos(angle), s = std::sin(angle);
        Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
        for (const Vec2 &p : points) {
            const Vec2 turned(c * p.x() - s * p.y(), s * p.x() + c * p.y());
            low = low.cwiseMin(turned);
            high = high.cwiseMax(turned);
        }
        const Vec2 size = (high - low).cwiseMax(1e-12);
        const double scale = std::min(1.0, boxShare * (upper - lower).cwiseQuotient(size).minCoeff());
        if (scale <= bestScale)
            continue;
        bestScale = scale;
        const Vec2 middle = 0.5 * (low + high);
        best.centre = Vec2(c * middle.x() + s * middle.y(), c * middle.y() - s * middle.x());
        best.target = 0.5 * (lower + upper);
        best.c = scale * c;
        best.s = scale * s;
    }
    return best;
}

//! True when the chart lies at its pins, so that springs can do the rest.
bool isThere(const std::vector<PointMatch> &pins)
{
    return std::all_of(pins.begin(), pins.end(), [](const PointMatch &pin) {
        return (pin.fixed - pin.moving).squaredNorm() < atPin * atPin;
    });
}

//! Moves charts. From then on the anchors have an effect.
void place(CutState &state, const std::vector<std::optional<Placement>> &placements)
{
    for (int c = 0; c < 3 * state.graph->triangleCount(); ++c) {
        if (const std::optional<Placement> &place = placements[state.chart[c / 3]])
            cornerAt(state.x, c) = (*place)(state.at(c));
    }
    state.anchored = true;
    state.spreadCharts();
    state.chartsMayMeet = false;
    state.chartsMayMeet = state.boundariesOverlap();
    state.updateEnergy();
}

//! Holds what lies on its hard pin already, so that nothing else pulls it off. It is put exactly there.
void holdAtPins(CutState &state)
{
    const CutMesh charts(*state.graph->soup->mesh, CutFlags(state.cut.begin(), state.cut.end()));
    std::vector<const Anchor *> pinAt(charts.uvVertexCount, nullptr);
    const std::vector<Anchor> &anchors = state.graph->anchors.all();
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        const Vec2 away = state.at(anchors[i].soupCorner) - anchors[i].lower;
        if (!anchors[i].isHardPin || away.norm() > rounding)
            continue;
        pinAt[charts.uvVertex[anchors[i].soupCorner]] = &anchors[i];
        state.pinReached[i] = 1;
    }
    for (int c = 0; c < 3 * state.graph->triangleCount(); ++c) {
        if (const Anchor *pin = pinAt[charts.uvVertex[c]])
            cornerAt(state.x, c) = pin->lower;
    }
}

} // namespace

void placeAtAnchors(CutState &state)
{
    std::vector<std::vector<PointMatch>> pins(state.chartCount());
    for (const Anchor &anchor : state.graph->anchors.all()) {
        const double weight = anchor.isHardPin ? hardPinWeight : std::max(anchor.stiffness, 1e-6);
        pins[state.chart[anchor.soupCorner / 3]].push_back(
            {anchor.lower, state.at(anchor.soupCorner), weight});
    }
    std::vector<std::optional<Placement>> placements(pins.size());
    for (std::size_t i = 0; i < pins.size(); ++i) {
        if (isThere(pins[i]))
            continue;
        const RigidMotion motion = fitRigid(pins[i]);
        placements[i] = Placement{motion.movingCentre, motion.fixedCentre, motion.c, motion.s};
    }
    place(state, placements);
}

bool fitsInto(const std::vector<double> &x, const std::vector<int> &soupCorners, const Vec2 &lower,
              const Vec2 &upper)
{
    std::vector<Vec2> points;
    for (const int corner : soupCorners)
        points.push_back(cornerAt(x, corner));
    const Placement fit = fitToBox(points, lower, upper);
    return std::hypot(fit.c, fit.s) > 1 - rounding;
}

std::optional<SeamedMap> fittedToBoxes(const std::shared_ptr<const SeamGraph> &graph, const SeamedMap &map,
                                       int steps, const JobContext &job)
{
    CutState state = CutState::from(graph, map, true);
    std::vector<std::vector<Vec2>> points(state.chartCount());
    std::vector<const Anchor *> boxes(state.chartCount(), nullptr);
    for (const Anchor &anchor : graph->anchors.all()) {
        const int chart = state.chart[anchor.soupCorner / 3];
        points[chart].push_back(state.at(anchor.soupCorner));
        boxes[chart] = &anchor;
    }
    std::vector<std::optional<Placement>> placements(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i])
            placements[i] = fitToBox(points[i], boxes[i]->lower, boxes[i]->upper);
    }
    place(state, placements);
    SeamTrial(state).relaxAnchored(steps, true, job.quiet());
    return job.stopped() ? std::nullopt : std::optional(state.map());
}

void reachPins(SeamTrial &trial, bool guarded, const JobContext &job)
{
    CutState &state = trial.state();
    const std::vector<Anchor> &anchors = state.graph->anchors.all();
    holdAtPins(state);
    trial.reset();
    double stiffness = firstStiffness;
    for (int level = 0; level < stiffnessLevels && state.anchorFaults() > 0 && !job.stopped();
         ++level, stiffness *= 10) {
        state.pinStiffness = std::max(state.pinStiffness, stiffness);
        state.updateEnergy();
        trial.relaxAll(stepsPerLevel, guarded, job.quiet());
        for (std::size_t i = 0; i < anchors.size(); ++i) {
            if (anchors[i].isHardPin && !state.pinReached[i])
                trial.reachPin(static_cast<int>(i), guarded);
        }
    }
    state.updateEnergy();
}

int settleAtAnchors(const std::shared_ptr<const SeamGraph> &graph, SeamedMap &map, int steps, bool guarded,
                    const JobContext &job)
{
    CutState state = CutState::from(graph, map, true);
    SeamTrial trial(state);
    trial.relaxAll(steps, guarded, job.quiet());
    reachPins(trial, guarded, job);
    map = state.map();
    return state.anchorFaults();
}

} // namespace autocuts::search
