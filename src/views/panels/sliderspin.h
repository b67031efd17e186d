// A slider with a spin box for one number.
#pragma once

#include <QTimer>
#include <QWidget>

#include <functional>

class QDoubleSpinBox;
class QSlider;

namespace autocuts {

//! Maps positions of a slider to values.
struct SliderScale
{
    double minimum = 0, maximum = 1;
    int steps = 1000;     //!< number of positions of the slider, minus one
    int singleSteps = 10; //!< positions per press of an arrow key
    int pageSteps = 100;
    std::function<double(double)> toValue;    //!< increasing, from [0, 1]
    std::function<double(double)> toFraction; //!< inverse of toValue

    static SliderScale linear(double minimum, double maximum);
    //! A scale that is finer near the minimum: value = minimum + (maximum - minimum) * fraction^2.
    static SliderScale fineNearMinimum(double minimum, double maximum);
    //! A logarithmic scale with four steps per power of two. \param first, last exponents at the ends
    static SliderScale powersOfTwo(int first, int last);
};

//! Recognises gestures: a drag of the slider is one, and so are key presses or wheel turns with less than
//! half a second between them.
class SliderSpin final : public QWidget
{
    Q_OBJECT

public:
    //! \param spinBox becomes a child; its range is set to that of the scale
    SliderSpin(SliderScale scale, QDoubleSpinBox *spinBox, QWidget *parent = nullptr);

    QSlider *slider() const { return mSlider; }
    QDoubleSpinBox *spinBox() const { return mSpinBox; }
    double value() const;
    //! Shows a value without emitting signals.
    void setValue(double value);

Q_SIGNALS:
    //! The user changed the value. \param first true at the beginning of a gesture
    void edited(double value, bool first);

private:
    void report(double value);

    SliderScale mScale;
    QSlider *mSlider;
    QDoubleSpinBox *mSpinBox;
    QTimer mGestureTimer; //!< runs while further keys or wheel turns continue the gesture
    bool mInDrag = false;
};

} // namespace autocuts
