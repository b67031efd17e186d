// The form for settings of the solver that are set before it runs.
#pragma once

#include "model/plain/solvesettings.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace autocuts {

//! Sets start, distortion energy, weighting of seams, solver, weight of rectangles and seed. Does not use the
//! document; changes are emitted as signals.
class SolverSettingsForm final : public QWidget
{
    Q_OBJECT

public:
    explicit SolverSettingsForm(QWidget *parent = nullptr);

    //! Shows settings without emitting signals.
    void setSettings(const SolveSettings &settings);

Q_SIGNALS:
    //! \param edit applies the change to settings
    void edited(const std::function<void(autocuts::SolveSettings &)> &edit);

private:
    void addChoices(QFormLayout *form);
    void addNumbers(QFormLayout *form);
    //! Emits edited() when the box changes. \param apply writes the data of an item to settings
    void follow(QComboBox *box, void (*apply)(SolveSettings &, int));

    QComboBox *mStart, *mEnergy, *mWeighting, *mSolver;
    QDoubleSpinBox *mBoxWeight;
    QSpinBox *mSeed;
};

} // namespace autocuts
