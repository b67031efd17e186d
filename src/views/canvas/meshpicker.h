// Picking in the 3D view.
#pragma once

#include "views/canvas/orbitcamera.h"
#include "views/canvas/picking.h"
#include "views/gl/meshframe.h"
#include "views/gl/souptopology.h"

#include <memory>
#include <vector>

namespace autocuts {

//! Finds in double precision what a camera shows at a point. Tests all triangles: about 2 ms for 100,000.
class MeshPicker final
{
public:
    //! \param hidden per face: it is not there; empty: none is hidden
    MeshPicker(std::shared_ptr<const MeshData> mesh, const MeshFrame &frame, const SoupTopology &topology,
               const std::vector<bool> &hidden = {});

    //! \param through edges and vertices that the model hides are picked, too
    PickResult pick(const OrbitCamera &camera, const QPointF &pixel, bool through = false) const;
    //! \param through elements that the model hides are included
    BoxPick pickBox(const OrbitCamera &camera, const PickRegion &region, bool through = false) const;
    //! All triangles at a point, the front-most first.
    std::vector<int> trianglesAt(const OrbitCamera &camera, const QPointF &pixel) const;

private:
    struct Projection;
    struct Hit
    {
        int triangle = -1;
        double distance = 0; //!< along the ray
    };
    struct Candidate
    {
        double distance = 0; //!< from the mouse, in pixels
        int soup = -1;       //!< index of the side or soup corner
        QPointF place;       //!< on the screen
        double depth = 0;
    };

    Projection project(const OrbitCamera &camera) const;
    Projection projectNear(const OrbitCamera &camera, const QPointF &pixel) const;
    std::vector<Hit> hits(const OrbitCamera &camera, const Projection &seen, const QPointF &pixel) const;
    Hit cast(const OrbitCamera &camera, const Projection &seen, const QPointF &pixel) const;
    bool isVisible(const OrbitCamera &camera, const Projection &seen, const Candidate &candidate) const;
    int firstVisible(const OrbitCamera &camera, const Projection &seen, std::vector<Candidate> candidates,
                     int preferredTriangle, bool through) const;
    void collect(const OrbitCamera &camera, const Projection &seen, const QPointF &pixel,
                 std::vector<Candidate> &sides, std::vector<Candidate> &corners) const;
    bool isHiddenFace(int face) const { return mHidden[*mMesh->trianglesOf(face).begin()]; }
    Vec3 faceCentre(int face) const;
    int vertex(int soupCorner) const { return mVertices[soupCorner / 3][soupCorner % 3]; }

    std::shared_ptr<const MeshData> mMesh;
    const SoupTopology &mTopology;
    PositionMatrix mPoints;                    //!< of the vertices, in the mesh frame
    std::vector<std::array<int, 3>> mVertices; //!< of each triangle
    std::vector<bool> mHidden;                 //!< per triangle
};

} // namespace autocuts
