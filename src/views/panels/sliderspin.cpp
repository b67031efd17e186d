#include "views/panels/sliderspin.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace autocuts {

namespace {

constexpr int gesturePause = 500; //!< milliseconds

} // namespace

SliderScale SliderScale::linear(double minimum, double maximum)
{
    return {.minimum = minimum,
            .maximum = maximum,
            .toValue = [=](double fraction) { return minimum + (maximum - minimum) * fraction; },
            .toFraction = [=](double value) { return (value - minimum) / (maximum - minimum); }};
}

SliderScale SliderScale::fineNearMinimum(double minimum, double maximum)
{
    const double span = maximum - minimum;
    return {.minimum = minimum,
            .maximum = maximum,
            .toValue = [=](double fraction) { return minimum + span * fraction * fraction; },
            .toFraction = [=](double value) { return std::sqrt(std::max(0.0, (value - minimum) / span)); }};
}

SliderScale SliderScale::powersOfTwo(int first, int last)
{
    return {.minimum = std::exp2(first),
            .maximum = std::exp2(last),
            .steps = 4 * (last - first),
            .singleSteps = 1,
            .pageSteps = 4,
            .toValue = [=](double fraction) { return std::exp2(first + (last - first) * fraction); },
            .toFraction = [=](double value) { return (std::log2(value) - first) / (last - first); }};
}

SliderSpin::SliderSpin(SliderScale scale, QDoubleSpinBox *spinBox, QWidget *parent)
    : QWidget(parent), mScale(std::move(scale)), mSlider(new QSlider(Qt::Horizontal)), mSpinBox(spinBox)
{
    mSlider->setRange(0, mScale.steps);
    mSlider->setSingleStep(mScale.singleSteps);
    mSlider->setPageStep(mScale.pageSteps);
    mSlider->setMinimumWidth(60);
    mSpinBox->setRange(mScale.minimum, mScale.maximum);
    mSpinBox->setKeyboardTracking(false);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(mSlider, 1);
    layout->addWidget(mSpinBox);
    setFocusProxy(mSpinBox);

    mGestureTimer.setSingleShot(true);
    mGestureTimer.setInterval(gesturePause);
    connect(mSlider, &QSlider::valueChanged, this,
            [this](int position) { report(mScale.toValue(double(position) / mScale.steps)); });
    connect(mSpinBox, &QDoubleSpinBox::valueChanged, this, &SliderSpin::report);
    connect(mSlider, &QSlider::sliderPressed, this, [this] { mInDrag = false; });
    connect(mSlider, &QSlider::sliderReleased, this, [this] {
        mInDrag = false;
        mGestureTimer.stop();
    });
}

double SliderSpin::value() const
{
    return mSpinBox->value();
}

void SliderSpin::setValue(double value)
{
    const QSignalBlocker blockSlider(mSlider);
    const QSignalBlocker blockSpinBox(mSpinBox);
    mSpinBox->setValue(value);
    // During a drag the handle follows the mouse, even when the value was rounded.
    if (!mSlider->isSliderDown())
        mSlider->setValue(
            static_cast<int>(std::lround(std::clamp(mScale.toFraction(value), 0.0, 1.0) * mScale.steps)));
}

void SliderSpin::report(double value)
{
    setValue(value);
    const bool first = mSlider->isSliderDown() ? !mInDrag : !mGestureTimer.isActive();
    mInDrag = mSlider->isSliderDown();
    mGestureTimer.start();
    Q_EMIT edited(mSpinBox->value(), first);
}

} // namespace autocuts
