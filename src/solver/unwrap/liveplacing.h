// Places the charts of a live map in texture space so that they stay where they were.
#pragma once

#include "solver/base/seamedmap.h"
#include "solver/unwrap/freepart.h"
#include "solver/unwrap/packjob.h"

#include <optional>

namespace autocuts::unwrap {

//! Places one map after the other. A chart goes to where its triangles were in the map before, at the texel
//! density that its island or tile had there. Charts that leave their bin or overlap another one are packed
//! into the room that is left, and so are those that come nearer to another one than the margin, or than the
//! islands of the map at the beginning are to each other. Where there is no room, the margin is halved at
//! most twice; then all charts are packed. Islands that the user has dragged stay where they were put, and
//! the others make room; from then on there is no margin to keep.
class LivePlacing
{
public:
    //! Forgets the map before; the next one is placed in relation to the part's own map, if it has one.
    void reset();
    //! Places the next map in relation to this one, which was placed before the last drag.
    //! \param uv per corner of the part
    void returnTo(const FreePart &part, const UvMatrix &uv);
    //! \param map of the part, solver units
    //! \param afresh pack all charts as large as they fit, unless the steering gives the scale
    //! \param dragged soup corners of the whole mesh that the user drags; their islands stay there
    //! \param turns how charts may be turned to where they were
    //! \returns the whole map, one row per corner in texture space; see hadRoom()
    UvMatrix place(const Snapshot &snapshot, const FreePart &part, const Soup &soup, const SeamedMap &map,
                   const packing::PackOptions &options, bool afresh, const std::vector<int> &dragged = {},
                   PackRotation turns = PackRotation::Free);

    //! False when there was no room for all charts of the last map, so that some may overlap.
    bool hadRoom() const { return mHadRoom; }
    //! True when the last map only fits with smaller islands where their size is given: tiles or places are,
    //! or only a part of the map changes.
    bool shrank() const { return mShrank; }

private:
    struct Before
    {
        std::shared_ptr<const MeshData> mesh; //!< of the part
        UvMatrix uv;                          //!< per corner of the part, texture space
        ChartMap charts;
        std::vector<double> scale; //!< per face: length in texture space of one solver unit of the part
    };
    void beginWith(const FreePart &part);
    static Before takenFrom(const FreePart &part, const UvMatrix &uv);
    UvMatrix placeAgain(const Snapshot &snapshot, const FreePart &part, const ChartMap &charts,
                        const UvMatrix &shape, const PackJob &pack, PackRotation turns,
                        const std::vector<bool> &held);
    UvMatrix placedBy(const Before &before, const FreePart &part, const ChartMap &charts,
                      const UvMatrix &shape, PackRotation turns, const std::vector<bool> &held) const;
    void noteDrags(const MeshData &mesh, const ChartMap &charts, const std::vector<int> &corners);

    std::optional<Before> mBefore;
    std::optional<Before> mBegun;  //!< the part's own map, to whose places charts return that fit there
    std::optional<double> mGap;    //!< that islands keep, UV units; see PackJob::gap
    double mMargin = 0;            //!< for which that is; see marginGap()
    std::vector<bool> mPutByHand;  //!< per face of the whole mesh; empty: none
    std::vector<bool> mBeforeDrag; //!< the same before the drag that goes on or was the last one
    bool mDrags = false;
    bool mHadRoom = true;
    bool mShrank = false;
};

} // namespace autocuts::unwrap
