#include "views/tools/rectanglebar.h"

#include "model/document/islandcolor.h"
#include "views/control/session/workspace.h"
#include "views/selecting/selecting.h"
#include "views/tools/rectangles.h"
#include "views/ui/icons.h"
#include "views/ui/inputguard.h"
#include "views/ui/reasons.h"
#include "views/ui/scrublabel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QToolButton>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int colorsOffered = 10;
constexpr double largestWeight = 1000;
constexpr double largestNumber = 1e6;
constexpr int numberWidth = 58;

QIcon swatch(QRgb color)
{
    QPixmap pixmap(16, 16);
    pixmap.fill(QColor(color));
    return pixmap;
}

QToolButton *button(QWidget *parent, const char *name, const QString &iconName, const QString &tip)
{
    auto *result = new QToolButton(parent);
    result->setObjectName(QLatin1String(name));
    result->setAutoRaise(true);
    result->setFocusPolicy(Qt::NoFocus);
    result->setToolTip(tip);
    if (!iconName.isEmpty())
        result->setIcon(icon(iconName));
    return result;
}

} // namespace

RectangleBar::RectangleBar(Workspace &workspace, QWidget *view) : QFrame(view), mWorkspace(workspace)
{
    setObjectName(u"rectangleBar"_s);
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    new InputGuard(this);
    makeWidgets();
    addColors();
    connectWidgets();
    connect(&workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::Rectangle)
            refresh();
    });
    view->installEventFilter(this);
    hide();
}

void RectangleBar::makeWidgets()
{
    mColor = button(this, "rectangleColor", {}, tr("Colour"));
    mName = new QLineEdit(this);
    mName->setObjectName(u"rectangleName"_s);
    mName->setMaxLength(maxNameLength);
    mName->setMinimumWidth(60);
    mName->setMaximumWidth(130);
    mName->setToolTip(tr("Name"));
    mHard = new QCheckBox(tr("Hard"), this);
    mHard->setObjectName(u"rectangleHard"_s);
    mHard->setToolTip(tr("Hard: no face may leave. Soft: leaving costs energy"));
    mWeight = new QDoubleSpinBox(this);
    mWeight->setObjectName(u"rectangleWeight"_s);
    mWeight->setRange(0, largestWeight);
    mWeight->setDecimals(2);
    mWeight->setSingleStep(0.5);
    mWeight->setPrefix(u"\u03b2 \u00d7 "_s);
    mWeight->setFixedWidth(84);
    mWeight->setKeyboardTracking(false);
    mWeight->setToolTip(tr("How strongly faces are pulled into this rectangle, as a factor of beta"));
    mAssign = button(this, "rectangleAssign", u"island"_s, tr("Assign the selected faces"));
    mPack = button(this, "rectanglePack", u"pack"_s,
                   tr("Pack its islands into the rectangle, or the selected ones when it has none"));
    mClear = button(this, "rectangleClear", u"clear"_s, tr("Let all its faces go"));
    mRemove = button(this, "rectangleRemove", u"cancel"_s, tr("Remove the rectangle [Del]"));
    makeNumbers();
    mParts = {makePart({mColor, mName, mHard}), makePart({mWeight, mAssign, mPack, mClear, mRemove}),
              makePart({mCaptions[0], mNumbers[0], mCaptions[1], mNumbers[1]}),
              makePart({mCaptions[2], mNumbers[2], mCaptions[3], mNumbers[3], mUnit})};
    mLayout = new QGridLayout(this);
    mLayout->setContentsMargins(6, 3, 6, 3);
    mLayout->setSpacing(3);
}

QWidget *RectangleBar::makePart(std::initializer_list<QWidget *> widgets)
{
    auto *part = new QWidget(this);
    auto *row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(3);
    for (QWidget *widget : widgets)
        row->addWidget(widget);
    row->addStretch();
    return part;
}

