#include "views/panels/islandpanel.h"

#include "views/actions/actionregistry.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/panels/islandtable.h"
#include "views/ui/numbertext.h"
#include "views/ui/reasons.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSortFilterProxyModel>
#include <QTableView>

#include <array>
#include <cmath>
#include <utility>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The table is updated when islands have not changed for this time.
constexpr int settleDelay = 120; //!< milliseconds

} // namespace

IslandPanel::IslandPanel(const StudioContext &context, QWidget *parent)
    : Panel(context, tr("Open a model to see the islands of its map."), parent),
      mTable(new IslandTable(this)), mSorted(new QSortFilterProxyModel(this)), mView(new QTableView),
      mSummary(makeRemark())
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing + 2);
    mSummary->setObjectName("summary"_L1);
    layout->addWidget(mSummary);
    makeTable();
    layout->addWidget(mView, 1);
    layout->addWidget(makeMarkButtons());
    layout->addWidget(makeHeading(tr("Texel density")));
    layout->addWidget(makeDensityRow());

    connect(&context.workspace, &Workspace::documentReplaced, this, [this] { refreshFigures(0); });
    connect(&context.workspace, &Workspace::changed, this, &IslandPanel::documentChanged);
    connect(&context.workspace, &Workspace::selectionChanged, this, [this] { refreshSoon(); });
    connect(&context.map, &MapController::figuresChanged, this, [this] { refreshFigures(settleDelay); });
    connect(&context.map.jobs(), &JobRunner::busyChanged, this, [this] { refreshSoon(); });
    connect(&context.solver, &SolverController::stateChanged, this, [this] { refreshSoon(); });
    connect(&context.shownMap, &ShownMap::changed, this, [this, wasLive = false]() mutable {
        const bool isLive = this->context().shownMap.isLive();
        if (std::exchange(wasLive, isLive) != isLive)
            refreshSoon();
    });
    // A right click offers what can be done with the selected islands.
    mView->setContextMenuPolicy(Qt::ActionsContextMenu);
    for (const char *id : {"uv.packSelection", "uv.unwrapSelection", "uv.orientBox", "uv.lock", "uv.unlock",
                           "uv.keepOrientation", "uv.freeOrientation", "uv.group", "uv.ungroup", "uv.stack",
                           "uv.unstack", "select.similar", "view.frameSelected"})
        mView->addAction(context.actions.action(id));
    connect(mView->selectionModel(), &QItemSelectionModel::selectionChanged, this, &IslandPanel::selectFaces);
    connect(mTable, &IslandTable::lockRequested, this, [this](int island, bool locked) {
        mark(locked ? SetIslandFlags::Edit::Lock : SetIslandFlags::Edit::Unlock, {island});
    });
}

void IslandPanel::makeTable()
{
    mSorted->setSourceModel(mTable);
    mSorted->setSortRole(IslandTable::sortRole);
    mView->setObjectName("islands"_L1);
    mView->setAccessibleName(tr("Islands"));
    mView->setModel(mSorted);
    mView->setSortingEnabled(true);
    mView->sortByColumn(IslandTable::Number, Qt::AscendingOrder);
    mView->setSelectionBehavior(QAbstractItemView::SelectRows);
    mView->setSelectionMode(QAbstractItemView::ExtendedSelection);
    mView->setTabKeyNavigation(false);
    mView->setWordWrap(false);
    mView->setShowGrid(false);
    mView->setAlternatingRowColors(true);
    mView->setMinimumHeight(140);
    mView->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    mView->verticalHeader()->hide();
    mView->verticalHeader()->setDefaultSectionSize(mView->fontMetrics().height() + 6);
    QHeaderView *header = mView->horizontalHeader();
    header->setHighlightSections(false);
    header->setMinimumSectionSize(20);
    header->setStretchLastSection(true);
    const std::array<QLatin1StringView, IslandTable::ColumnCount> widest{
        "MM000000"_L1, "MM"_L1,     "00000"_L1, "000.0 %_"_L1, "0000.0_"_L1,
        "0000.0_"_L1,  "00.000"_L1, "000_"_L1,  "000_"_L1};
    for (int column = 0; column < IslandTable::ColumnCount; ++column) {
        const QString title = mTable->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int titleWidth = title.isEmpty() ? 0 : header->fontMetrics().horizontalAdvance(title + u"__"_s);
        const int textWidth = mView->fontMetrics().horizontalAdvance(widest[column]);
        header->resizeSection(column, std::max(titleWidth, textWidth) + 4);
    }
    hideEmptyColumns();
}

