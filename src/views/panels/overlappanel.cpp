#include "views/panels/overlappanel.h"

#include "views/actions/actionregistry.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/panels/overlapmodel.h"
#include "views/ui/numbertext.h"
#include "views/ui/reasons.h"

#include <QGridLayout>
#include <QLabel>
#include <QListView>
#include <QPushButton>

#include <algorithm>
#include <set>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! One row per pair of faces. Polygons may overlap by several of their triangles.
std::vector<OverlapRow> overlapRows(const Document &document, const std::vector<std::array<int, 2>> &pairs)
{
    const auto faceOf = [&](int triangle) { return document.mesh().triangleFace[triangle]; };
    std::vector<OverlapRow> rows;
    std::set<std::array<int, 2>> known;
    for (const auto &[first, second] : pairs) {
        const auto [low, high] = std::minmax({faceOf(first), faceOf(second)});
        if (known.insert({low, high}).second)
            rows.push_back(
                {{low, high}, {document.islands().islandOfFace(low), document.islands().islandOfFace(high)}});
    }
    return rows;
}

} // namespace

OverlapPanel::OverlapPanel(const StudioContext &context, QWidget *parent)
    : Panel(context, tr("Open a model to look for overlaps in its map."), parent),
      mList(new OverlapModel(this)), mView(new QListView), mState(makeRemark())
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing + 2);
    mState->setObjectName("state"_L1);
    layout->addWidget(mState);
    layout->addWidget(makeFigures());
    mView->setObjectName("overlaps"_L1);
    mView->setAccessibleName(tr("Overlaps"));
    mView->setModel(mList);
    mView->setUniformItemSizes(true);
    mView->setSpacing(1);
    mView->setAlternatingRowColors(true);
    mView->setMinimumHeight(100);
    mView->setToolTip(tr("Overlapping faces, the largest overlap first; choosing a row selects them"));
    layout->addWidget(mView, 1);
    layout->addWidget(makeButtons());
    connect(mView->selectionModel(), &QItemSelectionModel::currentChanged, this, &OverlapPanel::showOverlap);
    connect(mView, &QListView::activated, this, &OverlapPanel::showOverlap);
    const auto refreshAll = [this] {
        mListStale = true;
        refreshSoon();
    };
    connect(&context.map, &MapController::figuresChanged, this, refreshAll);
    connect(&context.workspace, &Workspace::documentReplaced, this, refreshAll);
    connect(&context.map.jobs(), &JobRunner::busyChanged, this, [this] { refreshSoon(); });
}

QWidget *OverlapPanel::makeFigures()
{
    auto *box = new QWidget;
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    mPairs = addFigure(grid, 0, 0, tr("Overlapping pairs"), tr("Pairs of triangles that overlap in the map"));
    mTriangles =
        addFigure(grid, 1, 0, tr("Overlapping triangles"), tr("Triangles that overlap at least one other"));
    mArea = addFigure(grid, 2, 0, tr("Overlapping area"),
                      tr("Area of all overlaps, as a share of the map's area"));
    mStacked = addFigure(grid, 3, 0, tr("Stacked pairs"),
                         tr("Pairs of triangles of islands that are stacked: they overlap on purpose and are "
                            "not counted above"));
    mFlipped =
        addFigure(grid, 4, 0, tr("Flipped triangles"), tr("Triangles that lie face down in their island"));
    mPairs->setObjectName("pairs"_L1);
    mTriangles->setObjectName("triangles"_L1);
    mStacked->setObjectName("stacked"_L1);
    mFlipped->setObjectName("flipped"_L1);
    grid->setColumnStretch(1, 1);
    return box;
}

