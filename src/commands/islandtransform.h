// Moving, rotating and scaling islands by one gesture.
#pragma once

#include "commands/setuvs.h"
#include "model/document/arrangement.h"

#include <functional>

namespace autocuts {

//! Remembers the islands as they are when the gesture begins, so that each step is computed from there: no
//! rounding adds up, and a gesture that returns to its start leaves no entry. Locked islands stay where they
//! are; pins on the others travel along.
class IslandTransform
{
public:
    //! \param edit Move, Rotate or Scale
    //! \param islands numbers of Document::islands(), in any order
    IslandTransform(Document &document, UvEdit edit, const std::vector<int> &islands);

    //! False when every island is locked.
    bool canMove() const { return !mCorners.empty(); }
    //! Number of the gesture, for cancelGesture().
    quint64 gesture() const { return mGesture; }
    //! The command that brings the islands from where they are now to where the whole gesture has them.
    //! \param transform from the UVs at the beginning, in texture space
    std::unique_ptr<SetUvs> command(const Eigen::Affine2d &transform) const;
    //! The same with a transform for each island. \param transformOf asked for islands that are not locked
    std::unique_ptr<SetUvs> command(const std::function<Eigen::Affine2d(int island)> &transformOf) const;

private:
    Document &mDocument;
    UvEdit mEdit;
    quint64 mGesture;
    std::vector<int> mIslands; //!< that are not locked
    std::vector<int> mCorners;
    std::vector<int> mOwner;  //!< per item of mCorners: place in mIslands
    UvMatrix mStart;          //!< one row per item of mCorners
    std::vector<UvPin> mPins; //!< at the beginning
    std::vector<int> mPinOwner;
};

//! The command that moves pieces, each with its islands and pins; locked ones stay.
//! \param transforms one per piece, texture space
std::unique_ptr<SetUvs> movePieces(Document &document, UvEdit edit, std::span<const IslandPiece> pieces,
                                   std::span<const Eigen::Affine2d> transforms);

} // namespace autocuts
