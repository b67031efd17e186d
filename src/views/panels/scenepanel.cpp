#include "views/panels/scenepanel.h"

#include "commands/hidefaces.h"
#include "views/actions/actionregistry.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/selecting/selecting.h"
#include "views/ui/icons.h"
#include "views/ui/numbertext.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"

#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTabBar>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The figures are updated when the map has not changed for this time.
constexpr int settleDelay = 120; //!< milliseconds

//! Names of a model often differ in their ends only.
class NameDelegate final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->textElideMode = Qt::ElideMiddle;
    }
};

//! Per face: all of it is selected, as a face or by all of its edges or corners.
std::vector<bool> selectedFaces(const Document &document)
{
    const MeshData &mesh = document.mesh();
    const Selection &selection = document.selection();
    std::vector<bool> selected(static_cast<std::size_t>(mesh.faceCount()), false);
    for (int face : selection.faces)
        selected[static_cast<std::size_t>(face)] = true;
    if (selection.edges.isEmpty() && selection.corners.isEmpty())
        return selected;
    const MeshAdjacency &adjacency = document.adjacency();
    std::vector<int> corners(selected.size(), 0), edges(selected.size(), 0);
    for (int corner : selection.corners)
        ++corners[static_cast<std::size_t>(adjacency.faceOfCorner(corner))];
    for (int edge : selection.edges) {
        for (int face : adjacency.edgeFaces(edge)) {
            if (face >= 0)
                ++edges[static_cast<std::size_t>(face)];
        }
    }
    for (std::size_t f = 0; f < selected.size(); ++f) {
        const int sides = mesh.faceStart[f + 1] - mesh.faceStart[f];
        selected[f] = selected[f] || corners[f] == sides || edges[f] == sides;
    }
    return selected;
}

} // namespace

ScenePanel::ScenePanel(const StudioContext &context, Questions &questions, QWidget *parent)
    : Panel(context, tr("Open a model to see its objects and materials."), parent), mQuestions(questions),
      mTable(new SceneTable(this)), mSorted(new QSortFilterProxyModel(this)), mTabs(new QTabBar),
      mFilter(new QLineEdit), mView(new QTableView), mSummary(makeRemark())
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing + 2);
    makeTabs();
    layout->addWidget(mTabs);
    layout->addWidget(mFilter);
    makeTable();
    layout->addWidget(mView, 1);
    mSummary->setObjectName("summary"_L1);
    layout->addWidget(mSummary);
    layout->addWidget(makeButtons());

    connect(&context.workspace, &Workspace::documentReplaced, this, &ScenePanel::refreshRows);
    connect(&context.workspace, &Workspace::changed, this, &ScenePanel::documentChanged);
    connect(&context.workspace, &Workspace::selectionChanged, this, [this] { refreshSoon(); });
    connect(&context.map, &MapController::figuresChanged, this, [this] { refreshFigures(settleDelay); });
    connect(mView->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            qOverload<>(&ScenePanel::selectFaces));
    connect(mView, &QWidget::customContextMenuRequested, this, [this](const QPoint &place) {
        QMenu menu;
        menu.setObjectName("sceneMenu"_L1);
        fillMenu(menu);
        menu.exec(mView->viewport()->mapToGlobal(place));
    });
}

SceneKind ScenePanel::kind() const
{
    return mTabs->currentIndex() == 1 ? SceneKind::Materials : SceneKind::Objects;
}

void ScenePanel::makeTabs()
{
    mTabs->setObjectName("kinds"_L1);
    mTabs->addTab(tr("Objects"));
    mTabs->addTab(tr("Materials"));
    mTabs->setTabToolTip(0, tr("Objects or groups of the file"));
    mTabs->setTabToolTip(1, tr("Materials of the file"));
    mTabs->setExpanding(true);
    connect(mTabs, &QTabBar::currentChanged, this, &ScenePanel::refreshRows);
    mFilter->setObjectName("filter"_L1);
    mFilter->setPlaceholderText(tr("Filter by name"));
    mFilter->setAccessibleName(tr("Filter by name"));
    mFilter->setClearButtonEnabled(true);
    connect(mFilter, &QLineEdit::textChanged, this, [this](const QString &text) {
        const QScopedValueRollback syncing(mSyncing, true);
        mSorted->setFilterFixedString(text);
        refreshSoon();
    });
}

