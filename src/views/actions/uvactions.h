// The UV menu.
#pragma once

#include "commands/setislandflags.h"
#include "commands/setseamstate.h"
#include "model/plain/solvesettings.h"
#include "views/control/session/studiocontext.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace autocuts {

//! Connects the UV menu to the live solver, the jobs on whole maps and the steering commands.
class UvActions final : public QObject
{
    Q_OBJECT

public:
    static constexpr double lambdaStep = 0.05;
    static constexpr double minDelta = 1e-6, maxDelta = 1e6;

    explicit UvActions(const StudioContext &context, QObject *parent = nullptr);

private:
    void connectSolver();
    void connectJobs();
    void connectSteering();
    template <typename Function>
    void onTriggered(const char *id, Function function);
    //! Connects a checkable action that sets one field of the settings.
    template <typename Value>
    void connectSetting(const char *id, Value SolveSettings::*field, Value value);

    void changeLambda(double change);
    void changeDelta(double factor);
    SolveSettings settingsInEffect() const;
    void setByHand(const SolveSettings &settings);
    void takeUpHistory();
    void pushTyped(const SolveSettings &settings);
    void keepStraight(bool on);
    void setSeams(SetSeamState::Edit edit, const QList<int> &edges);
    void setFlags(SetIslandFlags::Edit edit);
    void pinSelected();
    void unpinSelected();
    void showState();

    StudioContext mContext;
    QTimer mTyping; //!< runs while repeated presses of a key belong to one entry
    quint64 mTypedGesture = 0;
    int mTypedIndex = -1; //!< index of the undo stack after the last press
    //! Index of the undo stack at which lambda and delta were left to the solver, before a press of a key;
    //! empty: they were not, or the user has chosen the mode since.
    std::optional<int> mAutomaticUntil;
};

} // namespace autocuts