void IslandPanel::hideEmptyColumns()
{
    for (const int column : {IslandTable::Shown, IslandTable::Stack, IslandTable::Group})
        mView->setColumnHidden(column, !mTable->hasTexts(column));
}

QWidget *IslandPanel::makeMarkButtons()
{
    using Edit = SetIslandFlags::Edit;
    const auto add = [this](const QString &text, QLatin1StringView name, const QString &tip,
                            const char *action, Edit edit) {
        QPushButton *button = makeButton(text, name);
        explain(button, tip, {action});
        connect(button, &QPushButton::clicked, this, [this, edit] { mark(edit, selectedIslands()); });
        mSelectionButtons.push_back(button);
        return button;
    };
    QPushButton *stack = makeButton(tr("Stack identical"), "stack"_L1);
    explain(stack,
            tr("Lay those of the selected islands that are alike on top of each other; one alone finds all "
               "its copies"),
            {"uv.stackCopies"});
    connect(stack, &QPushButton::clicked, context().actions.action("uv.stackCopies"), &QAction::trigger);
    mSelectionButtons.push_back(stack);
    auto *box = new QWidget;
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(rowSpacing);
    layout->addWidget(makeRow(
        {add(tr("Lock"), "lock"_L1, tr("Keep the selected islands where they are"), "uv.lock", Edit::Lock),
         stack,
         add(tr("Group"), "group"_L1, tr("The selected islands move together"), "uv.group", Edit::Group)}));
    layout->addWidget(makeRow(
        {add(tr("Unlock"), "unlock"_L1, tr("Let the selected islands move"), "uv.unlock", Edit::Unlock),
         add(tr("Unstack"), "unstack"_L1, tr("Take the selected islands out of their stacks"), "uv.unstack",
             Edit::Unstack),
         add(tr("Ungroup"), "ungroup"_L1, tr("Take the selected islands out of their groups"), "uv.ungroup",
             Edit::Ungroup)}));
    return box;
}

QWidget *IslandPanel::makeDensityRow()
{
    mDensity = new QDoubleSpinBox;
    mDensity->setObjectName("density"_L1);
    mDensity->setRange(1e-3, 1e9);
    mDensity->setDecimals(3);
    mDensity->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    mDensity->setSuffix(tr(" px/unit"));
    mDensity->setValue(512);
    QPushButton *read = makeButton(tr("Read"), "readDensity"_L1);
    QPushButton *set = makeButton(tr("Set"), "setDensity"_L1);
    mEqualize = makeButton(tr("Equalise all"), "equalize"_L1);
    read->setToolTip(tr("Take over the mean texel density of the selected islands"));
    set->setToolTip(
        tr("Scale the selected islands to this texel density; locked ones stay. Painted faces get theirs: "
           "the density is that of faces with a weight of 1"));
    explain(mEqualize, tr("Give all islands the same texel density; locked ones stay"), {"uv.density"});
    mSelectionButtons.insert(mSelectionButtons.end(), {read, set});
    connect(read, &QPushButton::clicked, this, &IslandPanel::readDensity);
    connect(set, &QPushButton::clicked, this, &IslandPanel::setDensity);
    connect(mEqualize, &QPushButton::clicked, &context().map, &MapController::equalizeDensity);
    auto *box = new QWidget;
    auto *form = makeForm(box);
    addRow(form, tr("Density"), mDensity,
           tr("Texels per unit of the model at the texture size of the Packing panel"));
    form->addRow(makeRow({read, set, mEqualize}));
    return box;
}

