// The stretch of every triangle, fast enough for a map that changes 30 times a second.
#pragma once

#include "model/plain/meshdata.h"
#include "views/gl/meshframe.h"

#include <limits>
#include <vector>

namespace autocuts {

//! Figures per triangle; NaN for triangles without UVs or without 3D area.
struct TriangleStretch
{
    std::vector<float>
        //! Log2 of (share of the UV area / share of the 3D area); > 0: too large in UV space.
        areaLog2;
    std::vector<float> dirichlet; //!< symmetric Dirichlet energy at the scale that minimises its mean; >= 4
    double scale =
        //! That scale: UVs multiplied by it have the size of the mesh.
        std::numeric_limits<double>::quiet_NaN();
};

//! Measures maps of one mesh, relative to its texel weights. The 3D shapes of the triangles are prepared
//! once.
class StretchMeter
{
public:
    explicit StretchMeter(const MeshData &mesh);

    //! \param uv one row per soup corner \pre it has the size of the mesh
    TriangleStretch measure(const UvMatrix &uv) const;

private:
    //! The shape of a triangle in its own plane, with its longest side along x.
    struct Shape
    {
        int first = 0;            //!< the corner at the origin
        double inverseLength = 0; //!< 1 / length of the longest side; 0: no area
        double foot = 0;          //!< x coordinate of the third corner
        double inverseHeight = 0;
        double area = 0;
        double target = 0; //!< area with sides multiplied by the texel weight, as all lengths here
    };

    static Shape shapeOf(const MeshData &mesh, const MeshFrame &frame, int triangle);

    std::vector<Shape> mShapes;
};

} // namespace autocuts
