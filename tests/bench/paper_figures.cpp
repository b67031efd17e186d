// Makes figures 2, 4, 5, 7 and 13 of the paper with the live solver, and a page with their numbers.
// Usage: paper_figures FOLDER [MESHES]   MESHES: folder of organic/cathead.obj and the like; without it the
// program's own samples are solved
#include "bench/figuredrawing.h"
#include "model/io/meshfile.h"
#include "model/samples/samples.h"
#include "solver/definite/stitching.h"
#include "solver/homotopy/anneal.h"
#include "solver/homotopy/solver.h"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QTextStream>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

using namespace autocuts;
using namespace autocuts::definite;
using namespace autocuts::homotopy;
using figures::Panel;
using figures::View;

namespace {

constexpr int slowSteps = 40; // per level of delta
constexpr View faceView{210, 10}, cutView{300, 10};

struct Model
{
    QString name;
    std::shared_ptr<const MeshData> mesh;
};

//! What a panel shows, in numbers.
struct Figures
{
    double distortion = 0, seamLength = 0;
    int seamEdges = 0;
};

class Gallery
{
public:
    Gallery(const QString &folder, const QString &meshes) : mFolder(folder), mMeshes(meshes), mStream(&mText)
    {
        mStream
            << "# Figures of the paper, made by this program\n\n"
               "`scripts/figures` makes these pictures with the live solver (the triangle soup and its "
               "homotopy, without the seam search). Above: the surface, parted edges red. Below: the map, "
               "white where nothing is distorted, blue where the symmetric Dirichlet energy is 6 or more. D: "
               "mean energy, 4 is isometric. Length: of the seams, for a surface of area pi.\n";
    }

    void lambdaBalance();
    void deltaSweep();
    void fourStarts();
    void propagatedCut();
    void lengthOrCount();
    bool writePage();

private:
    Model model(const QString &file, const QString &sample) const;
    void add(const QString &file, const QString &title, const Model &model, const Solver &solver,
             std::vector<Panel> panels, const View &view, const QStringList &rows);

    QString mFolder, mMeshes;
    QString mText;
    QTextStream mStream;
};

Model Gallery::model(const QString &file, const QString &sample) const
{
    const QString path = mMeshes + QLatin1Char('/') + file;
    Result<Scene> scene = !mMeshes.isEmpty() && QFile::exists(path) ? readMesh(path) : makeSample(sample);
    if (!scene)
        throw std::runtime_error(scene.error().toString().toStdString());
    return {scene->path.isEmpty() ? sample : QFileInfo(file).completeBaseName(), scene->mesh};
}

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

QString rowOf(const QString &title, const Figures &f)
{
    return QStringLiteral("| %1 | %2 | %3 | %4 |")
        .arg(title)
        .arg(f.distortion, 0, 'f', 4)
        .arg(f.seamLength, 0, 'f', 3)
        .arg(f.seamEdges);
}

void Gallery::add(const QString &file, const QString &title, const Model &model, const Solver &solver,
                  std::vector<Panel> panels, const View &view, const QStringList &rows)
{
    if (!figures::drawFigure(mFolder + QLatin1Char('/') + file, solver.soup(), panels, view))
        throw std::runtime_error("cannot write " + file.toStdString());
    mStream << "\n## " << title << "\n\n![" << title << "](" << file << ")\n\nMesh: " << model.name << ", "
            << model.mesh->triangleCount() << " triangles.\n\n| | D | length | edges |\n|---|---|---|---|\n"
            << rows.join(QLatin1Char('\n')) << '\n';
}

void Gallery::lambdaBalance()
{
    const Model model = this->model(QStringLiteral("organic/planck1.obj"), QStringLiteral("character"));
    std::vector<Panel> panels;
    QStringList rows;
    Solver solver;
    for (const double lambda : {0.005, 0.02, 0.06, 0.15}) {
        solver.load(snapshotOf(model));
        annealSoup(solver, {.lambda = lambda, .stepsPerLevel = slowSteps}, nullptr);
        Figures f;
        panels.push_back(finishedPanel(solver, f));
        const QString title = QStringLiteral("lambda %1").arg(lambda);
        panels.back().caption = captionOf(title, f);
        rows << rowOf(title, f);
    }
    add(QStringLiteral("figure2_lambda.png"),
        QStringLiteral("Figure 2: lambda balances cuts against distortion"), model, solver, panels, faceView,
        rows);
}

void Gallery::deltaSweep()
{
    const Model model =
        this->model(QStringLiteral("organic/hand_1_i_f5000.obj"), QStringLiteral("character"));
    std::vector<Panel> panels;
    QStringList rows;
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
        rows << rowOf(title, f);
    }
    add(QStringLiteral("figure4_delta.png"),
        QStringLiteral("Figure 4: smaller delta turns soft separation into cuts (lambda 0.1)"), model, solver,
        panels, {}, rows);
}

