#include "views/panels/seampanel.h"

#include "commands/keepstraight.h"
#include "commands/reset.h"
#include "commands/setseamweights.h"
#include "model/document/givenseams.h"
#include "model/document/makesnapshot.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/panels/givenseamform.h"
#include "views/panels/seamcounts.h"
#include "views/panels/seampricelist.h"
#include "views/panels/sliderspin.h"
#include "views/ui/numbertext.h"
#include "views/ui/reasons.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Seams of the map are not counted while it is dragged, but so long after the last change.
constexpr int countDelayMs = 200;

} // namespace

SeamPanel::SeamPanel(const StudioContext &context, QWidget *parent)
    : Panel(context, tr("Open a model to decide about its seams."), parent)
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing + 2);
    layout->addWidget(makeHeading(tr("Selected edges")));
    layout->addWidget(makeSteering());
    layout->addWidget(makeHeading(tr("Paint selected faces")));
    layout->addWidget(makePainting());
    layout->addWidget(makeHeading(tr("Seams")));
    mGiven = new GivenSeamForm;
    connect(mGiven, &GivenSeamForm::edited, this,
            [this](const std::function<void(SolveSettings &)> &edit) { changeSolveSettings(edit); });
    layout->addWidget(mGiven);
    layout->addWidget(makeFigures());
    layout->addWidget(makeHeading(tr("What seams are worth")));
    mPrices = new SeamPriceList;
    MapController &map = context.map;
    connect(mPrices, &SeamPriceList::pricesWanted, &map, &MapController::priceSeams);
    connect(mPrices, &SeamPriceList::picked, this, [this](const std::vector<int> &edges) {
        if (!document())
            return;
        Selection selection;
        selection.mode = SelectionMode::Edges;
        selection.edges = QList<int>(edges.begin(), edges.end());
        selection.normalize(document()->mesh());
        document()->setSelection(selection);
    });
    connect(mPrices, &SeamPriceList::dropped, this,
            [this](const std::vector<int> &edges) { setSeams(SetSeamState::Edit::Join, edges); });
    connect(mPrices, &SeamPriceList::added, this,
            [this](const std::vector<int> &edges) { setSeams(SetSeamState::Edit::Cut, edges); });
    connect(&map, &MapController::pricesChanged, this, &SeamPanel::showPrices);
    connect(&map.jobs(), &JobRunner::busyChanged, this, &SeamPanel::showPrices);
    layout->addWidget(mPrices);
    layout->addStretch();
    connect(&context.workspace, &Workspace::selectionChanged, this, [this] { refreshSoon(); });
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::Seam || event.type == ChangeEvent::Type::SolveSettings)
            refreshSoon();
        else if (changesGivenSeams(event))
            refreshSoon(countDelayMs);
    });
    connect(&context.map, &MapController::figuresChanged, this, [this] { refreshSoon(); });
}

QWidget *SeamPanel::makeSteering()
{
    mSelectedEdges = makeRemark();
    mSelectedEdges->setObjectName("selectedEdges"_L1);
    mCut = makeButton(tr("Cut"), "cut"_L1);
    mJoin = makeButton(tr("Join"), "join"_L1);
    mClear = makeButton(tr("Free"), "clear"_L1);
    mClearAll = makeButton(tr("Free all edges"), "clearAll"_L1);
    explain(mCut, tr("Force a cut along the selected edges"), {"uv.cut"});
    explain(mJoin, tr("Force the selected edges together"), {"uv.join"});
    explain(mClear, tr("Leave the selected edges to the solver"), {"uv.clearSteering"});
    mClearAll->setToolTip(tr("Leave all edges to the solver: no cut and no join is forced"));
    connect(mCut, &QPushButton::clicked, this, [this] { steer(SetSeamState::Edit::Cut); });
    connect(mJoin, &QPushButton::clicked, this, [this] { steer(SetSeamState::Edit::Join); });
    connect(mClear, &QPushButton::clicked, this, [this] { steer(SetSeamState::Edit::Clear); });
    connect(mClearAll, &QPushButton::clicked, this, &SeamPanel::clearSteering);
    mStraight = makeButton(tr("Keep straight"), "straight"_L1);
    mRelease = makeButton(tr("Release"), "release"_L1);
    explain(mStraight, tr("Lay the selected edges on lines of the map"), {"uv.keepStraight"});
    explain(mRelease, tr("The selected edges need not be straight in the map"), {"uv.releaseStraight"});
    connect(mStraight, &QPushButton::clicked, this, [this] { keepStraight(true); });
    connect(mRelease, &QPushButton::clicked, this, [this] { keepStraight(false); });
    auto *box = new QWidget;
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(rowSpacing);
    layout->addWidget(mSelectedEdges);
    layout->addWidget(makeRow({mCut, mJoin, mClear}));
    layout->addWidget(mClearAll);
    layout->addWidget(makeRow({mStraight, mRelease}));
    return box;
}

