// Finds how groups of faces, such as islands or connected parts, match copies of themselves. Plain: no Qt.
#pragma once

#include "model/plain/meshadjacency.h"

#include <cstdint>
#include <vector>

namespace autocuts {

//! By how much the 3D side lengths of copies may differ.
enum class CopyLikeness {
    Exact, //!< by 1e-4 of the longest one
    Near   //!< each by 5 %
};

//! Matches groups of faces of one mesh. Copies have the same polygons, connected in the same way, with the
//! same 3D side lengths. For use by one thread.
class CopyMatcher
{
public:
    //! All arguments must outlive the matcher.
    //! \param groupOfFace per face; -1: in none \param faces of each group, ascending
    CopyMatcher(const MeshData &mesh, const MeshAdjacency &adjacency, const std::vector<int> &groupOfFace,
                const std::vector<std::vector<int>> &faces);

    //! Colours of the faces of a group, in their order: equal for faces with the same neighbourhoods within
    //! their groups, also in mirrored copies.
    std::vector<std::uint64_t> colours(int group);
    //! The lengths of all polygon sides of a group, ascending.
    std::vector<double> sideLengths(int group) const;
    //! True when two lists of sideLengths() are those of copies.
    static bool sameLengths(const std::vector<double> &a, const std::vector<double> &b,
                            CopyLikeness likeness = CopyLikeness::Exact);

    //! Matches the faces of `to` with those of `from`. \param mirrored the polygons of a copy run the other
    //! way round \param fromColours of `from` \param toColours of `to` \returns false when it is no such copy
    bool match(int from, int to, bool mirrored, const std::vector<std::uint64_t> &fromColours,
               const std::vector<std::uint64_t> &toColours, CopyLikeness likeness = CopyLikeness::Exact);
    //! After a match: the corner of `from` that matches a corner of `to`.
    int sourceCorner(int corner) const { return mSource[corner]; }
    //! After a match: the corner of `from` whose polygon side matches that from this corner of `to` on.
    int sourceSide(int corner) const;

private:
    bool follow(int first, int source);
    bool layFace(int corner, int source);
    bool cross(int corner);
    int across(int corner, int group) const;
    int further(int corner, int steps) const;
    double length(int corner, int steps) const;

    const MeshData &mMesh;
    const MeshAdjacency &mAdjacency;
    const std::vector<int> &mGroupOfFace;
    const std::vector<std::vector<int>> &mFaces;
    std::vector<std::uint64_t> mColour; //!< per face; scratch
    int mFrom = 0, mTo = 0, mStep = 1;  //!< -1: along mirrored polygons
    CopyLikeness mLikeness = CopyLikeness::Exact;
    double mLongest = 0;      //!< side of `from`
    std::vector<int> mSource; //!< per corner
    std::vector<bool> mUsed;  //!< per face of `from`
    std::vector<int> mQueue;  //!< faces of `to` that have been matched
};

} // namespace autocuts
