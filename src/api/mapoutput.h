// A finished map as callers get it.
#pragma once

#include "api/jobinput.h"
#include "solver/unwrap/unmetsteering.h"

#include <memory>

//! The opaque type of the header.
struct autocuts_map
{
    std::shared_ptr<const autocuts::MeshData> mesh;
    autocuts::UvMatrix uv; //!< texture space
    int textureSize = 0;
    double tileHeight = 1;
    std::vector<double> given; //!< u, v of each corner, as in files
    std::vector<std::int32_t> islands;
    std::vector<std::uint8_t> seams;
    std::size_t islandCount = 0;
    autocuts_outcome outcome{0, 1, 0, 0, 0, 0};
};

namespace autocuts::api {

//! \param uv per corner, texture space
std::unique_ptr<autocuts_map> mapOf(const Snapshot &snapshot, const packing::PackOptions &packing,
                                    UvMatrix uv);

//! Writes down what of the steering the map does not obey.
void setUnmet(const unwrap::UnmetSteering &unmet, autocuts_outcome &outcome);

} // namespace autocuts::api
