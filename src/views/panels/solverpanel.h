// The panel that makes maps: Unwrap, the live solve and their settings.
#pragma once

#include "views/panels/panel.h"

#include <functional>
#include <vector>

class QCheckBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QRadioButton;

namespace autocuts {

class ConvergenceGraph;
class FoldSection;
class Questions;
class SeamPreferenceForm;
class SliderSpin;
class SolverSettingsForm;
class UnwrapForm;

//! Unwraps and runs the live solve. On top what most maps need; lambda, delta, the convergence and all other
//! settings are folded away, unless the user chooses lambda and delta by hand.
class SolverPanel final : public Panel
{
    Q_OBJECT

public:
    SolverPanel(const StudioContext &context, Questions &questions, QWidget *parent = nullptr);

Q_SIGNALS:
    //! \param message translated, one line, for the status bar
    void said(const QString &message);

protected:
    void refresh() override;

private:
    QWidget *makeUnwrapForm();
    QWidget *makePresets(Questions &questions);
    QWidget *makeOutcomeRow();
    QWidget *makeRunButtons();
    QWidget *makeAdvanced();
    void addModeRows(QFormLayout *form);
    void addSliderRows(QFormLayout *form);
    QWidget *makeDeltaRow();
    QWidget *makeReadOut();
    void connectSolver();
    void takeOverByHand();
    void applyEdit(const std::function<void(SolveSettings &)> &edit, bool first);
    void scaleDelta(double factor);
    void showEnergyBalance(const SolveSettings &settings);
    void showState();
    void showStatus();
    void showOutcome(const SolveSettings &settings);

    QPushButton *mRun = nullptr, *mStep = nullptr, *mRestart = nullptr;
    QRadioButton *mManual = nullptr, *mBudget = nullptr, *mShowMap = nullptr, *mShowSoup = nullptr;
    QCheckBox *mGhost = nullptr;
    SliderSpin *mLambda = nullptr, *mDelta = nullptr;
    QPushButton *mHalve = nullptr, *mDouble = nullptr;
    ConvergenceGraph *mGraph = nullptr;
    SeamPreferenceForm *mPreference = nullptr;
    QLabel *mState = nullptr;
    std::vector<QLabel *> mFigures; //!< in the order in which they are shown
    UnwrapForm *mUnwrap = nullptr;
    FoldSection *mAdvanced = nullptr;
    SolverSettingsForm *mSettings = nullptr;
    QPushButton *mFinish = nullptr, *mNext = nullptr;
    QLabel *mOutcome = nullptr;
    const char *mNextAction = "";
    bool mWasManual = false;
};

} // namespace autocuts