void ScenePanel::makeTable()
{
    mSorted->setSourceModel(mTable);
    mSorted->setSortRole(SceneTable::sortRole);
    mSorted->setSortCaseSensitivity(Qt::CaseInsensitive);
    mSorted->setFilterKeyColumn(SceneTable::Name);
    mSorted->setFilterCaseSensitivity(Qt::CaseInsensitive);
    mView->setObjectName("scene"_L1);
    mView->setAccessibleName(tr("Objects and materials"));
    mView->setModel(mSorted);
    mView->setSelectionBehavior(QAbstractItemView::SelectRows);
    mView->setSelectionMode(QAbstractItemView::ExtendedSelection);
    mView->setContextMenuPolicy(Qt::CustomContextMenu);
    mView->setTabKeyNavigation(false);
    mView->setWordWrap(false);
    mView->setShowGrid(false);
    mView->setAlternatingRowColors(true);
    mView->setMinimumHeight(140);
    mView->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    mView->verticalHeader()->hide();
    mView->verticalHeader()->setDefaultSectionSize(mView->fontMetrics().height() + 6);
    mView->viewport()->installEventFilter(this);
    QHeaderView *header = mView->horizontalHeader();
    header->setHighlightSections(false);
    header->setMinimumSectionSize(20);
    const std::array<QLatin1StringView, SceneTable::ColumnCount> widest{
        "MM"_L1, "MMMMMMM"_L1, "000000"_L1, "Islands_"_L1, "00.000"_L1, "px/unit_"_L1, "00.0 %"_L1};
    for (int column = 0; column < SceneTable::ColumnCount; ++column)
        header->resizeSection(column, mView->fontMetrics().horizontalAdvance(widest[column]) + 8);
    mView->setItemDelegateForColumn(SceneTable::Name, new NameDelegate(mView));
    connect(header, &QHeaderView::sectionResized, this, [this](int column) {
        if (column == SceneTable::Name && !mFitting)
            mFitsNames = false;
    });
    // Sorted by the file's order until a header is clicked.
    header->setSortIndicator(-1, Qt::AscendingOrder);
    mView->setSortingEnabled(true);
    mSorted->sort(-1);
}

//! As wide as the names are, as far as half of the list is left for the figures, or as much as they need.
void ScenePanel::fitNames()
{
    if (!mFitsNames || mSorted->rowCount() == 0)
        return;
    const QScopedValueRollback fitting(mFitting, true);
    QHeaderView *header = mView->horizontalHeader();
    const int space = mView->viewport()->width();
    const int figures = header->length() - header->sectionSize(SceneTable::Name);
    const int most = std::max(space / 2, space - figures);
    const int names = static_cast<const QAbstractItemView *>(mView)->sizeHintForColumn(SceneTable::Name);
    header->resizeSection(SceneTable::Name,
                          std::max(header->sectionSizeHint(SceneTable::Name), std::min(names, most)));
}

QWidget *ScenePanel::makeButtons()
{
    QPushButton *isolated = makeButton(tr("Isolate"), "isolate"_L1);
    QPushButton *all = makeButton(tr("Show all"), "showAll"_L1);
    QPushButton *jobs = makeButton(tr("Jobs"), "jobs"_L1);
    explain(isolated, tr("Show the selected rows alone"), {"view.hideOthers"});
    explain(all, tr("Show everything that is hidden"), {"view.showAll"});
    jobs->setToolTip(tr("Unwrap, pack or export the selected rows; also by a right click on the list"));
    auto *menu = new QMenu(jobs);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        fillMenu(*menu);
    });
    jobs->setMenu(menu);
    connect(isolated, &QPushButton::clicked, this, [this] { isolate(facesOf(selectedRows())); });
    connect(all, &QPushButton::clicked, context().actions.action("view.showAll"), &QAction::trigger);
    return makeRow({isolated, all, jobs});
}

void ScenePanel::documentChanged(const ChangeEvent &event)
{
    switch (event.type) {
    case ChangeEvent::Type::Uv:
    case ChangeEvent::Type::UvSet:
        refreshFigures(settleDelay);
        break;
    case ChangeEvent::Type::PackingSettings:
        refreshFigures(0);
        break;
    case ChangeEvent::Type::Hidden:
        mHiddenStale = true;
        refreshSoon();
        break;
    default:
        break;
    }
}