QWidget *OverlapPanel::makeButtons()
{
    mPrevious = makeButton(tr("Previous"), "previous"_L1);
    mNext = makeButton(tr("Next"), "next"_L1);
    mSelectFlipped = makeButton(tr("Select flipped"), "selectFlipped"_L1);
    mSeparate = makeButton(tr("Separate all"), "separate"_L1);
    explain(mPrevious, tr("Select the overlap before, and show it"), {"select.previousOverlap"});
    explain(mNext, tr("Select the next overlap, and show it"), {"select.nextOverlap"});
    explain(mSelectFlipped, tr("Select the faces of flipped triangles, and show them"), {"select.flipped"});
    explain(mSeparate, tr("Cut islands that cover themselves, and pack"), {"uv.separate"});
    connect(mPrevious, &QPushButton::clicked, this, [this] { step(-1); });
    connect(mNext, &QPushButton::clicked, this, [this] { step(1); });
    connect(context().actions.action("select.previousOverlap"), &QAction::triggered, this,
            [this] { step(-1); });
    connect(context().actions.action("select.nextOverlap"), &QAction::triggered, this, [this] { step(1); });
    connect(mSelectFlipped, &QPushButton::clicked, this, &OverlapPanel::selectFlipped);
    connect(mSeparate, &QPushButton::clicked, &context().map, &MapController::separateOverlaps);
    mGreedy = makeButton(tr("Greedily"), "separateGreedy"_L1);
    explain(mGreedy, tr("The same by regions that grow breadth first: more cuts, found at once"),
            {"uv.separateGreedy"});
    connect(mGreedy, &QPushButton::clicked, &context().map, &MapController::separateGreedily);
    auto *box = new QWidget;
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(rowSpacing);
    layout->addWidget(makeRow({mPrevious, mNext}));
    layout->addWidget(makeRow({mSelectFlipped, mSeparate, mGreedy}));
    return box;
}

void OverlapPanel::refresh()
{
    const MapController &map = context().map;
    const MapFigures *figures = document() ? map.figures() : nullptr;
    const bool hasMap = figures && figures->metrics.charts > 0;
    const bool fresh = hasMap && map.figuresAreFresh();
    const metrics::UvMetrics none;
    const metrics::UvMetrics &metrics = hasMap ? figures->metrics : none;
    mPairs->setText(countText(metrics.overlapPairs));
    mTriangles->setText(hasMap ? countText(std::ssize(figures->overlapping)) : missingText());
    mArea->setText(percentText(metrics.overlapAreaRatio));
    mStacked->setText(countText(metrics.stackedPairs));
    mFlipped->setText(hasMap ? countText(metrics.flipped) : missingText());
    for (QLabel *label : {mPairs, mTriangles, mArea, mStacked, mFlipped})
        label->setEnabled(fresh);
    if (!hasMap)
        mState->setText(tr("No map yet: run the solver, or unwrap."));
    else if (!fresh)
        mState->setText(tr("The map has changed; measuring it…"));
    else if (metrics.overlapPairs == 0 && metrics.flipped == 0)
        mState->setText(tr("No overlaps and no flips."));
    else
        mState->setText(tr("Choose an overlap to see where it is."));

    if (mListStale) {
        mListStale = false;
        mList->setRows(fresh ? overlapRows(*document(), figures->overlapPairs) : std::vector<OverlapRow>());
    }
    const bool hasRows = mList->rowCount() > 0;
    mPrevious->setEnabled(hasRows);
    mNext->setEnabled(hasRows);
    enableOrSay(mSelectFlipped, fresh && metrics.flipped > 0, tr("No face is known to be flipped"));
    for (QPushButton *button : {mSeparate, mGreedy})
        button->setEnabled(hasMap && !context().map.jobs().isBusy());
}

void OverlapPanel::step(int offset)
{
    const int count = mList->rowCount();
    if (count == 0)
        return;
    const QModelIndex current = mView->currentIndex();
    const int row = current.isValid() ? (current.row() + offset + count) % count : offset > 0 ? 0 : count - 1;
    mView->setCurrentIndex(mList->index(row));
}

void OverlapPanel::showOverlap(const QModelIndex &index)
{
    if (!index.isValid())
        return;
    const OverlapRow &row = mList->row(index.row());
    selectFaces({row.faces[0], row.faces[1]});
}

void OverlapPanel::selectFlipped()
{
    const MapFigures *figures = context().map.figuresAreFresh() ? context().map.figures() : nullptr;
    if (!document() || !figures)
        return;
    QList<int> faces;
    const MeshData &mesh = document()->mesh();
    for (int t = 0; t < mesh.triangleCount(); ++t) {
        if (figures->metrics.triangleFlipped[t])
            faces.append(mesh.triangleFace[t]);
    }
    selectFaces(std::move(faces));
}

void OverlapPanel::selectFaces(QList<int> faces)
{
    if (!document())
        return;
    Selection selection = document()->selection();
    selection.mode = SelectionMode::Faces;
    selection.faces = std::move(faces);
    document()->setSelection(std::move(selection));
    Q_EMIT frameSelectionRequested();
}

} // namespace autocuts
