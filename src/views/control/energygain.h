// What an edit of the steering has brought so far while the solver runs.
#pragma once

#include "views/control/solvercontroller.h"

#include <QString>

#include <optional>

namespace autocuts {

//! Remembers where a solve was at an edit and compares.
class EnergyGain final
{
public:
    //! An edit was made. Forgets the one before; nothing is remembered when nothing runs.
    void begin(const SolverController &solver);
    void clear() { mStart.reset(); }
    //! One translated line: the energy saved and what became of the distortion D; empty when nothing is
    //! remembered or the solve is another one. Energies of different lambda or delta, which the distortion
    //! budget chooses, cannot be compared: then only the latter.
    QString text(const SolverController &solver) const;

private:
    std::optional<live::SolveStatus> mStart;
};

} // namespace autocuts
