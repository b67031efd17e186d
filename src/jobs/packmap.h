// The job that packs the islands of a map: into a tile or rectangle, into a tile for each group, or over
// tiles.
#pragma once

#include "jobs/mapremarks.h"
#include "model/document/scenegroups.h"
#include "model/plain/packingsettings.h"
#include "solver/unwrap/packjob.h"

namespace autocuts::jobs {

//! How islands are divided among tiles.
struct PackChoice
{
    std::vector<SceneGroup> groups{}; //!< each is packed into a tile of its own; empty: all into one
    double density = 0;               //!< texels per unit, in as many tiles as that needs; 0: see above
    bool fillTiles = false;           //!< into the free room of the tiles in use
    int firstTile = PackingSettings::firstTile;
};

struct PackedMap
{
    UvMatrix uv; //!< per corner, texture space; no rows: the map is not changed
    MapRemarks remarks;
};

//! \param charts of the map. Groups divide them \param pack what may move, and where
//! \param uv the map, per corner, texture space
PackedMap packMap(const MeshData &mesh, ChartMap charts, unwrap::PackJob pack, const PackChoice &choice,
                  const UvMatrix &uv, const JobContext &job);

} // namespace autocuts::jobs