//! All corners as seen along z: half of them turned over.
UvMatrix projected(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int c = 0; c < mesh.cornerCount(); ++c)
        uv.row(c) = mesh.cornerPosition(c).head<2>();
    return uv;
}

void Gallery::fourStarts()
{
    const Model model = this->model(QStringLiteral("organic/cathead.obj"), QStringLiteral("bumpycube"));
    std::vector<Panel> panels;
    QStringList rows;
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
        rows << rowOf(title, f);
    }
    add(QStringLiteral("figure5_starts.png"),
        QStringLiteral("Figure 5: the same result from every start (lambda 0.05)"), model, solver, panels, {},
        rows);
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
            energy += solver.soup().weight[t] * figures::energyOf(solver.soup(), panel.x, t);
        if (!pair.diagonal && panel.redness[e] < 0.5 && energy > most) {
            most = energy;
            best = e;
        }
    }
    return best;
}

void Gallery::propagatedCut()
{
    constexpr double lambda = 0.35;
    constexpr double warmDelta = 0.0625; // as when delta is doubled again after the cut
    const Model model = this->model(QStringLiteral("organic/bishop_part.obj"), QStringLiteral("character"));
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
    add(QStringLiteral("figure7_one_edge.png"),
        QStringLiteral("Figure 7: one edge cut by hand becomes a cut line (lambda 0.35)"), model, solver,
        panels, cutView,
        {rowOf(QStringLiteral("before"), before), rowOf(QStringLiteral("one edge cut"), after)});
}

void Gallery::lengthOrCount()
{
    const Model model = this->model(QStringLiteral("organic/girl1.obj"), QStringLiteral("machine"));
    std::vector<Panel> panels;
    QStringList rows;
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
        rows << rowOf(QStringLiteral("least ") + title, f);
    }
    add(QStringLiteral("figure13_length_count.png"),
        QStringLiteral("Figure 13: least length or least number of cut edges (lambda 0.02)"), model, solver,
        panels, {}, rows);
}

bool Gallery::writePage()
{
    mStream.flush();
    QFile file(mFolder + QStringLiteral("/README.md"));
    return file.open(QIODevice::WriteOnly) && file.write(mText.toUtf8()) > 0;
}

} // namespace

int main(int argc, char **argv)
{
    const QGuiApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    QTextStream err(stderr);
    if (arguments.size() < 2 || arguments.size() > 3) {
        err << "usage: paper_figures FOLDER [MESHES]\n";
        return 2;
    }
    try {
        QDir().mkpath(arguments[1]);
        Gallery gallery(arguments[1], arguments.value(2));
        gallery.lambdaBalance();
        gallery.deltaSweep();
        gallery.fourStarts();
        gallery.propagatedCut();
        gallery.lengthOrCount();
        return gallery.writePage() ? 0 : 1;
    } catch (const std::exception &e) {
        err << "paper_figures: " << e.what() << '\n';
        return 1;
    }
}
