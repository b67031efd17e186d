// Bottom-left packing on a raster: builds a layout from nothing.
#pragma once

#include "solver/packing/raster.h"

#include <optional>

namespace autocuts::packing {

//! Places islands one after the other, each at the lowest free position over several angles. Keeps the
//! rasters of the scale and safety last used, because one scale is usually tried with several orders.
class BottomLeft
{
public:
    //! \param resolution pixels along the side of a square with the bin's area
    //! \param angles number of angles that are tried for an island when rotation is free
    BottomLeft(const PackProblem &problem, int resolution, int angles);

    //! \param scale UV units per unit of the outlines
    //! \param order the movable islands in the order of placement
    //! \param blend 0: the top of each island is kept low; 1: its centroid; between: a weighted mean
    //! \param safety see rasterizeOutline()
    //! \return a layout that still needs the exact test, or nothing when an island did not fit
    std::optional<Layout> pack(double scale, const std::vector<int> &order, double blend, double safety,
                               WorkMeter &work);

    //! Share of the islands that the last call of pack() placed.
    double reached() const { return mReached; }

private:
    struct Place
    {
        const ItemRaster *item = nullptr;
        int x = 0, y = 0; //!< pixels
        double score = 0; //!< less is better
    };

    const std::vector<ItemRaster> &rasters(int island, WorkMeter &work);
    std::optional<Place> findPlace(const std::vector<ItemRaster> &items, int firstRow, double blend,
                                   WorkMeter &work) const;
    void occupyLocked(WorkMeter &work);

    const PackProblem &mProblem;
    int mAngles;
    double mPixel;      //!< UV units
    double mHalfGutter; //!< pixels
    double mScale = 0, mSafety = -1;
    double mReached = 0;
    BinRaster mBin;
    std::vector<std::vector<ItemRaster>> mRasters; //!< per island, one raster per angle; empty until needed
};

} // namespace autocuts::packing