void RectangleBar::makeNumbers()
{
    struct Field
    {
        const char *name;
        QString caption, tip;
    };
    const std::array<Field, 4> fields{
        Field{"rectangleU", tr("U"), tr("Left side")}, Field{"rectangleV", tr("V"), tr("Lower side")},
        Field{"rectangleWidth", tr("W"), tr("Width")}, Field{"rectangleHeight", tr("H"), tr("Height")}};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const Field &field = fields[i];
        auto *number = new QDoubleSpinBox(this);
        number->setObjectName(QLatin1String(field.name));
        number->setKeyboardTracking(false);
        number->setRange(-largestNumber, largestNumber);
        number->setFixedWidth(numberWidth);
        number->setButtonSymbols(QAbstractSpinBox::NoButtons);
        number->setToolTip(field.tip);
        number->setAccessibleName(field.tip);
        auto *caption = new ScrubLabel(field.caption, number, this);
        caption->setToolTip(field.tip);
        connect(number, &QDoubleSpinBox::valueChanged, this,
                [this, i](double value) { setNumber(static_cast<int>(i), value); });
        connect(number, &QDoubleSpinBox::editingFinished, this, [this] { mGesture = 0; });
        mCaptions[i] = caption;
        mNumbers[i] = number;
    }
    mUnit = new QComboBox(this);
    mUnit->setObjectName(u"rectangleUnit"_s);
    mUnit->addItems({tr("UV"), tr("px")});
    mUnit->setToolTip(tr("UV units, or texels of the texture size of the Packing panel"));
    connect(mUnit, &QComboBox::activated, this, [this] { refresh(); });
}

void RectangleBar::connectWidgets()
{
    connect(mName, &QLineEdit::editingFinished, this,
            [this] { edit(Edit::Rename, [this](LayoutRectangle &r) { r.name = mName->text().trimmed(); }); });
    connect(mHard, &QCheckBox::clicked, this,
            [this](bool hard) { edit(Edit::Change, [hard](LayoutRectangle &r) { r.hard = hard; }); });
    connect(mWeight, &QDoubleSpinBox::valueChanged, this, [this](double weight) {
        edit(
            Edit::Change, [weight](LayoutRectangle &r) { r.weight = weight; }, gestureOf(Edit::Change));
    });
    connect(mWeight, &QDoubleSpinBox::editingFinished, this, [this] { mGesture = 0; });
    connect(mAssign, &QToolButton::clicked, this, [this] {
        if (Document *document = mWorkspace.document())
            pushCommand(assignFaces(*document, mId, facesOf(*document, document->selection())));
    });
    connect(mPack, &QToolButton::clicked, this, [this] { Q_EMIT packRequested(mId); });
    connect(mClear, &QToolButton::clicked, this,
            [this] { edit(Edit::Assign, [](LayoutRectangle &r) { r.faces.clear(); }); });
    connect(mRemove, &QToolButton::clicked, this, [this] {
        if (Document *document = mWorkspace.document())
            pushCommand(EditRectangles::remove(*document, {{mId}}));
    });
}

void RectangleBar::addColors()
{
    auto *menu = new QMenu(mColor);
    for (int i = 1; i <= colorsOffered; ++i) {
        const QRgb color = islandColor(i);
        connect(menu->addAction(swatch(color), QColor(color).name()), &QAction::triggered, this,
                [this, color] { edit(Edit::Recolor, [color](LayoutRectangle &r) { r.color = color; }); });
    }
    mColor->setMenu(menu);
    mColor->setPopupMode(QToolButton::InstantPopup);
}

const LayoutRectangle *RectangleBar::rectangle() const
{
    const Document *document = mWorkspace.document();
    return document ? document->constraints().rectangle(mId) : nullptr;
}

template <typename Change>
void RectangleBar::edit(Edit kind, Change change, quint64 gesture)
{
    const LayoutRectangle *before = rectangle();
    if (!before)
        return;
    LayoutRectangle after = *before;
    change(after);
    if (after == *before)
        return;
    auto command =
        std::make_unique<EditRectangles>(*mWorkspace.document(), kind, std::vector<LayoutRectangle>{after});
    command->setGesture(gesture);
    pushCommand(std::move(command));
}

