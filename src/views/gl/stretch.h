// How much the map stretches every triangle, fast enough for a map that changes 30 times a second.
#pragma once

#include "model/plain/meshdata.h"

#include <limits>
#include <vector>

namespace autocuts {

//! Figures per triangle, not a number where there is none: no UVs, or no area in 3D.
struct TriangleStretch
{
    std::vector<float>
        areaLog2; //!< log2 of share of the UV area / share of the 3D area; > 0: too large in UV
    std::vector<float> dirichlet; //!< symmetric Dirichlet energy at the scale that makes its mean least; >= 4
    double scale =
        std::numeric_limits<double>::quiet_NaN(); //!< that scale: UVs times it have the mesh's size
};

//! Measures maps of one mesh. Shapes of the triangles in 3D are prepared once.
class StretchMeter
{
public:
    explicit StretchMeter(const MeshData &mesh);

    //! \param uv one row per soup corner \pre it fits the mesh
    TriangleStretch measure(const UvMatrix &uv) const;

private:
    //! A triangle in its own plane: its longest side along x.
    struct Shape
    {
        int first = 0;            //!< corner at the origin
        double inverseLength = 0; //!< of the longest side; 0: no area
        double foot = 0;          //!< x of the third corner
        double inverseHeight = 0;
        double area = 0;
    };

    std::vector<Shape> mShapes;
};

} // namespace autocuts
