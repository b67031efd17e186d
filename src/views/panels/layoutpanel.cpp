#include "views/panels/layoutpanel.h"

#include "model/document/document.h"
#include "views/actions/actionregistry.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/state/viewstate.h"
#include "views/tools/layoutchoices.h"
#include "views/ui/reasons.h"
#include "views/ui/scrublabel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QScopedValueRollback>
#include <QToolButton>

#include <cmath>
#include <numbers>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Milliseconds within which the next step of a field belongs to the same gesture. Chosen by hand.
constexpr int gestureTime = 500;
constexpr double largest = 1e5;   // of a coordinate or a size, in units of the fields
constexpr double smallest = 1e-5; // of a size
constexpr int iconSize = 20;      // logical pixels
constexpr int actionsPerRow = 10;
constexpr int leastFieldWidth = 84; // logical pixels; for six digits

} // namespace

LayoutPanel::LayoutPanel(const StudioContext &context, QWidget *parent)
    : Panel(context, tr("Open a model to arrange the islands of its map."), parent)
{
    mGesture.setSingleShot(true);
    mGesture.setInterval(gestureTime);
    connect(&mGesture, &QTimer::timeout, this, [this] { refreshSoon(); });
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing + 2);
    layout->addWidget(makeHeading(tr("Selected islands")));
    layout->addWidget(makeNumbers());
    layout->addWidget(makeActions());
    layout->addWidget(makePivotRows());
    layout->addStretch();
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] {
        mTransform.reset();
        refreshSoon();
    });
    connect(&context.workspace, &Workspace::selectionChanged, this, [this] {
        mGesture.stop();
        refreshSoon();
    });
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::Uv || event.type == ChangeEvent::Type::UvSet ||
            event.type == ChangeEvent::Type::IslandFlag || event.type == ChangeEvent::Type::PackingSettings)
            refreshSoon(mGesture.isActive() ? gestureTime : 0);
    });
    connect(&context.shownMap, &ShownMap::changed, this, [this] { refreshSoon(gestureTime); });
    connect(&context.map.jobs(), &JobRunner::busyChanged, this, [this] { refreshSoon(); });
    connect(&context.view, &ViewState::toolsChanged, this, [this] { refreshSoon(); });
}

QDoubleSpinBox *LayoutPanel::makeNumber(QLatin1StringView name, void (LayoutPanel::*changed)(double))
{
    auto *number = new QDoubleSpinBox;
    number->setObjectName(name);
    number->setKeyboardTracking(false);
    number->setRange(-largest, largest);
    connect(number, &QDoubleSpinBox::valueChanged, this, [this, changed](double value) {
        if (!mShowing)
            (this->*changed)(value);
    });
    return number;
}

QComboBox *LayoutPanel::makeChoice(const ToolOption &option, QLatin1StringView name)
{
    auto *box = new QComboBox;
    box->setObjectName(name);
    box->addItems(option.choices);
    connect(box, &QComboBox::activated, this, option.set);
    return box;
}

