// Tree of bounding boxes in space that finds the nearest triangle to a point. Plain: no Qt.
#pragma once

#include "model/plain/types.h"

#include <limits>
#include <optional>
#include <vector>

namespace autocuts::transfer {

using Triangle3 = std::array<Vec3, 3>;

//! The point of a triangle that is nearest to another point.
struct NearPoint
{
    int triangle = -1;                                        //!< -1: there is none
    Vec3 weights = Vec3::Zero();                              //!< barycentric, each in [0, 1]
    double squared = std::numeric_limits<double>::infinity(); //!< square of the distance
};

//! The barycentric weights of a point's projection onto the plane of a triangle, each of any size; nothing
//! when the triangle has hardly any area.
std::optional<Vec3> weightsInPlane(const Triangle3 &triangle, const Vec3 &point);
//! The nearest point of a triangle, which may have no area. NearPoint::triangle stays -1.
NearPoint nearestOnTriangle(const Triangle3 &triangle, const Vec3 &point);

//! Triangles, split recursively at the median along the longest side of their box. Answers depend on the
//! triangles and their order only.
class SurfaceTree
{
public:
    SurfaceTree() = default;
    explicit SurfaceTree(std::vector<Triangle3> triangles);

    const Triangle3 &triangle(int index) const { return mTriangles[index]; }
    const Vec3 &normal(int index) const { return mNormals[index]; } //!< unit length; zero without area

    //! The nearest point within a distance.
    NearPoint nearest(const Vec3 &point, double squared = std::numeric_limits<double>::infinity()) const;
    //! The same among the triangles whose normal is less than about 80 degrees from the given one.
    //! \param facing of unit length
    NearPoint nearestFacing(const Vec3 &point, const Vec3 &facing, double squared) const;

private:
    struct Node
    {
        Vec3 low, high;
        int first = 0, count = 0; //!< range in mOrder; count > 0 in leaves only
        int right = 0;            //!< second child; the first one follows its parent directly
    };

    void build(int begin, int end);
    NearPoint search(const Vec3 &point, const Vec3 *facing, double squared) const;

    std::vector<Triangle3> mTriangles;
    std::vector<Vec3> mNormals;
    std::vector<int> mOrder;
    std::vector<Node> mNodes;
};

} // namespace autocuts::transfer
