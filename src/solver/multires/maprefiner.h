// Takes collapses back inside a UV map: no triangle folds, no chart comes to cover itself.
#pragma once

#include "solver/multires/progressivemesh.h"
#include "solver/soup.h"

#include <vector>

namespace autocuts {

//! A map of the present surface of a ProgressiveMesh, refined with it. A point that comes back inside a chart
//! is placed where its triangles are distorted least; one that comes back on a seam or border is placed on
//! the straight side that ran there, on each bank of its own, so that the outlines of the charts stay as they
//! are. That always succeeds up to the precision of numbers: the triangles around the kept point saw all of
//! the polygon already.
class MapRefiner
{
public:
    //! \param scale of the mesh's units to those of the map
    MapRefiner(ProgressiveMesh &mesh, double scale);

    //! UV of corner 3 t + k, and whether a side is cut, on living triangles. To be set before refining.
    std::vector<Vec2> uv;
    std::vector<char> cut;
    //! What a seam costs per length around each point; empty: 1.
    std::vector<double> pointCost;
    //! False when seams must stay where they are.
    bool mayStraighten = true;

    //! Takes collapses back until that many triangles live (or all of them). \returns the number of points
    //! that had to be placed although a triangle folded
    int refineTo(int triangles);

private:
    struct Sector
    {
        int begin, end;         //!< corners of the fan
        bool hasFirst, hasLast; //!< with the triangle that comes back before, behind the fan
    };
    //! A triangle around the point to be placed, counter-clockwise: point, a, b.
    struct Spoke
    {
        Vec2 a, b;
        double length, along,
            height; //!< at rest: a at (0, 0), b at (length, 0), the point at (along, height)
        double area;
    };

    bool refineOne();
    void addSpoke(const Vec3 &p, const Vec3 &a3, const Vec3 &b3, const Vec2 &a, const Vec2 &b);
    double energy(const Vec2 &p, Vec2 *gradient = nullptr) const;
    Vec2 placeInside(const Vec2 &kept, bool &good);
    double placeNear(const Vec2 &kept, bool hasFirst, Vec2 &place) const;
    Vec2 placeOnSide(const Vec2 &kept, const Vec2 &end, double share, bool hasFirst, bool &good);
    void descend(Vec2 &p, double &value, int steps) const;
    void sweep();
    double costOf(int side) const;
    void straighten();
    bool changeBank(int triangle);
    bool sectorOf(int corner);
    double improve(int corner, int steps);
    void makeRoom(int corner);

    ProgressiveMesh &mMesh;
    double mScale;
    std::vector<Sector> mSectors;
    std::vector<Spoke> mSpokes;
    std::vector<int> mAround; //!< corners of a sector
};

} // namespace autocuts
