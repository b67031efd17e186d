#include "figures/mapfigures.h"

#include "commands/changesettings.h"
#include "figures/mapwork.h"
#include "views/tools/painttool.h"

#include <QFileInfo>
#include <QPainter>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace autocuts::figures {

using namespace Qt::Literals::StringLiterals;
using unwrap::UnwrapQuality;

namespace {

constexpr QSize half(450, 400), third(300, 300), quarter(225, 240);
constexpr double soupLambda = 0.02, defaultLambda = 0.05; // of the live solver
constexpr int mostDrags = 40;

void save(const FigurePage &page, const Figure &figure, const QImage &picture)
{
    if (!saveSmall(picture, page.pathOf(figure)))
        throw std::runtime_error("cannot write " + page.pathOf(figure).toStdString());
}

void unwrapped(StudioPictures &studio)
{
    studio.runJob([&] { studio.canvases().map.unwrap(UnwrapQuality::Standard); });
}

const QStringList mapHead{QString(), u"D"_s, u"seam length"_s, u"islands"_s, u"overlapping pairs"_s};

QStringList mapRow(StudioPictures &studio, const QString &title)
{
    const MapNumbers n = numbersOf(studio);
    return {title, QString::number(n.distortion, 'f', 3), QString::number(n.seamLength, 'f', 2),
            QString::number(n.islands), QString::number(n.overlaps)};
}

QString percent(double share)
{
    return QString::number(100 * share, 'f', 0) + u" %"_s;
}

//! The vertex of the mesh that is farthest in a direction.
Vec3 extreme(const MeshData &mesh, const Vec3 &direction)
{
    Eigen::Index best = 0;
    (mesh.positions * direction).maxCoeff(&best);
    return mesh.positions.row(best);
}

//! Strokes of the paint tool along edges of the cube. \param corners in turn, as signs of x, y and z
void paintAlong(StudioPictures &studio, Paint paint, const std::vector<Vec3> &corners)
{
    MeshView &view = studio.canvases().mesh;
    const MeshFrame &frame = view.content().frame();
    QList<QPoint> places;
    for (const Vec3 &signs : corners) {
        const auto point = view.camera().project(frame.toFrame(extreme(studio.document().mesh(), signs)));
        places << QPoint(static_cast<int>(std::lround(point->x)), static_cast<int>(std::lround(point->y)));
    }
    studio.canvases().tools.setTool(u"paint"_s);
    QTest::keyClick(&view, paint == Paint::KeepTogether ? Qt::Key_1 : Qt::Key_2);
    test::Canvases::drag(view, places);
    studio.canvases().tools.setTool(u"select"_s);
}

//! One picture above another.
QImage stacked(const QImage &upper, const QImage &lower)
{
    QImage both(std::max(upper.width(), lower.width()), upper.height() + lower.height(),
                QImage::Format_RGB32);
    both.fill(upper.pixel(0, 0));
    QPainter painter(&both);
    painter.drawImage(0, 0, upper);
    painter.drawImage(0, upper.height(), lower);
    return both;
}

} // namespace

void bumpyCube(FigurePage &page, const Figure &figure)
{
    constexpr Look look{35, 28};
    const Scene scene = page.scene({}, u"bumpycube"_s);
    StudioPictures studio;
    std::vector<Column> columns;
    std::vector<QStringList> rows;
    const auto addRow = [&](const QString &title) {
        rows.push_back(mapRow(studio, title) << percent(shareOnSharpEdges(studio.document())));
    };
    const auto addColumn = [&](const QString &title) {
        addRow(title);
        columns.push_back(columnOf(studio, title, look, third));
        columns.back().lines << rows.back().back() + u" of the seams on the cube's edges"_s;
    };
    studio.open(withSoupMap(scene, defaultLambda));
    addRow(u"live solver alone, lambda 0.05"_s);
    studio.options().pattern = Pattern::Checker;
    studio.open(scene);
    unwrapped(studio);
    addColumn(u"Unwrap, defaults"_s);

    SolveSettings settings = studio.open(scene).solveSettings();
    settings.creases = CreaseMode::Off;
    pushCommand(std::make_unique<ChangeSettings>(studio.document(), settings));
    unwrapped(studio);
    addColumn(u"edges not preferred"_s);

    studio.open(scene);
    studio.aim(third, look);
    // The edges in front are to open, those of the lid's back to stay whole.
    paintAlong(studio, Paint::AttractCuts, {{-1, 1, 1}, {1, 1, 1}, {1, -1, 1}});
    paintAlong(studio, Paint::KeepTogether, {{1, 1, 0.6}, {1, 1, -1}, {-1, 1, -1}, {-1, 1, 0.6}});
    unwrapped(studio);
    studio.options().pattern = Pattern::None;
    studio.options().coloring = Coloring::PaintWeights;
    addColumn(u"painted"_s);
    save(page, figure, sheetOf(columns));
    page.add(figure, described({u"bumpycube"_s, scene.mesh}),
             QStringList(mapHead) << u"seams on sharp edges"_s, rows);
}

