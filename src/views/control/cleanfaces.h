// Parts of the map that do not cover themselves, for the tools.
#pragma once

#include "model/plain/meshdata.h"
#include "solver/base/jobcontext.h"

#include <QList>

#include <memory>
#include <vector>

namespace autocuts {

class Document;
class ShownMap;

//! What the search for a part needs of a map, for another thread.
struct MapWithSeams
{
    std::shared_ptr<const MeshData> mesh;
    UvMatrix soupUv;       //!< one row per soup corner
    std::vector<bool> cut; //!< per edge pair

    MapWithSeams(const Document &document, const ShownMap &shownMap);
};

//! A part of an island that nowhere covers itself.
struct CleanPart
{
    QList<int> faces;         //!< in rising order
    bool restIsClean = false; //!< the rest of the island does not cover itself either
};

//! A part around a triangle that nowhere covers itself (paper, figure 9). When its island comes apart in two
//! clean parts, the one with the triangle, so that moving it away leaves no overlap in the island; else the
//! largest region that can be grown around it. Empty when the triangle has no UVs, or when cancelled.
CleanPart cleanPart(const MapWithSeams &map, int triangle, const JobContext &job = {});

} // namespace autocuts
