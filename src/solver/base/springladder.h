// Springs that grow stiffer until points lie where they belong.
#pragma once

namespace autocuts {

//! Calls attempt(stiffness), each time with springs ten times as stiff as before, until it returns true.
//! \return false when none of the attempts did
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
