// Brushes that shape a definite map: what is under them is relaxed, drawn together or moved.
#pragma once

#include "model/plain/csrlist.h"
#include "model/plain/islandflags.h"
#include "solver/base/soup.h"
#include "solver/overlap/movingtriangles.h"

#include <functional>
#include <memory>
#include <vector>

namespace autocuts {
struct UvTopology;
}

namespace autocuts::definite {

//! Where a brush is. Lengths are in texture space.
struct BrushSpot
{
    int triangle = -1; //!< under its centre
    Vec2 centre = Vec2::Zero();
    double radius = 0;
    std::function<double(double distance)> effect; //!< in [0, 1], for distances below the radius
};

//! A map under brushes. A brush works on the island under its centre and does not cross gaps. No step turns a
//! triangle over or brings an overlap: steps are shortened there, or not made. A step costs as much as what
//! is under the brush.
class MapBrush
{
public:
    //! \param uv one row per corner
    //! \param held per corner: does not move
    //! \param faceFlags one per face; islands of one stack may lie on each other
    //! \throws std::invalid_argument when the mesh has no area
    MapBrush(std::shared_ptr<const MeshData> mesh, const UvMatrix &uv, const std::vector<bool> &held,
             const std::vector<IslandFlags> &faceFlags);

    //! Lowers the distortion at the scale that the island had at first. \return true when something moved
    bool relax(const BrushSpot &spot);
    //! Draws points towards the centre. \param amount share of the way at full effect, in [-0.5, 0.5];
    //! negative: away from it \return true when something moved
    bool pinch(const BrushSpot &spot, double amount);
    //! Takes hold of what is under the brush.
    void grab(const BrushSpot &spot);
    //! Moves what was grabbed as far as it can go. \param way displacement from where it was grabbed
    //! \return true when something moved
    bool pull(const Vec2 &way);

    //! The map as it is now, one row per corner.
    const UvMatrix &uv() const { return mUv; }

private:
    //! A point under the brush and the effect on it. A point is a UV vertex.
    struct Reached
    {
        int point = 0;
        double effect = 0;
    };

    void findPoints(const UvTopology &topology, const std::vector<bool> &held);
    void findScales(const UvTopology &topology, const std::vector<IslandFlags> &faceFlags);
    overlap::TrianglePlace placeOf(int triangle) const;
    double areaOf(int triangle) const;
    bool isSound(int triangle) const { return areaOf(triangle) >= mLeastArea[triangle]; }
    double distanceTo(int triangle, const Vec2 &place) const;
    //! The points under a brush that can move, ascending.
    std::vector<Reached> reached(const BrushSpot &spot, bool withBorder);
    std::vector<int> trianglesAt(const std::vector<Reached> &points);
    std::vector<Vec2> placesOf(const std::vector<Reached> &points) const;
    void restore(const std::vector<Reached> &points, const std::vector<Vec2> &before);
    //! Keeps the new places when they bring no overlap; otherwise restores the old ones.
    bool keep(const std::vector<Reached> &points, const std::vector<Vec2> &before);
    template <typename Change>
    bool step(const BrushSpot &spot, Change change);
    //! The energy around a point in solver units. \param gradient, hessian null or what their values are
    //! added to; the Hessian as xx, xy, yy
    double energyAround(int point, Vec2 *gradient, std::array<double, 3> *hessian) const;
    void relaxPoint(const Reached &reached);
    void shorten(const std::vector<Reached> &points, const std::vector<Vec2> &before);
    bool pullTo(const Vec2 &way);

    std::shared_ptr<const MeshData> mMesh;
    std::shared_ptr<const Soup> mSoup;
    UvMatrix mUv;
    std::vector<Vec2> mPoints;
    std::vector<char> mHeld, mBorder;                //!< per point
    CsrList mCornersOf, mTrianglesOf;                //!< per point
    std::vector<std::array<int, 3>> mTrianglePoints; //!< -1 without UVs
    std::vector<int> mChart;                         //!< per triangle; -1 without UVs
    //! Per chart, length in texture space of one solver unit; negative where the chart is mirrored.
    std::vector<double> mScale;
    std::vector<double> mLeastArea; //!< per triangle, of areaOf()
    std::vector<int> mSeen;         //!< per triangle, the last search that has met it
    int mSearch = 0;
    std::unique_ptr<overlap::MovingTriangles> mAll;

    std::vector<Reached> mGrabbed;
    std::vector<Vec2> mGrabbedFrom;
    double mGrabRadius = 0;
    Vec2 mPulled = Vec2::Zero(); //!< displacement of what was grabbed, so far
};

} // namespace autocuts::definite
