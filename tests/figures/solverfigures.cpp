#include "figures/solverfigures.h"

#include "figures/figuredrawing.h"
#include "solver/definite/stitching.h"
#include "solver/homotopy/anneal.h"
#include "solver/homotopy/solver.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace autocuts::figures {

using namespace definite;
using namespace homotopy;

namespace {

constexpr int slowSteps = 40; // per level of delta
constexpr View faceView{210, 10}, cutView{300, 10};

//! What a panel shows, in numbers.
struct Figures
{
    double distortion = 0, seamLength = 0;
    int seamEdges = 0;
};

Snapshot snapshotOf(const Model &model)
{
    Snapshot snapshot;
    snapshot.mesh = model.mesh;
    return snapshot;
}

//! The state as it is: how far each edge is apart.
Panel livePanel(const Solver &solver)
{
    Panel panel;
    panel.x = solver.coordinates();
    for (std::size_t e = 0; e < solver.soup().mesh->edgePairs.size(); ++e)
        panel.redness.push_back(std::max(solver.separation(2 * static_cast<int>(e)),
                                         solver.separation(2 * static_cast<int>(e) + 1)));
    return panel;
}

//! The map that the state stands for, with seams that are there or not.
Panel finishedPanel(const Solver &solver, Figures &figures)
{
    SeamedMap map = stitchSoup(solver.sharedSoup(), solver.snapshot(), solver.coordinates());
    Panel panel;
    for (const bool cut : map.cut)
        panel.redness.push_back(cut ? 1 : 0);
    figures = {map.distortion(solver.soup()), map.seamLength(solver.soup()),
               static_cast<int>(std::count(map.cut.begin(), map.cut.end(), true))};
    panel.x = std::move(map.x);
    return panel;
}

QString captionOf(const QString &title, const Figures &f)
{
    return QStringLiteral("%1\nD %2, length %3, %4 edges")
        .arg(title)
        .arg(f.distortion, 0, 'f', 3)
        .arg(f.seamLength, 0, 'f', 2)
        .arg(f.seamEdges);
}

QStringList rowOf(const QString &title, const Figures &f)
{
    return {title, QString::number(f.distortion, 'f', 4), QString::number(f.seamLength, 'f', 3),
            QString::number(f.seamEdges)};
}

//! Draws the picture and adds the figure to the page.
void add(FigurePage &page, const Figure &figure, const Model &model, const Solver &solver,
         const std::vector<Panel> &panels, const View &view, const std::vector<QStringList> &rows)
{
    if (!drawFigure(page.pathOf(figure), solver.soup(), panels, view))
        throw std::runtime_error("cannot write " + page.pathOf(figure).toStdString());
    page.add(figure, described(model),
             {QString(), QStringLiteral("D"), QStringLiteral("length"), QStringLiteral("edges")}, rows);
}

//! All corners as seen along z: half of them turned over.
UvMatrix projected(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) = mesh.cornerPosition(c).head<2>();
    return uv;
}

//! The shut edge whose triangles are distorted most.
std::size_t strainedEdge(const Solver &solver, const Panel &panel)
{
    const MeshData &mesh = *solver.soup().mesh;
    std::size_t best = 0;
    double most = -1;
    for (std::size_t e = 0; e < mesh.edgePairs.size(); ++e) {
        const EdgePair &pair = mesh.edgePairs[e];
        double energy = 0;
        for (const int t : pair.triangle)
            energy += solver.soup().weight[t] * energyOf(solver.soup(), panel.x, t);
        if (!pair.diagonal && panel.redness[e] < 0.5 && energy > most) {
            most = energy;
            best = e;
        }
    }
    return best;
}

} // namespace

void lambdaBalance(FigurePage &page, const Figure &figure)
{
    const Model model = page.model(QStringLiteral("organic/planck1.obj"), QStringLiteral("character"));
    std::vector<Panel> panels;
    std::vector<QStringList> rows;
    Solver solver;
    for (const double lambda : {0.005, 0.02, 0.06, 0.15}) {
        solver.load(snapshotOf(model));
        annealSoup(solver, {.lambda = lambda, .stepsPerLevel = slowSteps}, nullptr);
        Figures f;
        panels.push_back(finishedPanel(solver, f));
        const QString title = QStringLiteral("lambda %1").arg(lambda);
        panels.back().caption = captionOf(title, f);
        rows.push_back(rowOf(title, f));
    }
    add(page, figure, model, solver, panels, faceView, rows);
}

