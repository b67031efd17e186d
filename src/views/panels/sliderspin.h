// A slider beside a spin box, for one number.
#pragma once

#include <QTimer>
#include <QWidget>

#include <functional>

class QDoubleSpinBox;
class QSlider;

namespace autocuts {

//! How positions of a slider stand for values.
struct SliderScale
{
    double minimum = 0, maximum = 1;
    int steps = 1000;     //!< positions of the slider, less one
    int singleSteps = 10; //!< for an arrow key
    int pageSteps = 100;
    std::function<double(double)> toValue;    //!< from [0, 1], rising
    std::function<double(double)> toFraction; //!< its inverse

    static SliderScale linear(double minimum, double maximum);
    //! Finer near the minimum: value = minimum + (maximum - minimum) * fraction^2.
    static SliderScale fineNearMinimum(double minimum, double maximum);
    //! Quarters of powers of two. \param first, last exponents of the ends
    static SliderScale powersOfTwo(int first, int last);
};

//! Tells gestures apart: a drag of the slider is one, and so are keys or turns of the wheel that follow each
//! other within half a second.
class SliderSpin final : public QWidget
{
    Q_OBJECT

public:
    //! \param spinBox becomes a child; its range becomes that of the scale
    SliderSpin(SliderScale scale, QDoubleSpinBox *spinBox, QWidget *parent = nullptr);

    QSlider *slider() const { return mSlider; }
    QDoubleSpinBox *spinBox() const { return mSpinBox; }
    double value() const;
    //! Shows a value without a signal.
    void setValue(double value);

Q_SIGNALS:
    //! The user changed the value. \param first true when this begins a gesture
    void edited(double value, bool first);

private:
    void report(double value);

    SliderScale mScale;
    QSlider *mSlider;
    QDoubleSpinBox *mSpinBox;
    QTimer mGestureTimer; //!< runs while a change by keys or wheel continues the gesture
    bool mInDrag = false;
};

} // namespace autocuts
