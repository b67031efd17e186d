// Places the charts of a live map in texture space so that they stay where they were.
#pragma once

#include "solver/base/seamedmap.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/packjob.h"

#include <optional>

namespace autocuts::unwrap {

//! Places one map after the other. A chart goes to where its triangles were in the map before, at the same
//! texel density. Charts that leave their bin or overlap another one are packed into the room that is left;
//! all charts are packed where there is none.
class LivePlacing
{
public:
    //! Forgets the map before; the next one is placed in relation to the part's own map, if it has one.
    void reset() { mBefore.reset(); }
    //! Places the next map in relation to this one, which was placed before. \param uv per corner of the part
    void returnTo(const FreePart &part, const UvMatrix &uv);
    //! \param map of the part, solver units
    //! \param afresh pack all charts as large as they fit, unless the steering gives the scale
    //! \param turns how charts may be turned to where they were
    //! \returns the whole map, one row per corner in texture space; see hadRoom()
    UvMatrix place(const Snapshot &snapshot, const FreePart &part, const Soup &soup, const SeamedMap &map,
                   const packing::PackOptions &options, bool afresh, PackRotation turns = PackRotation::Free);

    //! False when there was no room for all charts of the last map, so that some may overlap.
    bool hadRoom() const { return mHadRoom; }

private:
    struct Before
    {
        std::shared_ptr<const MeshData> mesh; //!< of the part
        UvMatrix uv;                          //!< per corner of the part, texture space
        ChartMap charts;
        double scale = 1; //!< length in texture space of one solver unit of the part
    };
    void beginWith(const FreePart &part);
    UvMatrix atOldPlaces(const MeshData &mesh, const ChartMap &charts, const std::vector<bool> &held,
                         const UvMatrix &uv, PackRotation turns) const;

    std::optional<Before> mBefore;
    bool mHadRoom = true;
};

} // namespace autocuts::unwrap