void RectangleBar::setRectangle(int id)
{
    if (id != mId) {
        if (mName->hasFocus())
            parentWidget()->setFocus(); // typed text belongs to the previous rectangle
        mId = id;
        mGesture = 0;
    }
    refresh();
}

void RectangleBar::editName()
{
    mName->setFocus(Qt::MouseFocusReason);
    mName->selectAll();
}

void RectangleBar::refresh()
{
    const LayoutRectangle *shown = rectangle();
    setVisible(shown != nullptr);
    if (!shown)
        return;
    mColor->setIcon(swatch(shown->color));
    if (mName->text() != shown->name)
        mName->setText(shown->name);
    mHard->setChecked(shown->hard);
    const QSignalBlocker blocker(mWeight);
    mWeight->setValue(shown->weight);
    enableOrSay(mWeight, !shown->hard, tr("A hard rectangle is obeyed in any case"));
    enableOrSay(mClear, !shown->faces.isEmpty(), tr("No faces belong to it"));
    showNumbers(*shown);
    place();
}

double RectangleBar::unit() const
{
    return mUnit->currentIndex() == 1 ? mWorkspace.document()->packingSettings().textureSize : 1;
}

void RectangleBar::showNumbers(const LayoutRectangle &rectangle)
{
    const QScopedValueRollback showing(mShowing, true);
    const Vec2 size = rectangle.upper - rectangle.lower;
    const std::array<double, 4> values{rectangle.lower.x(), rectangle.lower.y(), size.x(), size.y()};
    for (std::size_t i = 0; i < mNumbers.size(); ++i) {
        mNumbers[i]->setDecimals(unit() == 1 ? 4 : 1);
        mNumbers[i]->setSingleStep(unit() == 1 ? 0.01 : 1);
        if (i >= 2)
            mNumbers[i]->setMinimum(unit() == 1 ? 1e-4 : 0.1);
        mNumbers[i]->setValue(values[i] * unit());
    }
}

//! The steps of one field are one undo entry until it is left, and so are those of one drag of its caption.
quint64 RectangleBar::gestureOf(Edit kind)
{
    if (kind != mGestureEdit || ScrubLabel::gesture() != mScrub || mGesture == 0)
        mGesture = mWorkspace.document()->undoStack().newGesture();
    mGestureEdit = kind;
    mScrub = ScrubLabel::gesture();
    return mGesture;
}

void RectangleBar::setNumber(int number, double value)
{
    if (mShowing || !rectangle())
        return;
    const int axis = number % 2;
    const Edit kind = number < 2 ? Edit::Move : Edit::Resize;
    edit(
        kind,
        [&](LayoutRectangle &r) {
            const double change =
                value / unit() - (kind == Edit::Move ? r.lower : Vec2(r.upper - r.lower))[axis];
            r.upper[axis] += change;
            if (kind == Edit::Move)
                r.lower[axis] += change;
        },
        gestureOf(kind));
}

//! Two parts in a row, or one where the view is narrow.
void RectangleBar::place()
{
    const int room = parentWidget()->width() - 2 * frameWidth() - 12;
    const int columns = std::max(mParts[0]->sizeHint().width(), mParts[2]->sizeHint().width()) +
                                    std::max(mParts[1]->sizeHint().width(), mParts[3]->sizeHint().width()) >
                                room
                            ? 1
                            : 2;
    for (int i = 0; i < 4; ++i)
        mLayout->addWidget(mParts[static_cast<std::size_t>(i)], i / columns, i % columns);
    mLayout->activate();
    resize(std::min(sizeHint().width(), std::max(room, minimumSizeHint().width())), sizeHint().height());
    move(std::max(0, (parentWidget()->width() - width()) / 2), 26);
}

bool RectangleBar::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize && isVisible())
        place();
    return QFrame::eventFilter(watched, event);
}

} // namespace autocuts
