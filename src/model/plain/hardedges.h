// Finds the hard edges of a model in what its file says about shading. Plain: no Qt.
#pragma once

#include "model/plain/meshdata.h"

#include <cstdint>

namespace autocuts {

//! The normals and the smoothing groups of a file.
struct FileShading
{
    static constexpr std::int64_t unsaid = -1;

    PositionMatrix
        normals; //!< per corner, of any length; no rows, or rows of zeros or NaN, where there are none
    //! Per face: the number of its smoothing group, 0 for off, or unsaid; empty when the format has none.
    std::vector<std::int64_t> smoothing;
};

//! True when the file gives a normal or a smoothing group.
bool saysAnything(const FileShading &shading);

//! The edges that the file does not shade smoothly: between two smoothing groups, at faces for which
//! smoothing is off, and where the normals of the two sides differ by more than a degree at one end. (Where a
//! hard edge ends inside a smooth surface, they agree at that end.) \returns one entry per edge pair; empty
//! when the file says nothing
std::vector<bool> hardEdges(const MeshData &mesh, const FileShading &shading);

} // namespace autocuts
