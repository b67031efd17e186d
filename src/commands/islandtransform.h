// Moves, rotates and scales islands in one gesture.
#pragma once

#include "commands/setuvs.h"
#include "model/editing/arrangement.h"

#include <functional>

namespace autocuts {

//! Stores the islands at the beginning of a gesture and computes each step from there. Rounding errors
//! therefore do not accumulate, and a gesture that returns to its start leaves no entry. Locked islands are
//! not moved; pins on other islands move with them. Islands that are turned by anything but right angles do
//! not count as aligned any more.
class IslandTransform
{
public:
    //! \param edit Move, Rotate or Scale
    //! \param islands indices in Document::islands(), in any order
    IslandTransform(Document &document, UvEdit edit, const std::vector<int> &islands);

    //! False when all islands are locked.
    bool canMove() const { return !mCorners.empty(); }
    //! Number of the gesture, for cancelGesture().
    quint64 gesture() const { return mGesture; }
    //! The command that moves the islands from their current to their new places.
    //! \param transform of the whole gesture, from the UVs at its beginning, in texture space
    std::unique_ptr<SetUvs> command(const Eigen::Affine2d &transform) const;
    //! The same with one transform per island. \param transformOf called for islands that are not locked
    std::unique_ptr<SetUvs> command(const std::function<Eigen::Affine2d(int island)> &transformOf) const;

private:
    Document &mDocument;
    UvEdit mEdit;
    quint64 mGesture;
    std::vector<int> mIslands; //!< without the locked ones
    std::vector<int> mCorners;
    std::vector<int> mOwner;  //!< for each item of mCorners, its position in mIslands
    UvMatrix mStart;          //!< one row per item of mCorners
    std::vector<UvPin> mPins; //!< as they were at the beginning
    std::vector<int> mPinOwner;
    std::vector<IslandFlags> mFlags; //!< of all faces at the beginning; empty when no island is aligned
};

//! The command that moves pieces with their islands and pins. Locked pieces are not moved.
//! \param transforms one per piece, in texture space
std::unique_ptr<SetUvs> movePieces(Document &document, UvEdit edit, std::span<const IslandPiece> pieces,
                                   std::span<const Eigen::Affine2d> transforms);

} // namespace autocuts
