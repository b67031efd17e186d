// The settings of the solver that are chosen once, before it runs.
#pragma once

#include "model/plain/solvesettings.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace autocuts {

//! Start, distortion energy, weighting of the seams, kind of solver, weight of rectangles, seed. Knows no
//! document: what is chosen is told by a signal.
class SolverSettingsForm final : public QWidget
{
    Q_OBJECT

public:
    explicit SolverSettingsForm(QWidget *parent = nullptr);

    //! Shows settings without a signal.
    void setSettings(const SolveSettings &settings);

Q_SIGNALS:
    //! \param edit changes the setting that was chosen
    void edited(const std::function<void(autocuts::SolveSettings &)> &edit);

private:
    void addChoices(QFormLayout *form);
    void addNumbers(QFormLayout *form);
    //! Tells what is chosen in the box. \param apply puts the data of an item into settings
    void follow(QComboBox *box, void (*apply)(SolveSettings &, int));

    QComboBox *mStart, *mEnergy, *mWeighting, *mSolver;
    QDoubleSpinBox *mBoxWeight;
    QSpinBox *mSeed;
};

} // namespace autocuts