void overlapRegions(FigurePage &page, const Figure &figure)
{
    constexpr Look look{30, 10};
    const Scene scene = page.scene(u"organic/camel_simple.obj"_s, u"character"_s);
    StudioPictures studio;
    std::vector<Column> columns;
    std::vector<QStringList> rows;
    studio.options().selection = true;
    studio.open(withOverlaps(scene));
    const auto add = [&](const QString &title) {
        columns.push_back(columnOf(studio, title, look, third));
        rows.push_back(mapRow(studio, title));
    };
    add(u"overlaps are hatched"_s);
    dragRegionsAway(studio, 1);
    add(u"a region is dragged away"_s);
    const int drags = 1 + dragRegionsAway(studio, mostDrags);
    studio.canvases().select(SelectionMode::Faces);
    studio.runJob([&] { studio.canvases().map.pack(PackScope::All); });
    studio.options().pattern = Pattern::Checker;
    studio.options().coloring = Coloring::Islands;
    add(u"after %1 drags, packed"_s.arg(drags));
    save(page, figure, sheetOf(columns));
    page.add(figure, described({u"camel_simple"_s, scene.mesh}), mapHead, rows);
}

void irregularMesh(FigurePage &page, const Figure &figure)
{
    const Scene scene = page.scene(u"irregular/beetle.obj"_s, u"machine"_s);
    StudioPictures studio;
    studio.options().pattern = Pattern::Checker;
    studio.options().coloring = Coloring::Islands;
    studio.open(scene);
    unwrapped(studio);
    Column model = columnOf(studio, u"Unwrap"_s, {30, 18}, half);
    Column map;
    map.pictures = {model.pictures.back()};
    model.pictures.pop_back();
    map.title = u"its map"_s;
    map.lines << u"%1 parts that are not joined"_s.arg(componentsOf(*scene.mesh));
    save(page, figure, sheetOf({model, map}));
    page.add(figure, described({u"beetle"_s, scene.mesh}), QStringList(mapHead) << u"parts of the mesh"_s,
             {mapRow(studio, u"Unwrap"_s) << QString::number(componentsOf(*scene.mesh))});
}

void octopusPatches(FigurePage &page, const Figure &figure)
{
    constexpr Look look{25, 25};
    const Scene scene = page.scene(u"organic/octopus.obj"_s, u"character"_s);
    StudioPictures studio;
    studio.options().coloring = Coloring::Islands;
    std::vector<Column> columns;
    std::vector<QStringList> rows{{u"Sorkine et al. 2002, as the paper shows it"_s, u"not given"_s,
                                   u"not given"_s, u"\"numerous\""_s, u"0"_s, u"many, and short strips"_s,
                                   u"3 (its bound)"_s}};
    const auto add = [&](const QString &title) {
        const MapNumbers n = numbersOf(studio);
        columns.push_back(columnOf(studio, title, look, third));
        rows.push_back(mapRow(studio, title)
                       << QString::number(n.singleTriangles) << QString::number(n.worstStretch, 'f', 2));
    };
    const Scene covered = withOverlaps(scene);
    studio.open(covered);
    dragRegionsAway(studio, mostDrags);
    studio.runJob([&] { studio.canvases().map.pack(PackScope::All); });
    add(u"assisted: regions by hand"_s);
    studio.open(covered);
    studio.runJob([&] { studio.canvases().map.separateGreedily(); });
    add(u"the paper's greedy heuristic"_s);
    studio.open(scene);
    unwrapped(studio);
    add(u"Unwrap"_s);
    save(page, figure, sheetOf(columns));
    page.add(figure, described({u"octopus"_s, scene.mesh}),
             QStringList(mapHead) << u"islands of one triangle"_s << u"worst stretch"_s, rows);
}

