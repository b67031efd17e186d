#include "views/tools/rectanglebar.h"

#include "model/document/islandcolor.h"
#include "views/control/workspace.h"
#include "views/selecting/selecting.h"
#include "views/tools/rectangles.h"
#include "views/ui/icons.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int colorsOffered = 10;
constexpr double largestWeight = 1000;

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
    mName->setFixedWidth(130);
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
    mWeight->setKeyboardTracking(false);
    mWeight->setToolTip(tr("How strongly faces are pulled into this rectangle, as a factor of beta"));
    mAssign = button(this, "rectangleAssign", u"island"_s, tr("Assign the selected faces"));
    mPack = button(this, "rectanglePack", u"pack"_s,
                   tr("Pack its islands into the rectangle, or the selected ones when it has none"));
    mClear = button(this, "rectangleClear", u"clear"_s, tr("Let all its faces go"));
    mRemove = button(this, "rectangleRemove", u"cancel"_s, tr("Remove the rectangle [Del]"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 3, 6, 3);
    for (QWidget *widget :
         std::initializer_list<QWidget *>{mColor, mName, mHard, mWeight, mAssign, mPack, mClear, mRemove})
        layout->addWidget(widget);
}

void RectangleBar::connectWidgets()
{
    using Edit = EditRectangles::Edit;
    connect(mName, &QLineEdit::editingFinished, this,
            [this] { edit(Edit::Rename, [this](LayoutRectangle &r) { r.name = mName->text().trimmed(); }); });
    connect(mName, &QLineEdit::returnPressed, this, [this] { parentWidget()->setFocus(); });
    connect(mHard, &QCheckBox::clicked, this,
            [this](bool hard) { edit(Edit::Change, [hard](LayoutRectangle &r) { r.hard = hard; }); });
    connect(mWeight, &QDoubleSpinBox::valueChanged, this, [this](double weight) {
        edit(
            Edit::Change, [weight](LayoutRectangle &r) { r.weight = weight; }, mGesture);
    });
    connect(mWeight, &QDoubleSpinBox::editingFinished, this, [this] {
        if (Document *document = mWorkspace.document())
            mGesture = document->undoStack().newGesture();
    });
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
                [this, color] {
                    edit(EditRectangles::Edit::Recolor, [color](LayoutRectangle &r) { r.color = color; });
                });
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
void RectangleBar::edit(EditRectangles::Edit kind, Change change, quint64 gesture)
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
        if (Document *document = mWorkspace.document())
            mGesture = document->undoStack().newGesture();
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
    mWeight->setEnabled(!shown->hard);
    mClear->setEnabled(!shown->faces.isEmpty());
    place();
}

void RectangleBar::place()
{
    adjustSize();
    move(std::max(0, (parentWidget()->width() - width()) / 2), 26);
}

bool RectangleBar::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize && isVisible())
        place();
    return QFrame::eventFilter(watched, event);
}

} // namespace autocuts
