#include "views/panels/doctorpanel.h"

#include "model/layouts/meshdoctor.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/ui/numbertext.h"

#include <QGridLayout>
#include <QLabel>

#include <utility>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The rows of the counts and of the figures whose numbers can be clicked.
constexpr std::pair<std::size_t, Finding> countedFindings[] = {{3, Finding::BoundaryEdges},
                                                               {4, Finding::NonManifoldEdges},
                                                               {5, Finding::WindingEdges},
                                                               {6, Finding::TrianglesWithoutArea},
                                                               {9, Finding::PolygonsThatMeetThemselves}};
constexpr std::pair<std::size_t, Finding> mapFindings[] = {{2, Finding::MostStretched},
                                                           {7, Finding::FacesWithoutUv},
                                                           {8, Finding::CollapsedTriangles},
                                                           {9, Finding::MirroredIslands}};

//! The text of a label as a link, unless it counts nothing.
QString linked(const QString &text)
{
    return text == countText(0) || text == missingText()
               ? text
               : QStringLiteral("<a href=\"#\">%1</a>").arg(text.toHtmlEscaped());
}

QGridLayout *makeGrid(QWidget *owner)
{
    auto *grid = new QGridLayout(owner);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    return grid;
}

} // namespace

DoctorPanel::DoctorPanel(const StudioContext &context, QWidget *parent)
    : Panel(context, tr("Open a model to have it examined."), parent), mNotes(new QLabel)
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing + 2);
    mNotes->setObjectName("notes"_L1);
    mNotes->setWordWrap(true);
    mNotes->setTextFormat(Qt::PlainText);
    mNotes->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    mNotes->setAccessibleName(tr("Findings"));
    layout->addWidget(makeHeading(tr("Findings")));
    layout->addWidget(mNotes);
    layout->addWidget(makeHeading(tr("Model")));
    layout->addWidget(makeCounts());
    layout->addWidget(makeHeading(tr("Map")));
    layout->addWidget(makeFigures());
    layout->addStretch();
    connect(&context.map, &MapController::figuresChanged, this, [this] { refreshSoon(); });
}

QWidget *DoctorPanel::makeCounts()
{
    auto *box = new QWidget;
    QGridLayout *grid = makeGrid(box);
    const auto add = [this, grid](const QString &caption, const QString &tip) {
        mCounts.push_back(addFigure(grid, int(mCounts.size()), 0, caption, tip));
    };
    add(tr("Faces"), tr("Of these polygons, that is faces with more than three corners, in brackets"));
    add(tr("Vertices"), tr("As in the file"));
    add(tr("Objects, parts"), tr("Objects of the file, and connected parts"));
    add(tr("Boundary edges"), tr("Edges with a face on one side only"));
    add(tr("Non-manifold edges"),
        tr("Edges with three or more faces: each face was joined to its best partner"));
    add(tr("Edges of opposite winding"),
        tr("Edges between faces that look to different sides: treated as boundary"));
    add(tr("Triangles without area"), tr("Kept, with a thin stand-in shape while solving"));
    add(tr("Duplicated faces"), tr("Faces at the place of another one"));
    add(tr("Concave polygons"), tr("Polygons that are not convex: split along diagonals inside them"));
    add(tr("Polygons that meet themselves"),
        tr("Polygons with a vertex twice, such as a, b, c, b: cut off from the faces around there"));
    add(tr("Surface area"), tr("In the units of the model"));
    add(tr("Diagonal"), tr("Diagonal of the bounding box, in the units of the model"));
    for (const auto &[row, finding] : countedFindings)
        linkTo(*mCounts[row], finding);
    return box;
}

