// Repeats an attempt with stiffer and stiffer springs.
#pragma once

namespace autocuts {

//! Calls attempt(stiffness) at most `levels` times, with the stiffness `first` and then ten times the one
//! before, until it returns true.
//! \return false when no attempt returned true
template <class Attempt>
bool climbSprings(double first, int levels, Attempt &&attempt)
{
    double stiffness = first;
    for (int level = 0; level < levels; ++level, stiffness *= 10) {
        if (attempt(stiffness))
            return true;
    }
    return false;
}

} // namespace autocuts
