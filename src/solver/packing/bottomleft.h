// Bottom-left packing on a raster: the constructive step.
#pragma once

#include "solver/packing/raster.h"

#include <optional>

namespace autocuts::packing {

//! Places islands one after the other, each at the lowest free place over several angles. Keeps the rasters
//! of the scale last used, because a scale is usually tried with several orders.
class BottomLeft
{
public:
    //! \param resolution pixels along the side of a square of the bin's area
    //! \param angles how many turns of an island are tried when rotation is free
    BottomLeft(const PackProblem &problem, int resolution, int angles);

    //! \param order the movable islands, first placed first
    //! \param blend 0: keep the top of each island low; 1: keep its centroid low
    //! \param safety see rasterizeOutline()
    //! \return a layout that has not been tested exactly, or nothing when an island found no place
    std::optional<Layout> pack(double scale, const std::vector<int> &order, double blend, double safety,
                               WorkMeter &work);

    //! Part of the order that the last call to pack() placed.
    double reached() const { return mReached; }

private:
    struct Place
    {
        const ItemRaster *item = nullptr;
        int x = 0, y = 0;
        double score = 0;
    };

    const std::vector<ItemRaster> &rasters(int island, WorkMeter &work);
    std::optional<Place> findPlace(const std::vector<ItemRaster> &items, int firstRow, double blend,
                                   WorkMeter &work) const;
    void occupyLocked(WorkMeter &work);

    const PackProblem &mProblem;
    int mAngles;
    double mPixel; //!< UV units
    double mHalfGutter;
    double mScale = 0, mSafety = -1;
    double mReached = 0;
    BinRaster mBin;
    std::vector<std::vector<ItemRaster>> mRasters;
};

} // namespace autocuts::packing
