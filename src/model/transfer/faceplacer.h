// Finds the ways to lay a face into the map of another surface. Plain: no Qt.
#pragma once

#include "model/transfer/mapmender.h"
#include "model/transfer/sourcesurface.h"

#include <vector>

namespace autocuts::transfer {

//! A face in one connected part of the source's map.
struct FacePlacing
{
    std::vector<Vec2> uv;         //!< per corner: that of the nearest point of the part
    std::vector<Vec2> continued;  //!< per corner: by the linear map there, which goes on beyond the border
    std::vector<double> distance; //!< per corner: from the part
    int seed = -1;                //!< a triangle of the part
    double beyond = 0; //!< how much farther the corners are from this part than from the nearest one
    SourceShape shape; //!< at the face's centre, as the face is turned
};

//! Places the faces of a mesh. Not for use by several threads at once.
class FacePlacer
{
public:
    FacePlacer(const SourceSurface &source, const MeshData &mesh, const Frame &frame);

    //! The ways to place a face, that of its centre first; none when the surface is beyond matchReach. Faces
    //! away from the source's seams have one.
    //! \param seeds triangles of the source: the parts around them are tried too
    std::vector<FacePlacing> placings(int face, const std::vector<int> &seeds = {});
    //! The distance of the last face's centre from the surface; infinite when the surface is empty.
    double centreDistance() const { return mCentreDistance; }

    const PositionMatrix &positions() const { return mPositions; } //!< of the vertices, in the frame
    Vec3 position(int corner) const { return mPositions.row(mMesh.cornerVertex[corner]); }

private:
    struct Spot
    {
        NearPoint near;
        bool facesAway = false;
    };

    void findVertexNormals();
    Spot spotOf(const Vec3 &point) const;
    bool growPatch(int first, std::size_t begin);
    Spot centreIn(std::size_t begin) const;
    FacePlacing placing(const Spot &spot, std::size_t begin) const;

    const SourceSurface &mSource;
    const MeshData &mMesh;
    PositionMatrix mPositions; //!< in the frame
    std::vector<Vec3> mFaceNormals;
    std::vector<Vec3> mVertexNormals; //!< of welded vertices; zero where the faces around disagree
    // Of the present face.
    int mFace = 0;
    Vec3 mCentre = Vec3::Zero();
    double mRadius = 0, mReach = 0, mCentreDistance = 0;
    std::vector<int> mSeen; //!< per triangle of the source: number of the last face whose patch holds it
    int mMark = 0;
    std::vector<int> mPatch; //!< the patches of the present face, one after the other
};

} // namespace autocuts::transfer