void quadMesh(FigurePage &page, const Figure &figure)
{
    const Scene scene = page.scene(u"polygons/horse_quad.obj"_s, u"character"_s);
    StudioPictures studio;
    studio.options().wireframe = true;
    studio.open(withSoupMap(scene, soupLambda));
    const Look look{40, 10};
    std::vector<Column> columns{columnOf(studio, u"live solver alone"_s, look, half)};
    std::vector<QStringList> rows{mapRow(studio, u"live solver alone"_s)};
    studio.open(scene);
    unwrapped(studio);
    columns.push_back(columnOf(studio, u"Unwrap"_s, look, half));
    rows.push_back(mapRow(studio, u"Unwrap"_s));
    save(page, figure, sheetOf(columns));
    page.add(figure, described({u"horse_quad"_s, scene.mesh}), mapHead, rows);
}

namespace {

//! What is painted on a model of figure 17.
enum class Painted { Nothing, FrontTogether, MiddleCut };

//! A model of figure 17.
struct Shown
{
    const char *file, *sample, *title;
    Look look;
    Painted painted = Painted::Nothing;
    UpAxis up = UpAxis::Y;
};

QString nameOf(Painted painted)
{
    return painted == Painted::Nothing         ? u"no help"_s
           : painted == Painted::FrontTogether ? u"painted: front together"_s
                                               : u"painted: cuts at x = 0"_s;
}

} // namespace

void severalModels(FigurePage &page, const Figure &figure)
{
    const Shown models[] = {
        {"organic/hand_1_i_f5000.obj", "character", "Hand", {25, 10}},
        {"organic/camel_simple.obj", "character", "camel, for the Elk", {35, 10}},
        {"organic/octopus.obj", "character", "Octopus", {25, 25}},
        {"organic/planck1.obj", "character", "bust, for the Moai", {178, 5}},
        {"organic/torus_with_holes.obj", "torus", "torus, for the Eight", {20, 20}, Painted::FrontTogether},
        {"organic/girl1.obj", "character", "Girl", {70, 5}, Painted::FrontTogether, UpAxis::X},
        {"", "torus", "handles, for the Tet", {30, 35}, Painted::MiddleCut},
    };
    StudioPictures studio;
    studio.options().coloring = Coloring::Islands;
    studio.options().pattern = Pattern::Checker;
    std::vector<Column> columns;
    std::vector<QStringList> rows;
    for (const Shown &shown : models) {
        const Scene scene = page.scene(QString::fromUtf8(shown.file), QString::fromUtf8(shown.sample));
        studio.open(scene, shown.up);
        if (shown.painted == Painted::FrontTogether)
            keepSeenTogether(studio.document(), shown.look);
        else if (shown.painted == Painted::MiddleCut)
            attractCutsToMiddle(studio.document());
        unwrapped(studio);
        const QString title = QString::fromUtf8(shown.title);
        columns.push_back(columnOf(studio, title, shown.look, quarter));
        columns.back().lines << nameOf(shown.painted);
        rows.push_back(mapRow(studio, title + u"; "_s + nameOf(shown.painted)));
    }
    const auto middle = columns.begin() + 4;
    save(page, figure, stacked(sheetOf({columns.begin(), middle}), sheetOf({middle, columns.end()})));
    page.add(figure, u"the columns of the picture, in the same order"_s, mapHead, rows);
}

} // namespace autocuts::figures
