// Command line of bench_solver.
#pragma once

#include "solver/unwrap/unwrap.h"

#include <optional>
#include <string>
#include <vector>

namespace autocuts::bench {

using namespace unwrap;

inline constexpr const char *usage =
    "usage: bench_solver MESH... [--threads N] [--json] [--subdivide N] [--no-exact] [--steps-only]\n"
    "                    [--map draft|standard|best] [--quality]\n";

struct Options
{
    std::vector<std::string> files;
    int threads = 1;
    int subdivisions = 0; //!< each makes four triangles of one
    bool json = false;
    bool exact = true; //!< compare with the exact solver
    bool stepsOnly = false;
    bool quality = false;             //!< only compare the ends of the whole schedule
    std::optional<UnwrapQuality> map; //!< also make a whole map
};

//! Nothing, and what is wrong in `problem`, when the arguments cannot be understood.
std::optional<Options> readOptions(const std::vector<std::string> &arguments, std::string &problem);

} // namespace autocuts::bench