void IslandPanel::documentChanged(const ChangeEvent &event)
{
    switch (event.type) {
    case ChangeEvent::Type::Uv:
    case ChangeEvent::Type::UvSet:
    case ChangeEvent::Type::TexelWeight:
        refreshFigures(settleDelay);
        break;
    case ChangeEvent::Type::IslandFlag:
    case ChangeEvent::Type::Tag:
    case ChangeEvent::Type::PackingSettings:
        refreshFigures(0);
        break;
    default:
        break;
    }
}

void IslandPanel::refreshFigures(int delayMs)
{
    mFiguresStale = true;
    refreshSoon(delayMs);
}

std::vector<int> IslandPanel::selectedIslands() const
{
    return document() ? document()->islands().islandsOf(document()->selection().faces) : std::vector<int>();
}

void IslandPanel::refresh()
{
    const QScopedValueRollback syncing(mSyncing, true);
    if (!document()) {
        mTable->setFigures({});
        mFiguresStale = true;
        mSummary->hide();
        return;
    }
    MapController &map = context().map;
    if (mFiguresStale) {
        static const std::vector<double> unknown;
        mTable->setFigures(
            islandFigures(*document(), map.figuresAreFresh() ? map.figures()->islandDistortion : unknown));
        hideEmptyColumns();
        mFiguresStale = false;
    }
    selectRows(*document());
    const auto selected = selectedIslands().size();
    mSummary->show();
    const bool solves = context().solver.isRunning() || context().solver.isPausing();
    mSummary->setText(
        mTable->rowCount() == 0 ? (solves                ? tr("Pause the solver to list its islands.")
                                   : map.jobs().isBusy() ? tr("The islands are listed when the map is ready.")
                                                         : tr("No UVs yet: run the solver, or unwrap."))
        : context().shownMap.isLive()
            ? tr("Islands of the map before: %1, selected: %2. The list follows once the new map is there.")
                  .arg(countText(mTable->rowCount()), countText(qint64(selected)))
            : tr("Islands: %1, selected: %2")
                  .arg(countText(mTable->rowCount()), countText(qint64(selected))));
    for (QPushButton *button : mSelectionButtons)
        enableOrSay(button, selected > 0, tr("Select faces or islands first"));
    mEqualize->setEnabled(mTable->rowCount() > 0 && !map.jobs().isBusy());
}

//! Selects the rows of islands with selected faces.
void IslandPanel::selectRows(const Document &document)
{
    std::vector<bool> wanted(mTable->rowCount());
    for (int island : document.islands().islandsOf(document.selection().faces))
        wanted[island] = true;
    const auto isWanted = [&](int row) { return wanted[mSorted->mapToSource(mSorted->index(row, 0)).row()]; };
    selectRowsOf(*mView, isWanted);
}

//! Selects the faces of the islands in the selected rows.
void IslandPanel::selectFaces()
{
    if (mSyncing || mFiguresStale || !document())
        return;
    Selection selection = document()->selection();
    selection.mode = SelectionMode::Islands;
    selection.faces.clear();
    for (const QItemSelectionRange &range : mView->selectionModel()->selection()) {
        for (int row = range.top(); row <= range.bottom(); ++row) {
            const int island = mSorted->mapToSource(mSorted->index(row, 0)).row();
            for (int face : document()->islands().faces(island))
                selection.faces.append(face);
        }
    }
    document()->setSelection(std::move(selection));
}

void IslandPanel::mark(SetIslandFlags::Edit edit, const std::vector<int> &islands)
{
    if (!document())
        return;
    const auto exists = [this](int island) { return island < document()->islands().count(); };
    if (std::all_of(islands.begin(), islands.end(), exists) &&
        !pushCommand(std::make_unique<SetIslandFlags>(*document(), edit, islands)))
        Q_EMIT context().map.done(tr("Nothing to do: the selected islands are so already"));
}

void IslandPanel::readDensity()
{
    if (!document())
        return;
    const double density = meanTexelDensity(*document(), selectedIslands());
    if (std::isfinite(density))
        mDensity->setValue(density);
}

void IslandPanel::setDensity()
{
    mDensity->interpretText();
    if (document())
        pushCommand(setTexelDensity(*document(), selectedIslands(), mDensity->value()));
}

} // namespace autocuts
