// Tree of bounding boxes in space that tells whether a ray meets a mesh.
#pragma once

#include "model/plain/meshdata.h"

#include <vector>

namespace autocuts::preference {

//! The triangles of a mesh, split recursively at the median along the longest side of their box.
class RayTree
{
public:
    explicit RayTree(const MeshData &mesh);

    //! True when a ray meets a triangle from either side.
    //! \param direction need not have unit length
    bool isHit(const Vec3 &from, const Vec3 &direction) const;
    //! Diagonal of the bounding box of the mesh.
    double size() const { return mNodes.empty() ? 0 : (mNodes[0].high - mNodes[0].low).norm(); }

private:
    struct Node
    {
        Vec3 low, high;
        int first = 0, count = 0; //!< range in mTriangles; count > 0 in leaves only
        int right = 0;            //!< second child; the first one follows its parent directly
    };
    struct Triangle
    {
        Vec3 corner, toSecond, toThird;
        Vec3 middle() const { return 3 * corner + toSecond + toThird; } //!< three times the centroid
    };

    void build(int begin, int end);
    static bool meets(const Triangle &triangle, const Vec3 &from, const Vec3 &direction);

    std::vector<Triangle> mTriangles;
    std::vector<Node> mNodes;
};

} // namespace autocuts::preference