QWidget *SeamPanel::makePainting()
{
    auto *percent = new QDoubleSpinBox;
    percent->setDecimals(0);
    percent->setSuffix(tr(" %"));
    mStrength = new SliderSpin(SliderScale::linear(1, 100), percent);
    mStrength->setObjectName("strength"_L1);
    mStrength->setValue(50);
    mKeep = makeButton(tr("Keep together"), "keep"_L1);
    mAttract = makeButton(tr("Attract cuts"), "attract"_L1);
    mErase = makeButton(tr("Erase"), "erase"_L1);
    mErasePaint = makeButton(tr("Erase all paint"), "eraseAll"_L1);
    mKeep->setToolTip(tr("Seams avoid the edges of the selected faces"));
    mAttract->setToolTip(tr("Seams are welcome on the edges of the selected faces"));
    mErase->setToolTip(tr("Take the paint off the edges of the selected faces"));
    mErasePaint->setToolTip(tr("Take the paint off the whole model"));
    connect(mKeep, &QPushButton::clicked, this, [this] { paintSelectedFaces(Paint::KeepTogether); });
    connect(mAttract, &QPushButton::clicked, this, [this] { paintSelectedFaces(Paint::AttractCuts); });
    connect(mErase, &QPushButton::clicked, this, [this] { paintSelectedFaces(Paint::Erase); });
    connect(mErasePaint, &QPushButton::clicked, this, &SeamPanel::clearPaint);
    mSelectedFaces = makeRemark();
    mSelectedFaces->setObjectName("selectedFaces"_L1);

    auto *box = new QWidget;
    auto *form = makeForm(box);
    form->addRow(mSelectedFaces);
    addRow(
        form, tr("Strength"), mStrength,
        tr("Of Keep together: a factor of 1 to 100 on the separation energy; of Attract cuts: 1 down to 0"));
    form->addRow(makeRow({mKeep, mAttract}));
    form->addRow(makeRow({mErase, mErasePaint}));
    return box;
}

QWidget *SeamPanel::makeFigures()
{
    auto *box = new QWidget;
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    const auto add = [grid](const QString &caption, QLatin1StringView name, const QString &tip) {
        QLabel *value = addFigure(grid, grid->rowCount(), 0, caption, tip);
        value->setObjectName(name);
        return value;
    };
    mGivenCount = add(tr("Given seams"), "givenCount"_L1,
                      tr("Edges at which you want seams, by the choices above; light blue in both views"));
    mCutCount = add(tr("Forced cuts"), "cutCount"_L1, tr("Edges that are cut because you said so"));
    mHalfCutCount = add(tr("Half-cuts"), "halfCutCount"_L1, tr("Edges that you cut at one end only"));
    mJoinCount =
        add(tr("Forced joins"), "joinCount"_L1, tr("Edges that are held together because you said so"));
    mKeepCount = add(tr("Painted: keep together"), "keepCount"_L1, tr("Edges that seams avoid"));
    mAttractCount = add(tr("Painted: attract cuts"), "attractCount"_L1, tr("Edges where seams are welcome"));
    mStraightCount = add(tr("Kept straight"), "straightCount"_L1,
                         tr("Edges that are to lie on lines of the map; lime in both views"));
    mSeamEdges =
        add(tr("Seam edges of the map"), "seamEdges"_L1, tr("Edges whose two sides have different UVs"));
    mSeamLength = add(tr("Seam length"), "seamLength"_L1, tr("In the units of the model"));
    mSeamNorm = add(tr("Seam length, relative"), "seamNorm"_L1, tr("On the model scaled to area π"));
    grid->setColumnStretch(1, 1);
    return box;
}

void SeamPanel::steer(SetSeamState::Edit edit)
{
    if (!document())
        return;
    const QList<int> &edges = document()->selection().edges;
    setSeams(edit, {edges.begin(), edges.end()});
}

void SeamPanel::keepStraight(bool on)
{
    if (!document())
        return;
    const QList<int> &edges = document()->selection().edges;
    const IndexRanges pairs =
        cornerPairsOfEdges(document()->mesh(), {edges.data(), std::size_t(edges.size())});
    pushCommand(std::make_unique<KeepStraight>(*document(), on, pairs));
}

