// A small modeller for the samples: polygons that grow by extrusion, subdivision and simple solids.
#pragma once

#include "model/document/scene.h"
#include "model/plain/types.h"

#include <QString>

#include <functional>
#include <utility>
#include <vector>

namespace autocuts::samples {

//! A place and three directions (unit, right-handed): x and y span a profile, z is the way to go.
struct Frame
{
    Vec3 origin = Vec3::Zero();
    Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

    Vec3 at(double a, double b, double c) const { return origin + a * x + b * y + c * z; }
};

//! A frame at a point whose z points along the given direction.
Frame frameAlong(const Vec3 &origin, const Vec3 &direction);

//! Polygons under construction. Faces are wound outwards; new ones belong to the current object and material.
class PolygonModel
{
public:
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;

    //! Starts an object; faces added from now on belong to it.
    void beginObject(const QString &name);
    //! Faces added from now on have this material.
    void useMaterial(const QString &name);

    int addPoint(const Vec3 &point);
    int addFace(std::vector<int> corners);

    //! Moves a region of faces, leaving a band of quads behind. Its points p become
    //! c + scale * (p - c) + offset (per axis), c being the mean of the region's points.
    void extrude(const std::vector<int> &region, const Vec3 &offset, const Vec3 &scale = Vec3::Ones());

    //! The points around a region of faces, in the winding of the faces.
    //! \pre the region has one simple border
    std::vector<int> border(const std::vector<int> &region) const;

    //! Removes faces; the numbers of later ones move down.
    void removeFaces(std::vector<int> region);

    //! One step of Catmull-Clark subdivision; points without faces go. \pre closed manifold
    void subdivide();

    //! A straight solid over a closed profile (counter-clockwise seen against z), from z = 0 to `height`.
    //! Each end is one polygon; with a bevel > 0 both rims are cut off by that much.
    void addPrism(const Frame &frame, const std::vector<Vec2> &profile, double height, double bevel = 0);

    //! A gear from z = 0 to `height`: straight-sided teeth between two radii. Each end is a disk and a quad
    //! per tooth.
    void addGear(const Frame &frame, int teeth, double inner, double outer, double height, double bevel = 0);

    //! A solid of revolution about z. The profile gives (radius, z) from bottom to top; a radius of 0 at an
    //! end closes it in a fan of triangles, any other end gets one polygon as its cap.
    void addLathe(const Frame &frame, const std::vector<Vec2> &profile, int segments);

    //! A round tube along a path of points, capped by polygons at both ends.
    void addTube(const std::vector<Vec3> &path, double radius, int segments);

    //! The scene of these polygons. \pre every face was added after beginObject()
    Scene toScene() const;

private:
    void dropUnusedPoints();
    //! The sides of a prism; returns its bottom and top rings, counter-clockwise seen against z.
    std::pair<std::vector<int>, std::vector<int>>
    addWalls(const Frame &frame, const std::vector<Vec2> &profile, double height, double bevel);
    std::vector<int> addRing(int segments, const std::function<Vec3(int)> &at);
    void addBand(const std::vector<int> &lower, const std::vector<int> &upper);

    std::vector<QString> mObjects, mMaterials;
    std::vector<int> mFaceObject, mFaceMaterial;
    int mObject = -1, mMaterial = -1;
};

} // namespace autocuts::samples
