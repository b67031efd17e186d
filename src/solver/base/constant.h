// Tuned constants of the engine. docs/constants.md says what halving and doubling them changes.
#pragma once

#ifndef AUTOCUTS_TUNABLE

//! Declares a constant that scripts/constants varies: AUTOCUTS_CONSTANT(double, gap, 0.1);
#define AUTOCUTS_CONSTANT(type, name, value) constexpr type name = value

#else

#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <type_traits>

namespace autocuts {

//! The factor on a constant that the environment variable AUTOCUTS_CONSTANTS gives, such as
//! "seamrun.firstMu=2,seamsearch.smallPatch=0.5"; 1 where it does not name the constant.
//! \throws std::invalid_argument when the factor is not a number
inline double factorOnConstant(std::string_view file, std::string_view name)
{
    file.remove_prefix(file.find_last_of("/\\") + 1);
    std::string wanted(file.substr(0, file.find('.')));
    wanted.append(".").append(name).append("=");
    const char *variable = std::getenv("AUTOCUTS_CONSTANTS");
    const std::string_view given = variable ? variable : "";
    for (std::size_t at = given.find(wanted); at != given.npos; at = given.find(wanted, at + 1)) {
        if (at == 0 || given[at - 1] == ',')
            return std::stod(std::string(given.substr(at + wanted.size())));
    }
    return 1;
}

//! The value times its factor; a whole number is rounded and stays 1 at least.
template <typename T>
T scaledConstant(T value, std::string_view file, std::string_view name)
{
    const double scaled = factorOnConstant(file, name) * static_cast<double>(value);
    if constexpr (std::is_integral_v<T>)
        return static_cast<T>(std::fmax(1, std::round(scaled)));
    else
        return scaled;
}

} // namespace autocuts

#define AUTOCUTS_CONSTANT(type, name, value)                                                                 \
    const type name = autocuts::scaledConstant<type>(value, __FILE__, #name)

#endif
