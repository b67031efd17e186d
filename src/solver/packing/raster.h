// Rasters for bottom-left packing: dilated islands as runs of pixels, the bin as rows of bits.
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

//! An island at one scale and angle, grown by half the gutter. The origin of its pixel coordinates lies
//! BinRaster::frame pixels left of and below the box of the grown island.
struct ItemRaster
{
    double angle = 0;
    std::vector<PixelRun> runs; //!< in bit-reversed order, so that consecutive runs lie far apart
    int rows = 0;               //!< rows that have a run, from 0
    Vec2 size = Vec2::Zero();   //!< box of the outline itself, pixels
    Vec2 low = Vec2::Zero();    //!< lower corner of that box relative to the outline's centre, pixels
    double centroidRow = 0;     //!< mean row of its pixels
};

//! Draws an outline at an angle and reads its runs.
//! \param pixelsPerUnit pixels per unit of the outline
//! \param halfGutter pixels
//! \param safety pixels, added to half the gutter. From .71 on, half a pixel diagonal, disjoint pixels prove
//! that the gutter is kept; with less the layout has to be tested
ItemRaster rasterizeOutline(const Outline &outline, double angle, double pixelsPerUnit, double halfGutter,
                            double safety, WorkMeter &work);

//! The occupied pixels of the bin at several levels: bit x of level k of a row is set when any of the pixels
//! x .. x + 2^k - 1 is occupied. A run is free when two such bits are clear, which is tested for 64 positions
//! at once.
class BinRaster
{
public:
    static constexpr int frame = 2; //!< pixels around the bin, because grown islands may stick out of it

    //! \param width,height in pixels, without the frame
    BinRaster(int width, int height);

    //! Marks all pixels as free.
    void clear();
    //! Marks the pixels of an item at (x, y) as occupied. \pre the item lies within bin and frame
    void occupy(const ItemRaster &item, int x, int y);
    //! The same for an item that may reach beyond the bin.
    void occupyClipped(const ItemRaster &item, int x, int y);
    //! The first x in 0 .. lastX where the item fits with its lowest row at y; -1 when there is none.
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