QWidget *LayoutPanel::makeNumbers()
{
    mPosition[0] = makeNumber("positionU"_L1, &LayoutPanel::moveToU);
    mPosition[1] = makeNumber("positionV"_L1, &LayoutPanel::moveToV);
    mSize[0] = makeNumber("width"_L1, &LayoutPanel::scaleToWidth);
    mSize[1] = makeNumber("height"_L1, &LayoutPanel::scaleToHeight);
    mTurn = makeNumber("turn"_L1, &LayoutPanel::turnBy);
    mTurn->setRange(-360, 360);
    mTurn->setDecimals(2);
    mTurn->setSuffix(u"\u00b0"_s);
    const ToolOption unit = unitChoice(context().view);
    mUnit = makeChoice(unit, "unit"_L1);
    mProportions = new QCheckBox(tr("Keep proportions"));
    mProportions->setObjectName("proportions"_L1);
    mProportions->setChecked(true);

    auto *box = new QWidget;
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(rowSpacing);
    const auto add = [grid](int row, int column, const QString &name, QWidget *field, const QString &tip) {
        QAbstractSpinBox *number = spinBoxOf(field);
        auto *caption = number ? new ScrubLabel(name, number) : new QLabel(name);
        caption->setBuddy(field);
        caption->setToolTip(tip);
        field->setToolTip(tip);
        field->setAccessibleName(name);
        field->setMinimumWidth(leastFieldWidth);
        grid->addWidget(caption, row, column);
        grid->addWidget(field, row, column + 1);
    };
    const QString position = tr("Of the lower left corner when that is the pivot, else of the centre");
    const QString size = tr("Of the box around the selected islands");
    add(0, 0, tr("U"), mPosition[0], position);
    add(0, 2, tr("V"), mPosition[1], position);
    add(1, 0, tr("Width"), mSize[0], size);
    add(1, 2, tr("Height"), mSize[1], size);
    add(2, 0, tr("Turn by"), mTurn, tr("Degrees, counter-clockwise, about the pivot"));
    add(2, 2, unit.name, mUnit, unit.tip);
    grid->addWidget(mProportions, 3, 1, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return box;
}

QWidget *LayoutPanel::makePivotRows()
{
    const ToolOption pivot = pivotChoice(context().view), snap = snapChoice(context().view);
    mPivot = makeChoice(pivot, "pivot"_L1);
    mSnap = makeChoice(snap, "snap"_L1);
    for (const int axis : {0, 1}) {
        mCursor[axis] = new QDoubleSpinBox;
        mCursor[axis]->setObjectName(axis == 0 ? "cursorU"_L1 : "cursorV"_L1);
        mCursor[axis]->setKeyboardTracking(false);
        mCursor[axis]->setRange(-largest, largest);
        mCursor[axis]->setMinimumWidth(leastFieldWidth);
        connect(mCursor[axis], &QDoubleSpinBox::valueChanged, this, [this, axis](double value) {
            if (mShowing)
                return;
            ToolSettings tools = this->context().view.tools();
            tools.cursor[axis] = value / unit()[axis];
            this->context().view.setTools(tools);
        });
    }
    auto *box = new QWidget;
    auto *form = makeForm(box);
    addRow(form, pivot.name, mPivot, pivot.tip);
    mCursorRow = makeRow({mCursor[0], mCursor[1]});
    mCursorRow->setFocusProxy(mCursor[0]);
    addRow(form, tr("Cursor"), mCursorRow, tr("The 2D cursor; Shift+right click in the UV view places it"));
    addRow(form, snap.name, mSnap, snap.tip);
    return box;
}

void LayoutPanel::addActions(QGridLayout *grid, int row, std::initializer_list<const char *> ids)
{
    int column = 0;
    for (const char *id : ids) {
        auto *button = new QToolButton;
        button->setDefaultAction(context().actions.action(id));
        button->setIconSize({iconSize, iconSize});
        button->setAutoRaise(true);
        button->setObjectName(QLatin1String(id));
        grid->addWidget(button, row, column++);
    }
}

QWidget *LayoutPanel::makeActions()
{
    auto *box = new QWidget;
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    addActions(grid, 0,
               {"uv.alignLeft", "uv.alignCentreU", "uv.alignRight", "uv.alignTop", "uv.alignCentreV",
                "uv.alignBottom", "uv.distributeU", "uv.distributeV", "uv.distributeGapsU",
                "uv.distributeGapsV"});
    addActions(grid, 1,
               {"uv.turnLeft", "uv.turnRight", "uv.mirrorU", "uv.mirrorV", "uv.orientBox", "uv.orientEdges",
                "uv.straighten", "uv.grid", "uv.relax", "uv.fitTile"});
    addActions(grid, 2,
               {"uv.alignAxes", "uv.stackCopies", "uv.unstackCopies", "uv.densitySet", "uv.scatter",
                "uv.packSelection"});
    grid->setColumnStretch(actionsPerRow, 1);
    return box;
}

Vec2 LayoutPanel::unit() const
{
    if (!document())
        return Vec2::Ones();
    return unitsPerLength(context().view.tools().unit, document()->packingSettings());
}

Vec2 LayoutPanel::reference(const MovableIslands &islands) const
{
    return context().view.tools().pivot == Pivot::Corner ? Vec2(islands.box.min())
                                                         : Vec2(islands.box.center());
}

bool LayoutPanel::begin(UvEdit edit)
{
    const bool goesOn = mTransform && mGesture.isActive() && edit == mEdit && ScrubLabel::gesture() == mScrub;
    mGesture.start();
    if (goesOn)
        return true;
    mScrub = ScrubLabel::gesture();
    mEdit = edit;
    mTransform.reset();
    if (!document() || context().shownMap.isLive() || context().map.jobs().isBusy())
        return false;
    mStart = movableIslands(*document(), context().view.tools());
    if (mStart.isEmpty())
        return false;
    mTransform.emplace(*document(), edit, mStart.islands);
    mMove.setZero();
    mFactor.setOnes();
    return true;
}

void LayoutPanel::edit(const std::function<Eigen::Affine2d(int island)> &transformOf)
{
    if (mTransform)
        pushCommand(mTransform->command(transformOf));
    refreshSoon(gestureTime); // what cannot be moved keeps its numbers
}

void LayoutPanel::moveTo(int axis, double value)
{
    if (begin(UvEdit::Move))
        mMove[axis] = value / unit()[axis] - reference(mStart)[axis];
    edit([this](int) { return Eigen::Affine2d(Eigen::Translation2d(mMove)); });
}

void LayoutPanel::scaleTo(int axis, double value)
{
    if (begin(UvEdit::Scale)) {
        mFactor[axis] = value / unit()[axis] / std::max(mStart.box.sizes()[axis], smallest);
        if (mProportions->isChecked())
            mFactor[1 - axis] = mFactor[axis];
    }
    edit([this](int island) { return scaledAbout(mStart.pivotOf(island), mFactor); });
}

void LayoutPanel::turnBy(double degrees)
{
    begin(UvEdit::Rotate);
    edit([&](int island) { return turnedAbout(mStart.pivotOf(island), degrees * std::numbers::pi / 180); });
}

void LayoutPanel::refresh()
{
    const QScopedValueRollback showing(mShowing, true);
    const ToolSettings &tools = context().view.tools();
    mPivot->setCurrentIndex(int(tools.pivot));
    mSnap->setCurrentIndex(int(tools.snap));
    mUnit->setCurrentIndex(int(tools.unit));
    const bool texels = tools.unit == LengthUnit::Texels;
    for (QDoubleSpinBox *field : {mPosition[0], mPosition[1], mSize[0], mSize[1], mCursor[0], mCursor[1]}) {
        field->setDecimals(texels ? 2 : 5);
        field->setSingleStep(texels ? 1 : 0.01);
    }
    for (const int axis : {0, 1}) {
        mSize[axis]->setMinimum(texels ? 0.01 : smallest);
        mCursor[axis]->setValue(tools.cursor[axis] * unit()[axis]);
        enableOrSay(mCursor[axis], tools.pivot == Pivot::Cursor, tr("The pivot is not the 2D cursor"));
    }
    showNumbers();
}

void LayoutPanel::showNumbers()
{
    MovableIslands islands;
    const bool rests = document() && !context().shownMap.isLive() && !context().map.jobs().isBusy();
    if (rests)
        islands = movableIslands(*document(), context().view.tools());
    for (QWidget *field :
         std::initializer_list<QWidget *>{mPosition[0], mPosition[1], mSize[0], mSize[1], mTurn})
        enableOrSay(field, !islands.isEmpty(),
                    rests ? tr("Select islands that may move first")
                          : tr("Islands are placed when no solve and no job runs"));
    if (!mGesture.isActive())
        mTurn->setValue(0);
    if (islands.isEmpty()) {
        for (QDoubleSpinBox *field : {mPosition[0], mPosition[1], mSize[0], mSize[1]}) {
            if (rests || !document()) // what they show is of islands that are not selected any more
                field->clear();
        }
        return;
    }
    for (const int axis : {0, 1}) {
        mPosition[axis]->setValue(reference(islands)[axis] * unit()[axis]);
        mSize[axis]->setValue(islands.box.sizes()[axis] * unit()[axis]);
    }
}

} // namespace autocuts
