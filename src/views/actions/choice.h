// Settings with few values, each selected by its own action.
#pragma once

#include "views/actions/actionregistry.h"

#include <cstddef>

namespace autocuts {

//! A value and the checkable action that selects it.
template <typename Value>
struct Choice
{
    const char *id;
    Value value;
};

//! Checks the action of the current value, and no other.
template <typename Value, std::size_t Count>
void showChoice(const ActionRegistry &actions, const Choice<Value> (&choices)[Count], Value current)
{
    for (const auto &[id, value] : choices)
        actions.action(id)->setChecked(value == current);
}

} // namespace autocuts
