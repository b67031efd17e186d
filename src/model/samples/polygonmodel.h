// A small polygon modeller for the samples: extrusion, subdivision and simple solids.
#pragma once

#include "model/document/scene.h"
#include "model/plain/types.h"

#include <QString>

#include <functional>
#include <utility>
#include <vector>

namespace autocuts::samples {

//! A point and three unit directions (right-handed): x and y span a profile, z is the direction of extrusion.
struct Frame
{
    Vec3 origin = Vec3::Zero();
    Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();

    Vec3 at(double a, double b, double c) const { return origin + a * x + b * y + c * z; }
};

//! A frame at a point whose z points along the given direction.
Frame frameAlong(const Vec3 &origin, const Vec3 &direction);

//! Polygons under construction. Faces point outwards; new ones belong to the current object and material.
class PolygonModel
{
public:
    std::vector<Vec3> points;
    std::vector<std::vector<int>> faces;

    //! Starts an object; faces added later belong to it.
    void beginObject(const QString &name);
    //! Sets the material of faces added later.
    void useMaterial(const QString &name);

    int addPoint(const Vec3 &point);
    int addFace(std::vector<int> corners);

    //! Moves a set of faces and adds a band of quads around it. A point p moves to c + scale * (p - c) +
    //! offset (per axis), where c is the mean of the points of the set.
    void extrude(const std::vector<int> &region, const Vec3 &offset, const Vec3 &scale = Vec3::Ones());

    //! The points around a set of faces, in the winding of the faces.
    //! \pre the set has one simple border
    std::vector<int> border(const std::vector<int> &region) const;

    //! Removes faces; the indices of later ones decrease.
    void removeFaces(std::vector<int> region);

    //! One step of Catmull-Clark subdivision; removes points without faces. \pre closed manifold
    void subdivide();

    //! Adds a prism over a closed profile (counter-clockwise seen against z), from z = 0 to `height`. Each
    //! end is one polygon; a positive bevel cuts off the edges of both ends by that length.
    void addPrism(const Frame &frame, const std::vector<Vec2> &profile, double height, double bevel = 0);

    //! Adds a gear from z = 0 to `height`, with straight teeth between two radii. Each end is a disk and one
    //! quad per tooth.
    void addGear(const Frame &frame, int teeth, double inner, double outer, double height, double bevel = 0);

    //! Adds a solid of revolution about z. The profile gives (radius, z) from bottom to top. An end with
    //! radius 0 is closed by a fan of triangles, any other end by one polygon.
    void addLathe(const Frame &frame, const std::vector<Vec2> &profile, int segments);

    //! Adds a round tube along a path of points, closed by a polygon at each end.
    void addTube(const std::vector<Vec3> &path, double radius, int segments);

    //! Makes a scene of these polygons. \pre every face was added after beginObject()
    Scene toScene() const;

private:
    void dropUnusedPoints();
    //! Adds the sides of a prism; returns its bottom and top rings, counter-clockwise seen against z.
    std::pair<std::vector<int>, std::vector<int>>
    addWalls(const Frame &frame, const std::vector<Vec2> &profile, double height, double bevel);
    std::vector<int> addRing(int segments, const std::function<Vec3(int)> &at);
    void addBand(const std::vector<int> &lower, const std::vector<int> &upper);

    std::vector<QString> mObjects, mMaterials;
    std::vector<int> mFaceObject, mFaceMaterial;
    int mObject = -1, mMaterial = -1;
};

} // namespace autocuts::samples
