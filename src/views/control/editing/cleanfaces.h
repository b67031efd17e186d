// Finds regions of the map without overlaps, for the overlap tool.
#pragma once

#include "model/plain/meshdata.h"
#include "solver/base/jobcontext.h"

#include <QList>

#include <memory>
#include <vector>

namespace autocuts {

class Document;
class ShownMap;

//! A copy of a map and its cuts, for searching regions on another thread.
struct MapWithSeams
{
    std::shared_ptr<const MeshData> mesh;
    UvMatrix soupUv;       //!< one row per soup corner
    std::vector<bool> cut; //!< per edge pair

    MapWithSeams(const Document &document, const ShownMap &shownMap);
};

//! A region of an island that does not overlap itself.
struct CleanPart
{
    QList<int> faces;         //!< ascending
    bool restIsClean = false; //!< the rest of the island does not overlap itself either
};

//! A part around a triangle that nowhere covers itself (paper, figure 9). When its island comes apart in two
//! clean parts, the one with the triangle, so that moving it away leaves no overlap in the island; else the
//! largest region that can be grown around it. Empty when the triangle has no UVs, or when cancelled.
CleanPart cleanPart(const MapWithSeams &map, int triangle, const JobContext &job = {});

} // namespace autocuts