QWidget *DoctorPanel::makeFigures()
{
    auto *box = new QWidget;
    QGridLayout *grid = makeGrid(box);
    const auto add = [this, grid](const QString &caption, const QString &tip) {
        mFigures.push_back(addFigure(grid, int(mFigures.size()), 0, caption, tip));
    };
    add(tr("Distortion, mean"),
        tr("Area-weighted mean symmetric Dirichlet energy, 4 where nothing is distorted"));
    add(tr("Distortion, 99 %"), tr("99 per cent of the triangles are below this"));
    add(tr("Distortion, largest"), tr("Of the worst triangle"));
    add(tr("L2 stretch"), tr("Sander et al. 2001; 1 where nothing is stretched"));
    add(tr("Angle distortion"), tr("Mean ratio of the two stretches of a triangle; 1 keeps all angles"));
    add(tr("Area distortion"),
        tr("Mean factor between the shares of area in the map and on the model; 1 is best"));
    add(tr("Density spread"), tr("Largest texel density of an island divided by the smallest; 1 is equal"));
    add(tr("Faces without UVs"), tr("Faces that are not in the map"));
    add(tr("Collapsed triangles"), tr("Triangles without area in the map"));
    add(tr("Mirrored islands"), tr("Islands that lie face down"));
    for (const auto &[row, finding] : mapFindings)
        linkTo(*mFigures[row], finding);
    return box;
}

void DoctorPanel::refresh()
{
    if (document()) {
        showNotes(*document());
        showCounts(document()->mesh().report);
    } else {
        mNotes->clear();
        for (QLabel *label : mCounts)
            label->setText(missingText());
    }
    showFigures();
}

void DoctorPanel::showNotes(const Document &document)
{
    // Notes of the workspace also contain those of the file reader, and may repeat findings about the mesh.
    QStringList notes = context().workspace.notes();
    for (const QString &finding : meshDoctorNotes(document.mesh().report)) {
        if (!notes.contains(finding))
            notes << finding;
    }
    for (QString &note : notes)
        note.prepend(u"• "_s);
    mNotes->setText(notes.isEmpty() ? tr("✓ All fine: nothing unusual was found.") : notes.join(u'\n'));
}

void DoctorPanel::selectElements(Finding finding)
{
    Selection selection = elementsOf(*document(), finding);
    if (selection.isEmpty())
        return;
    document()->setSelection(std::move(selection));
    Q_EMIT frameSelectionRequested();
}

void DoctorPanel::linkTo(QLabel &label, Finding finding)
{
    label.setObjectName(u"finding%1"_s.arg(int(finding)));
    label.setTextFormat(Qt::RichText);
    label.setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(&label, &QLabel::linkActivated, this, [this, finding] { selectElements(finding); });
}

void DoctorPanel::showCounts(const MeshReport &report)
{
    const QString texts[] = {report.polygons > 0
                                 ? tr("%1 (%2)").arg(countText(report.faces), countText(report.polygons))
                                 : countText(report.faces),
                             countText(report.vertices),
                             tr("%1, %2").arg(countText(report.objects), countText(report.components)),
                             countText(report.boundaryEdges),
                             countText(report.nonManifoldEdges),
                             countText(report.windingEdges),
                             countText(report.degenerateTriangles),
                             countText(report.duplicateFaces),
                             countText(report.concavePolygons),
                             countText(static_cast<int>(report.selfContactFaces.size())),
                             significantText(report.area, 5),
                             significantText(report.boxDiagonal, 5)};
    for (std::size_t i = 0; i < mCounts.size(); ++i)
        mCounts[i]->setText(texts[i]);
    for (const auto &[row, finding] : countedFindings)
        mCounts[row]->setText(linked(texts[row]));
}

void DoctorPanel::showFigures()
{
    const MapController &map = context().map;
    const MapFigures *figures = document() ? map.figures() : nullptr;
    const bool hasMap = figures && figures->metrics.charts > 0;
    const metrics::UvMetrics none;
    const metrics::UvMetrics &metrics = hasMap ? figures->metrics : none;
    const auto count = [hasMap](int value) { return hasMap ? countText(value) : missingText(); };
    const QString texts[] = {fixedText(metrics.symDirichlet, 4),       fixedText(metrics.symDirichletP99, 3),
                             fixedText(metrics.symDirichletMax, 3),    fixedText(metrics.l2Stretch, 4),
                             fixedText(metrics.angleDistortion, 4),    fixedText(metrics.areaDistortion, 4),
                             fixedText(metrics.texelDensitySpread, 3), count(metrics.facesWithoutUv),
                             count(metrics.symDirichletInfinite),      count(metrics.mirroredCharts)};
    for (std::size_t i = 0; i < mFigures.size(); ++i) {
        mFigures[i]->setText(texts[i]);
        mFigures[i]->setEnabled(map.figuresAreFresh());
    }
    for (const auto &[row, finding] : mapFindings)
        mFigures[row]->setText(linked(texts[row]));
}

} // namespace autocuts
