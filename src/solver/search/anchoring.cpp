#include "solver/search/anchoring.h"

#include "solver/base/cornerat.h"
#include "solver/base/rigidfit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace autocuts::search {

namespace {

// Chosen by hand; their effect has not been measured.
constexpr double hardPinWeight = 100; // of a hard pin against a soft one of weight 1, when a chart is placed
constexpr int angles = 24;        // directions in a quarter turn in which a chart is fitted to a rectangle
constexpr double boxShare = 0.98; // of the rectangle that a fitted chart takes at most
constexpr double firstStiffness = 10; // springs of hard pins: 10, 100 ... 100,000
constexpr int stiffnessLevels = 5;
constexpr int stepsPerLevel = 6;
constexpr double atPin = 1e-9; // solver units: nearer corners lie on their pin

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

//! What holds one chart.
struct ChartAnchors
{
    std::vector<PointMatch> pins;
    const Anchor *box = nullptr; //!< a corner's box of the chart's first rectangle
    std::vector<Vec2> inBox;     //!< the corners that belong into it

    //! True when the chart lies where it is held, so that springs can do the rest.
    bool isThere() const
    {
        if (!pins.empty())
            return std::all_of(pins.begin(), pins.end(), [](const PointMatch &pin) {
                return (pin.fixed - pin.moving).squaredNorm() < atPin * atPin;
            });
        return !box || std::any_of(inBox.begin(), inBox.end(),
                                   [this](const Vec2 &p) { return box->outside(p).squaredNorm() == 0; });
    }
};

} // namespace

void placeAtAnchors(CutState &state)
{
    const SeamGraph &graph = *state.graph;
    std::vector<ChartAnchors> charts(state.chartCount());
    for (const Anchor &anchor : graph.anchors.all()) {
        ChartAnchors &chart = charts[state.chart[anchor.soupCorner / 3]];
        if (!anchor.isBox) {
            const double weight = anchor.isHardPin ? hardPinWeight : std::max(anchor.stiffness, 1e-6);
            chart.pins.push_back({anchor.lower, state.at(anchor.soupCorner), weight});
            continue;
        }
        if (!chart.box)
            chart.box = &anchor;
        if (anchor.lower == chart.box->lower && anchor.upper == chart.box->upper)
            chart.inBox.push_back(state.at(anchor.soupCorner));
    }
    std::vector<std::optional<Placement>> placements(charts.size());
    for (std::size_t i = 0; i < charts.size(); ++i) {
        if (charts[i].isThere())
            continue;
        if (!charts[i].pins.empty()) {
            const RigidMotion motion = fitRigid(charts[i].pins);
            placements[i] = Placement{motion.movingCentre, motion.fixedCentre, motion.c, motion.s};
        } else if (charts[i].box) {
            placements[i] = fitToBox(charts[i].inBox, charts[i].box->lower, charts[i].box->upper);
        }
    }
    for (int c = 0; c < 3 * graph.triangleCount(); ++c) {
        if (const std::optional<Placement> &place = placements[state.chart[c / 3]])
            cornerAt(state.x, c) = (*place)(state.at(c));
    }
    state.anchored = true;
    state.spreadCharts();
    state.chartsMayMeet = false;
    state.chartsMayMeet = state.boundariesOverlap();
    state.updateEnergy();
}

void reachPins(SeamTrial &trial, bool guarded)
{
    CutState &state = trial.state();
    const std::vector<Anchor> &anchors = state.graph->anchors.all();
    // What lies on its pin already must not be pulled off by something else.
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        if (anchors[i].isHardPin && state.at(anchors[i].soupCorner) == anchors[i].lower)
            state.pinReached[i] = 1;
    }
    double stiffness = firstStiffness;
    for (int level = 0; level < stiffnessLevels && state.anchorFaults() > 0; ++level, stiffness *= 10) {
        state.pinStiffness = std::max(state.pinStiffness, stiffness);
        state.updateEnergy();
        trial.relaxAll(stepsPerLevel, guarded);
        for (std::size_t i = 0; i < anchors.size(); ++i) {
            if (anchors[i].isHardPin && !state.pinReached[i])
                trial.reachPin(static_cast<int>(i), guarded);
        }
    }
    state.updateEnergy();
}

int settleAtAnchors(const std::shared_ptr<const SeamGraph> &graph, SeamedMap &map, int steps, bool guarded)
{
    CutState state = CutState::from(graph, map, true);
    SeamTrial trial(state);
    trial.relaxAll(steps, guarded);
    reachPins(trial, guarded);
    map = state.map();
    return state.anchorFaults();
}

} // namespace autocuts::search