void deltaSweep(FigurePage &page, const Figure &figure)
{
    const Model model = page.model(QStringLiteral("organic/hand_1_i_f5000.obj"), QStringLiteral("character"));
    std::vector<Panel> panels;
    std::vector<QStringList> rows;
    Snapshot snapshot = snapshotOf(model);
    snapshot.settings.lambda = 0.1;
    Solver solver;
    solver.load(snapshot);
    for (const double delta : {1.0, 0.0625, 0.00390625, 0.000244140625}) {
        // By quarters from one picture to the next, as the homotopy goes.
        for (double d = std::max(delta, snapshot.settings.delta / 4);; d = std::max(delta, d / 4)) {
            snapshot.settings.delta = d;
            solver.update(snapshot);
            for (int i = 0; i < slowSteps; ++i)
                solver.step();
            if (d <= delta)
                break;
        }
        const StepResult last = solver.step();
        panels.push_back(livePanel(solver));
        const auto apart = [](double s) { return s >= 0.5; };
        Figures f{last.distortion, 0,
                  static_cast<int>(
                      std::count_if(panels.back().redness.begin(), panels.back().redness.end(), apart))};
        for (std::size_t e = 0; e < panels.back().redness.size(); ++e)
            f.seamLength += apart(panels.back().redness[e]) ? solver.soup().pairLength[2 * e] : 0;
        const QString title = QStringLiteral("delta %1").arg(delta, 0, 'g', 3);
        panels.back().caption = captionOf(title, f);
        rows.push_back(rowOf(title, f));
    }
    add(page, figure, model, solver, panels, {}, rows);
}

void fourStarts(FigurePage &page, const Figure &figure)
{
    const Model model = page.model(QStringLiteral("organic/cathead.obj"), QStringLiteral("bumpycube"));
    std::vector<Panel> panels;
    std::vector<QStringList> rows;
    Solver solver;
    const std::pair<StartMode, QString> starts[] = {{StartMode::Tutte, QStringLiteral("Tutte")},
                                                    {StartMode::Rigid, QStringLiteral("rigid triangles")},
                                                    {StartMode::Random, QStringLiteral("random")},
                                                    {StartMode::ExistingUv, QStringLiteral("a projection")}};
    for (const auto &[start, title] : starts) {
        Snapshot snapshot = snapshotOf(model);
        snapshot.settings.start = start;
        if (start == StartMode::ExistingUv)
            snapshot.startUv =
                std::make_shared<const UvMatrix>(startUvFromCorners(*model.mesh, projected(*model.mesh)));
        solver.load(snapshot);
        annealSoup(solver, {.lambda = 0.05, .stepsPerLevel = 5 * slowSteps}, nullptr);
        Figures f;
        panels.push_back(finishedPanel(solver, f));
        panels.back().caption = captionOf(QStringLiteral("from ") + title, f);
        rows.push_back(rowOf(title, f));
    }
    add(page, figure, model, solver, panels, {}, rows);
}

void propagatedCut(FigurePage &page, const Figure &figure)
{
    constexpr double lambda = 0.35;
    constexpr double warmDelta = 0.0625; // as when delta is doubled again after the cut
    const Model model = page.model(QStringLiteral("organic/bishop_part.obj"), QStringLiteral("character"));
    Solver solver;
    solver.load(snapshotOf(model));
    annealSoup(solver, {.lambda = lambda, .stepsPerLevel = slowSteps}, nullptr);
    Figures before, after;
    std::vector<Panel> panels{finishedPanel(solver, before)};
    panels[0].caption = captionOf(QStringLiteral("before"), before);
    const std::size_t edge = strainedEdge(solver, panels[0]);
    Snapshot snapshot = solver.snapshot();
    Steering &steering = snapshot.editSteering();
    steering.pairState.assign(model.mesh->cornerPairCount(), PairState::Free);
    steering.pairState[2 * edge] = steering.pairState[2 * edge + 1] = PairState::Cut;
    snapshot.settings.delta = warmDelta;
    solver.update(snapshot);
    for (int i = 0; i < slowSteps; ++i)
        solver.step();
    panels.push_back(livePanel(solver));
    panels[1].caption = QStringLiteral("one edge is cut:\nthe cut spreads");
    annealSoup(solver, {.startDelta = warmDelta, .lambda = lambda, .stepsPerLevel = slowSteps}, nullptr);
    panels.push_back(finishedPanel(solver, after));
    panels[2].caption = captionOf(QStringLiteral("result"), after);
    add(page, figure, model, solver, panels, cutView,
        {rowOf(QStringLiteral("before"), before), rowOf(QStringLiteral("one edge cut"), after)});
}

void lengthOrCount(FigurePage &page, const Figure &figure)
{
    const Model model = page.model(QStringLiteral("organic/girl1.obj"), QStringLiteral("machine"));
    std::vector<Panel> panels;
    std::vector<QStringList> rows;
    Solver solver;
    const std::pair<SeamWeighting, QString> weightings[] = {{SeamWeighting::Length, QStringLiteral("length")},
                                                            {SeamWeighting::Count, QStringLiteral("number")}};
    for (const auto &[weighting, title] : weightings) {
        Snapshot snapshot = snapshotOf(model);
        snapshot.settings.weighting = weighting;
        solver.load(snapshot);
        annealSoup(solver, {.lambda = 0.02, .stepsPerLevel = slowSteps}, nullptr);
        Figures f;
        panels.push_back(finishedPanel(solver, f));
        panels.back().caption = captionOf(QStringLiteral("least ") + title, f);
        rows.push_back(rowOf(QStringLiteral("least ") + title, f));
    }
    add(page, figure, model, solver, panels, {}, rows);
}

} // namespace autocuts::figures
