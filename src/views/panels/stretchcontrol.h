// The control for how much a map may stretch.
#pragma once

#include <QWidget>

#include <vector>

class QLabel;
class QToolButton;

namespace autocuts {

class SliderSpin;

//! Sets the bound on the distortion D: by a slider, by a word, or as a number. Also says it as mean stretch,
//! the share by which D is above the 4 of a map without distortion.
class StretchControl final : public QWidget
{
    Q_OBJECT

public:
    explicit StretchControl(QWidget *parent = nullptr);

    //! Shows a bound without emitting signals. \param bound on D, > 4
    void setValue(double bound);

Q_SIGNALS:
    //! The user changed the bound. \param first true at the beginning of a gesture
    void edited(double bound, bool first);

private:
    SliderSpin *mBound;
    std::vector<QToolButton *> mWords;
    QLabel *mPercent;
};

} // namespace autocuts
