// The panel of the live solver.
#pragma once

#include "views/panels/panel.h"

#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QRadioButton;

namespace autocuts {

class ConvergenceGraph;
class SeamPreferenceForm;
class SliderSpin;

//! Runs the solver, sets lambda and delta or the distortion budget, shows the convergence, and finishes the
//! map.
class SolverPanel final : public Panel
{
    Q_OBJECT

public:
    explicit SolverPanel(const StudioContext &context, QWidget *parent = nullptr);

protected:
    void refresh() override;

private:
    QWidget *makeRunButtons();
    void addModeRows(QFormLayout *form);
    void addSliderRows(QFormLayout *form);
    QWidget *makeDeltaRow();
    QWidget *makeReadOut();
    QWidget *makeFinishRow();
    void connectSolver();
    void scaleDelta(double factor);
    void showEnergyBalance(const SolveSettings &settings);
    void showState();
    void showStatus();

    QPushButton *mRun = nullptr, *mStep = nullptr, *mRestart = nullptr;
    QRadioButton *mManual = nullptr, *mBudget = nullptr, *mShowMap = nullptr, *mShowSoup = nullptr;
    QCheckBox *mGhost = nullptr;
    QDoubleSpinBox *mBound = nullptr;
    SliderSpin *mLambda = nullptr, *mDelta = nullptr;
    QPushButton *mHalve = nullptr, *mDouble = nullptr;
    ConvergenceGraph *mGraph = nullptr;
    SeamPreferenceForm *mPreference = nullptr;
    QLabel *mState = nullptr;
    std::vector<QLabel *> mFigures; //!< in the order in which they are shown
    QComboBox *mQuality = nullptr;
    QPushButton *mFinish = nullptr, *mUnwrap = nullptr;
};

} // namespace autocuts