void ScenePanel::refreshRows()
{
    mRowsStale = true;
    refreshFigures(0);
}

void ScenePanel::refreshFigures(int delayMs)
{
    mFiguresStale = true;
    refreshSoon(delayMs);
}

void ScenePanel::refresh()
{
    const QScopedValueRollback syncing(mSyncing, true);
    if (!document()) {
        mTable->setFigures(kind(), {});
        mRowsStale = mFiguresStale = true;
        mSummary->clear();
        return;
    }
    if (mFiguresStale) {
        static const std::vector<double> unknown;
        const MapController &map = context().map;
        mTable->setFigures(kind(),
                           sceneFigures(*document(), kind(),
                                        map.figuresAreFresh() ? map.figures()->islandDistortion : unknown));
    } else if (mHiddenStale) {
        std::vector<SceneFigures> figures = mTable->figures();
        countHidden(*document(), figures);
        mTable->setFigures(kind(), std::move(figures));
    }
    if (std::exchange(mRowsStale, false))
        fitNames();
    mFiguresStale = mHiddenStale = false;
    selectRows(*document());
    showSummary();
}

void ScenePanel::showSummary()
{
    const int rows = mTable->rowCount();
    const bool objects = kind() == SceneKind::Objects;
    if (!objects && document()->state().scene.materialNames.empty()) {
        mSummary->setText(tr("The file names no materials."));
        return;
    }
    if (mSorted->rowCount() == 0) {
        mSummary->setText(objects ? tr("No object has such a name.") : tr("No material has such a name."));
        return;
    }
    const auto hidden = std::count_if(mTable->figures().begin(), mTable->figures().end(),
                                      [](const SceneFigures &row) { return row.isHidden(); });
    mSummary->setText((objects ? tr("Objects: %1, selected: %2, hidden: %3")
                               : tr("Materials: %1, selected: %2, hidden: %3"))
                          .arg(countText(rows), countText(qint64(selectedRows().size())), countText(hidden)));
}

std::vector<int> ScenePanel::selectedRows() const
{
    std::vector<int> rows;
    for (const QModelIndex &index : mView->selectionModel()->selectedRows())
        rows.push_back(mSorted->mapToSource(index).row());
    std::sort(rows.begin(), rows.end());
    return rows;
}

//! Selects the rows of which all shown faces are selected.
void ScenePanel::selectRows(const Document &document)
{
    const std::vector<bool> selected = selectedFaces(document);
    const std::vector<bool> &hidden = document.hidden();
    const auto isWanted = [&](int row) {
        const int source = mSorted->mapToSource(mSorted->index(row, 0)).row();
        const SceneFigures &own = mTable->figures()[static_cast<std::size_t>(source)];
        return !own.isHidden() && std::all_of(own.group.faces.begin(), own.group.faces.end(), [&](int face) {
            const auto f = static_cast<std::size_t>(face);
            return selected[f] || (!hidden.empty() && hidden[f]);
        });
    };
    selectRowsOf(*mView, isWanted);
}

QList<int> ScenePanel::facesOf(const std::vector<int> &rows) const
{
    QList<int> faces;
    for (int row : rows)
        faces += mTable->figures()[static_cast<std::size_t>(row)].group.faces;
    std::sort(faces.begin(), faces.end());
    return faces;
}

void ScenePanel::selectFaces()
{
    if (!mSyncing && !mRowsStale && document())
        selectFaces(document()->selection().mode);
}

void ScenePanel::selectFaces(SelectionMode mode)
{
    document()->setSelection(selectionOf(*document(), facesOf(selectedRows()), mode));
}

void ScenePanel::hide(const QList<int> &faces, bool hide)
{
    if (document() && !mRowsStale)
        pushCommand(HideFaces::change(*document(), faces, hide));
}

//! Shows these faces alone.
void ScenePanel::isolate(const QList<int> &faces)
{
    if (!document() || mRowsStale || faces.isEmpty())
        return;
    QList<int> others;
    for (int face = 0; face < document()->mesh().faceCount(); ++face) {
        if (!std::binary_search(faces.begin(), faces.end(), face))
            others.append(face);
    }
    pushCommand(std::make_unique<HideFaces>(*document(), others));
}

