#include "views/ui/scrublabel.h"

#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QSpinBox>

#include <cmath>

namespace autocuts {

namespace {

// Chosen by hand.
constexpr double pixelsPerStep = 4;
constexpr double speed = 10; // of Shift, and inverse of that of Ctrl

quint64 lastGesture = 0;
bool scrubs = false;

} // namespace

ScrubLabel::ScrubLabel(const QString &text, QAbstractSpinBox *field, QWidget *parent)
    : QLabel(text, parent), mField(field)
{
    setCursor(Qt::SizeHorCursor);
}

quint64 ScrubLabel::gesture()
{
    return scrubs ? lastGesture : 0;
}

void ScrubLabel::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !mField->isEnabled())
        return;
    mScrubs = scrubs = true;
    ++lastGesture;
    mLast = event->position().x();
    mRest = 0;
}

void ScrubLabel::mouseMoveEvent(QMouseEvent *event)
{
    if (!mScrubs)
        return;
    const double x = event->position().x();
    const double factor = event->modifiers().testFlag(Qt::ShiftModifier)     ? speed
                          : event->modifiers().testFlag(Qt::ControlModifier) ? 1 / speed
                                                                             : 1;
    mRest += (x - std::exchange(mLast, x)) / pixelsPerStep * factor;
    step(mRest);
}

void ScrubLabel::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        mScrubs = scrubs = false;
}

//! Number fields with decimals can make parts of a step.
void ScrubLabel::step(double steps)
{
    if (auto *numbers = qobject_cast<QDoubleSpinBox *>(mField)) {
        const double before = numbers->value();
        const double smallest = std::pow(10, -numbers->decimals());
        const double change = std::round(steps * numbers->singleStep() / smallest) * smallest;
        if (change == 0)
            return;
        mRest -= change / numbers->singleStep();
        numbers->setValue(before + change);
        return;
    }
    const int whole = static_cast<int>(std::trunc(steps));
    mRest -= whole;
    if (whole != 0)
        mField->stepBy(whole);
}

QAbstractSpinBox *spinBoxOf(QWidget *field)
{
    while (field && !qobject_cast<QAbstractSpinBox *>(field))
        field = field->focusProxy();
    return qobject_cast<QAbstractSpinBox *>(field);
}

} // namespace autocuts
