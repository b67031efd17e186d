// Measures what an edit of the steering has gained while the solver runs.
#pragma once

#include "views/control/live/solvercontroller.h"

#include <QString>

#include <optional>

namespace autocuts {

//! Stores the figures of a solve at an edit and compares them with the current ones.
class EnergyGain final
{
public:
    //! Call it at an edit. Replaces the stored figures; stores nothing when no solve runs.
    void begin(const SolverController &solver);
    void clear() { mStart.reset(); }
    //! One translated line: the energy saved and the change of the distortion D. Empty when nothing is stored
    //! or another solve runs. Energies with different lambda or delta cannot be compared; when the distortion
    //! budget has changed these, the line gives the distortion only.
    QString text(const SolverController &solver) const;

private:
    std::optional<live::SolveStatus> mStart;
};

} // namespace autocuts
