// Arranging UV islands as rigid pieces: aligning, distributing, mirroring, turning, scattering.
//
// A *piece* is one island, or all islands of one group or stack. The functions return one affine map of
// texture space per piece; the caller decides what to do with locked pieces.
#pragma once

#include "model/document/islands.h"

#include <span>
#include <vector>

namespace autocuts {

//! A piece: one island, or the islands of one group or one stack, which keep their arrangement.
struct IslandPiece
{
    std::vector<int> islands; //!< ascending
    Eigen::AlignedBox2d box;
    bool locked = false; //!< at least one of the islands is locked
};

//! The pieces that the given islands belong to, ordered by their lowest islands. A piece contains all of its
//! islands, also those that were not given.
std::vector<IslandPiece> islandPieces(const Islands &islands, const IslandMarks &marks,
                                      const std::vector<int> &given);

enum class AlignTo { Left, Right, Bottom, Top, CentreU, CentreV };

//! Moves each piece to one side, or to the middle, of the box around all pieces; when some are locked, of the
//! box around the locked ones. A single piece is aligned in the texture tile that contains its centre.
//! \param tileHeight of the texture, see PackingSettings::tileHeight()
std::vector<Eigen::Affine2d> alignedPieces(std::span<const IslandPiece> pieces, AlignTo to,
                                           double tileHeight);

enum class Distribute { CentresU, CentresV, GapsU, GapsV };

//! Moves the pieces between the first and the last one so that their centres, or the gaps between them, are
//! evenly spaced along one axis. Fewer than three pieces are not moved.
std::vector<Eigen::Affine2d> distributedPieces(std::span<const IslandPiece> pieces, Distribute distribute);

//! Mirrors a piece about the centre of its box. \param axis 0: swaps left and right, 1: swaps top and bottom
Eigen::Affine2d mirroredPiece(const IslandPiece &piece, int axis);

//! Turns about a point. \param angle radians, counter-clockwise; multiples of a quarter turn are exact
Eigen::Affine2d turnedAbout(const Vec2 &point, double angle);
//! Scales about a point. \param factor along each axis, above 0
Eigen::Affine2d scaledAbout(const Vec2 &point, const Vec2 &factor);
//! Turns a piece about the centre of its box. \param angle as above
Eigen::Affine2d turnedPiece(const IslandPiece &piece, double angle);

//! Moves and scales all pieces together so that they are as large as the tile allows that contains the centre
//! of their box. \param border left free along the sides of the tile, texture space, below half of
//! the shorter side \param tileHeight as above
Eigen::Affine2d fittedIntoTile(std::span<const IslandPiece> pieces, double border, double tileHeight);

//! The smallest turn, at most 45 degrees either way, that aligns the smallest box around the points with the
//! axes. Points that are not finite are ignored. \returns radians; 0 when the points have no extent
double turnToSmallestBox(std::span<const Vec2> points);
//! The smallest turn, in radians, that best aligns the directions with the axes. Directions count by their
//! lengths.
double turnToDirections(std::span<const Vec2> directions);

//! How far pieces are scattered; each value is drawn evenly from a range on both sides of zero.
struct ScatterRanges
{
    double move = 0;  //!< texture space, largest distance along each axis
    double angle = 0; //!< radians, largest angle
    double scale = 0; //!< scale factors lie between 1 / (1 + scale) and 1 + scale
    unsigned seed = 1;

    bool operator==(const ScatterRanges &) const = default;
};

//! Moves, turns and scales every piece at random. The same input gives the same result, and the result of a
//! piece does not depend on the other pieces.
std::vector<Eigen::Affine2d> scatteredPieces(std::span<const IslandPiece> pieces,
                                             const ScatterRanges &ranges);

} // namespace autocuts
