// What bench_solver prints.
#pragma once

#include "bench/solverbench.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace autocuts::bench {

struct MapReport
{
    double seconds = 0, distortion = 0, seamLength = 0;
};

//! Everything measured on one mesh.
struct MeshReport
{
    std::string mesh;
    int triangles = 0;
    StepCost steps;
    std::vector<std::pair<double, RaceResult>> races; //!< per delta
    std::vector<EditResult> edits;
    std::optional<QualityResult> quality;
    std::optional<MapReport> map;
    //! By the homotopy of the live solver alone, as the paper does it: with the fast and the exact step.
    std::optional<MapReport> soupMap, exactSoupMap;
    double memory = 0; //!< highest of the process until then, MB
};

std::string asText(const MeshReport &report);
std::string asJson(const std::vector<MeshReport> &reports, int threads);

} // namespace autocuts::bench
