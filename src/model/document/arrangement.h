// Laying out islands as whole pieces: aligning, distributing, mirroring, turning, scattering.
//
// All of it gives affine maps of texture space, one per piece; what is locked is left to who applies them.
#pragma once

#include "model/document/islands.h"

#include <span>
#include <vector>

namespace autocuts {

//! An island, or the islands of one group or one stack: what keeps its arrangement.
struct IslandPiece
{
    std::vector<int> islands; //!< rising
    Eigen::AlignedBox2d box;
    bool locked = false; //!< one of the islands is
};

//! The pieces that the given islands belong to, by their lowest islands. A piece has all its islands, given
//! or not.
std::vector<IslandPiece> islandPieces(const Islands &islands, const IslandMarks &marks,
                                      const std::vector<int> &given);

enum class AlignTo { Left, Right, Bottom, Top, CentreU, CentreV };

//! Moves each piece to the side, or the middle, of the box around all of them; of the locked ones when there
//! are any. A piece alone is aligned in the tile of the texture that its middle lies in.
std::vector<Eigen::Affine2d> alignedPieces(std::span<const IslandPiece> pieces, AlignTo to);

enum class Distribute { CentresU, CentresV, GapsU, GapsV };

//! Moves the pieces between the first and the last one so that their middles, or the gaps between them, are
//! equal along one axis. Fewer than three pieces stay.
std::vector<Eigen::Affine2d> distributedPieces(std::span<const IslandPiece> pieces, Distribute distribute);

//! Turns over about the middle of the box. \param axis 0: left becomes right, 1: top becomes bottom
Eigen::Affine2d mirroredPiece(const IslandPiece &piece, int axis);

//! A turn about the middle of the box. \param angle radians, counter-clockwise; multiples of a quarter turn
//! are exact
Eigen::Affine2d turnedPiece(const IslandPiece &piece, double angle);

//! The smallest turn, within 45 degrees, that brings the smallest box around the points to the axes.
//! Points that are not finite do not count. \returns radians; 0 when the points have no extent
double turnToSmallestBox(std::span<const Vec2> points);
//! The smallest turn that brings the directions, by their lengths and as a whole, to the axes.
double turnToDirections(std::span<const Vec2> directions);

//! How far pieces are scattered; each value is drawn evenly from both sides of where the piece is.
struct ScatterRanges
{
    double move = 0;  //!< texture space, along each axis
    double angle = 0; //!< radians
    double scale = 0; //!< factors are from 1 / (1 + scale) to 1 + scale
    unsigned seed = 1;

    bool operator==(const ScatterRanges &) const = default;
};

//! Moves, turns and scales every piece at random. The same input gives the same result, and what one piece
//! gets does not depend on which others there are.
std::vector<Eigen::Affine2d> scatteredPieces(std::span<const IslandPiece> pieces,
                                             const ScatterRanges &ranges);

} // namespace autocuts