void SeamPanel::setSeams(SetSeamState::Edit edit, const std::vector<int> &edges)
{
    if (!document())
        return;
    const IndexRanges pairs = cornerPairsOfEdges(document()->mesh(), edges);
    pushCommand(std::make_unique<SetSeamState>(*document(), edit, pairs));
}

void SeamPanel::paintSelectedFaces(Paint paint)
{
    if (!document())
        return;
    const double strength = mStrength->value() / 100;
    const double weight = paint == Paint::KeepTogether  ? keepTogetherWeight(strength)
                          : paint == Paint::AttractCuts ? attractCutsWeight(strength)
                                                        : unpaintedWeight;
    const std::vector<int> edges = edgesOfFaces(*document(), document()->selection().faces);
    const IndexRanges pairs = cornerPairsOfEdges(document()->mesh(), edges);
    const std::vector<double> weights(pairs.count(), weight);
    pushCommand(std::make_unique<SetSeamWeights>(*document(), pairs, weights));
}

void SeamPanel::clearSteering()
{
    if (document())
        pushCommand(std::make_unique<Reset>(*document(), Reset::SeamStates));
}

void SeamPanel::clearPaint()
{
    if (document())
        pushCommand(std::make_unique<Reset>(*document(), Reset::SeamWeights));
}

void SeamPanel::refresh()
{
    showMap();
    showGivenSeams();
    mPrices->setCanPrice(document() && hasUvs(*document()) && !context().map.jobs().isBusy());
    mSelectedEdges->setVisible(document() != nullptr);
    mSelectedFaces->setVisible(document() != nullptr);
    if (!document()) {
        for (QLabel *label :
             {mCutCount, mHalfCutCount, mJoinCount, mKeepCount, mAttractCount, mStraightCount})
            label->setText(missingText());
        return;
    }
    const Selection &selection = document()->selection();
    mSelectedEdges->setText(selection.edges.isEmpty()
                                ? tr("Select edges to steer them.")
                                : tr("Edges selected: %1").arg(countText(selection.edges.size())));
    mSelectedFaces->setText(selection.faces.isEmpty()
                                ? tr("Select faces to paint their edges.")
                                : tr("Faces selected: %1").arg(countText(selection.faces.size())));
    for (QPushButton *button : {mCut, mJoin, mClear, mStraight, mRelease})
        button->setEnabled(!selection.edges.isEmpty());
    for (QPushButton *button : {mKeep, mAttract, mErase})
        enableOrSay(button, !selection.faces.isEmpty(), tr("Select faces or islands first"));
    showCounts(*document());
}

void SeamPanel::showCounts(const Document &document)
{
    const SeamCounts counts = countSeams(document.mesh(), document.seams());
    mCutCount->setText(countText(counts.cut));
    mHalfCutCount->setText(countText(counts.halfCut));
    mJoinCount->setText(countText(counts.joined));
    mKeepCount->setText(countText(counts.keptTogether));
    mAttractCount->setText(countText(counts.attracting));
    mStraightCount->setText(countText(counts.straight));
    enableOrSay(mClearAll, counts.cut + counts.halfCut + counts.joined > 0,
                tr("No edge is cut or joined by hand"));
    enableOrSay(mErasePaint, counts.keptTogether + counts.attracting > 0, tr("Nothing is painted"));
}

void SeamPanel::showGivenSeams()
{
    const SolveSettings settings = document() ? document()->solveSettings() : SolveSettings();
    mGiven->setSettings(settings);
    if (settings.seams == SeamMode::Free) {
        mGivenCount->setText(missingText());
        return;
    }
    const std::vector<bool> &given = document()->givenSeams();
    mGivenCount->setText(countText(std::count(given.begin(), given.end(), true)));
}

void SeamPanel::showPrices()
{
    mPrices->setPrices(document() ? context().map.seamPrices() : nullptr,
                       document() ? document()->solveSettings().maxDistortion : 0);
    mPrices->setCanPrice(document() && hasUvs(*document()) && !context().map.jobs().isBusy());
}

void SeamPanel::showMap()
{
    const MapFigures *figures = document() ? context().map.figures() : nullptr;
    const bool hasMap = figures && figures->metrics.charts > 0;
    mSeamEdges->setText(hasMap ? countText(figures->metrics.seamEdges) : missingText());
    mSeamLength->setText(hasMap ? significantText(figures->metrics.seamLength, 5) : missingText());
    mSeamNorm->setText(hasMap ? fixedText(figures->metrics.seamNorm, 3) : missingText());
    // Outdated figures are dimmed until the new map has been measured.
    for (QLabel *label : {mSeamEdges, mSeamLength, mSeamNorm})
        label->setEnabled(context().map.figuresAreFresh());
}

} // namespace autocuts
