// Dilated islands as runs of pixels, and the bin as rows of bits.
#pragma once

#include "solver/packing/layout.h"
#include "solver/packing/workmeter.h"

#include <cstdint>

namespace autocuts::packing {

//! Pixels [begin, begin + length) of a row.
struct PixelRun
{
    int row, begin, length;
};

//! An island at one scale and angle, grown by half the gutter. Pixel coordinates start BinRaster::frame
//! pixels left of and below the place where the grown island begins.
struct ItemRaster
{
    double angle = 0;
    std::vector<PixelRun> runs; //!< in bit-reversed order: far apart ones first
    int rows = 0;               //!< rows that have a run, from 0
    Vec2 size = Vec2::Zero();   //!< box of the outline itself, pixels
    Vec2 low = Vec2::Zero();    //!< lower corner of that box relative to the outline's centre, pixels
    double centroidRow = 0;     //!< mean row of its pixels
};

//! \param pixelsPerUnit size of a pixel: outline units times this are pixels
//! \param halfGutter in pixels \param safety added to the radius, pixels; .71 makes disjoint pixels a proof
ItemRaster rasterizeOutline(const Outline &outline, double angle, double pixelsPerUnit, double halfGutter,
                            double safety, WorkMeter &work);

//! Occupied pixels, kept at levels: bit x of level k tells whether any of the pixels x .. x + 2^k - 1 is
//! occupied. A run is free when two such bits are clear, for 64 positions at once.
class BinRaster
{
public:
    static constexpr int frame = 2; //!< free pixels around the bin, so that grown islands may stick out

    //! \param width,height in pixels, without the frame
    BinRaster(int width, int height);

    void clear();
    void occupy(const ItemRaster &item, int x, int y);
    //! Marks the pixels of runs that were rasterised in place; what lies outside the bin is cut off.
    void occupyClipped(const ItemRaster &item, int x, int y);
    //! The first x in 0 .. lastX where the item is free in row y; -1 when there is none.
    int firstFree(const ItemRaster &item, int y, int lastX, WorkMeter &work) const;

    int width() const { return mWidth; }
    int height() const { return mHeight; }
    std::size_t byteCount() const { return mBits.size() * sizeof(std::uint64_t); }

private:
    std::uint64_t *words(int row, int level)
    {
        return mBits.data() + (std::size_t(row) * mLevels + level) * mStride;
    }
    const std::uint64_t *words(int row, int level) const
    {
        return mBits.data() + (std::size_t(row) * mLevels + level) * mStride;
    }
    void setRun(int row, int begin, int end);
    void rebuildLevels(int row);

    int mWidth, mHeight, mRows, mLevels, mStride;
    std::vector<std::uint64_t> mBits;
};

} // namespace autocuts::packing
