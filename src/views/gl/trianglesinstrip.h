// Which triangles of a map are drawn at once, where that may take long.
#pragma once

#include "views/gl/soupbuffers.h"

#include <QVector2D>

#include <array>
#include <span>
#include <vector>

namespace autocuts {

//! Triangles in runs that follow each other in the buffers, as glMultiDrawArrays takes them.
struct TriangleRuns
{
    std::vector<int> first, count; //!< corners, per run
    double weight = 0;             //!< what drawing them costs, in pixels of a triangle
};

//! A map as it is drawn, in pixels of the picture from its lower left.
struct MapOnPixels
{
    std::span<const float> uvs;              //!< two numbers per soup corner
    std::span<const FaceTexel> faces;        //!< hidden and buried ones are not drawn
    std::array<int, 2> hoverTriangles{0, 0}; //!< are drawn even if they are buried
    QVector2D scale, offset;                 //!< pixel = uv * scale + offset
    double width = 0;                        //!< of the picture

    int triangleCount() const { return static_cast<int>(faces.size()); }
};

//! The triangles that touch some rows of pixels, from one triangle on, until they cover so many pixels of
//! these rows, or until so many were looked at that a window should answer: none of these may touch the rows.
//! \param next the triangle to begin with; receives the one to go on with
TriangleRuns trianglesInStrip(const MapOnPixels &map, double lowRow, double highRow, double mostWeight,
                              int &next);

} // namespace autocuts
