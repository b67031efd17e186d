#include "views/control/live/energygain.h"

#include "views/control/live/solvercontroller.h"

#include <QCoreApplication>

#include <cmath>

namespace autocuts {

namespace {

//! Translation context of the texts.
struct Gain
{
    Q_DECLARE_TR_FUNCTIONS(EnergyGain)
};

} // namespace

void EnergyGain::begin(const SolverController &solver)
{
    mStart.reset();
    if (solver.isRunning() && solver.status().iteration > 0)
        mStart = solver.status();
}

QString EnergyGain::text(const SolverController &solver) const
{
    const live::SolveStatus &now = solver.status();
    if (!mStart || now.iteration < mStart->iteration)
        return {};
    const QString rest =
        Gain::tr("D %1 \u2192 %2").arg(mStart->distortion, 0, 'f', 3).arg(now.distortion, 0, 'f', 3);
    if (now.lambda != mStart->lambda || now.delta != mStart->delta || !(std::abs(mStart->energy) > 0))
        return Gain::tr("Since the edit: %1").arg(rest);
    const double saved = mStart->energy - now.energy;
    const QString amount = saved >= 0 ? Gain::tr("Energy saved since the edit: %1 (%2 %)")
                                      : Gain::tr("Energy added by the edit: %1 (%2 %)");
    return amount.arg(std::abs(saved), 0, 'g', 3).arg(std::abs(100 * saved / mStart->energy), 0, 'f', 1) +
           QStringLiteral(", ") + rest;
}

} // namespace autocuts