//! Shows these faces alone, or everything when they are.
void ScenePanel::solo(const QList<int> &faces)
{
    if (!document() || mRowsStale)
        return;
    const QList<int> &hidden = document()->state().hiddenFaces;
    const bool alone = hidden.size() == document()->mesh().faceCount() - faces.size() &&
                       std::none_of(faces.begin(), faces.end(), [&](int face) {
                           return std::binary_search(hidden.begin(), hidden.end(), face);
                       });
    if (alone)
        pushCommand(std::make_unique<HideFaces>(*document(), QList<int>()));
    else
        isolate(faces);
}

//! \param alone the row is to be shown alone \return true when there is an eye at this place
bool ScenePanel::pressEye(const QPoint &place, bool alone)
{
    const QModelIndex index = mView->indexAt(place);
    if (!index.isValid() || index.column() != SceneTable::Eye || mRowsStale || !document())
        return false;
    const SceneFigures own = mTable->figures()[static_cast<std::size_t>(mSorted->mapToSource(index).row())];
    if (alone)
        solo(own.group.faces);
    else
        hide(own.group.faces, !own.isHidden());
    return true;
}

//! A click on an eye does not select its row.
bool ScenePanel::eventFilter(QObject *watched, QEvent *event)
{
    const auto type = event->type();
    if (watched == mView->viewport() && type == QEvent::Resize)
        fitNames();
    if (watched == mView->viewport() &&
        (type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick)) {
        const auto &mouse = static_cast<const QMouseEvent &>(*event);
        if (mouse.button() == Qt::LeftButton &&
            pressEye(mouse.position().toPoint(), mouse.modifiers().testFlag(Qt::AltModifier)))
            return true;
    }
    return Panel::eventFilter(watched, event);
}

void ScenePanel::fillMenu(QMenu &menu)
{
    const QList<int> faces = facesOf(selectedRows());
    const bool any = document() && !faces.isEmpty();
    const auto add = [&](const QString &text, const QString &iconName, auto function) {
        QAction *action = menu.addAction(icon(iconName), text, this, function);
        action->setEnabled(any);
    };
    menu.setToolTipsVisible(true);
    add(tr("Show"), u"show"_s, [this, faces] { hide(faces, false); });
    add(tr("Hide"), u"hide"_s, [this, faces] { hide(faces, true); });
    add(tr("Isolate"), u"isolate"_s, [this, faces] { isolate(faces); });
    menu.addSeparator();
    for (const char *id :
         {"uv.unwrapSelection", "uv.unwrapSelectionFree", "uv.finishSelection", "uv.packSelection",
          kind() == SceneKind::Objects ? "uv.packObjects" : "uv.packMaterials"})
        addJob(menu, id);
    menu.addSeparator();
    addJob(menu, "file.exportLayout");
    QAction *save = menu.addAction(icon(u"save"_s), tr("Save figures..."), this, &ScenePanel::saveFigures);
    save->setToolTip(tr("Write the figures of the selected rows, or of all, as a table (CSV)"));
    save->setEnabled(document());
    addJob(menu, "view.frameSelected");
}

//! An action that works on the faces of the selected rows.
void ScenePanel::addJob(QMenu &menu, const char *id)
{
    QAction *action = context().actions.action(id);
    QAction *job = menu.addAction(action->icon(), action->text(), this, [this, action] {
        if (!document() || mRowsStale)
            return;
        selectFaces(document()->selection().mode == SelectionMode::Islands ? SelectionMode::Islands
                                                                           : SelectionMode::Faces);
        action->trigger();
    });
    job->setToolTip(action->toolTip());
    job->setEnabled(action->isEnabled());
}

void ScenePanel::saveFigures()
{
    const QString folder = context().preferences.lastFolder();
    const QString path = mQuestions.fileToSave(tr("Save figures"), QDir(folder).filePath(u"figures.csv"_s),
                                               {tr("Table (*.csv)"), tr("All files (*)")});
    if (!path.isEmpty())
        context().files.exportBytes(path, mTable->csv(selectedRows()));
}

} // namespace autocuts
