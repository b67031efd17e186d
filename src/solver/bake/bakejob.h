// A bake from its models to pictures, for the window and the command line.
#pragma once

#include "solver/bake/baker.h"
#include "solver/bake/encoding.h"
#include "solver/bake/seamplaces.h"

#include <functional>
#include <optional>
#include <string>

namespace autocuts::bake {

//! Which surface the maps are read from.
enum class SourceKind {
    None,         //!< the simple model itself is baked
    Detailed,     //!< another model, found by rays
    SameTriangles //!< the same triangles with other UVs: textures are carried over
};

//! The inputs and the settings of one texture bake.
struct BakeJob
{
    ShadedSurface low;
    std::optional<ShadedSurface> high; //!< unless `kind` is None
    SourceKind kind = SourceKind::None;
    BakeSettings settings; //!< its grid has no tile yet
    std::vector<int> tiles{1001};
    int margin = 16;        //!< texels around islands that are filled
    bool floats = false;    //!< for files of floating point numbers, see Encoding
    bool greenDown = false; //!< tangent space normals for DirectX
    //! Bytes that the pictures of one pass over the surface may take; chosen by hand so that maps of 8192 x
    //! 8192 texels stay within 4 GB.
    std::size_t memory = std::size_t(1) << 30;
};

//! How the values of a bake become numbers of files.
Encoding encodingOf(const BakeJob &job, const Frame &frame);

//! Texel counts and seam differences, summed over all tiles of a bake.
struct BakeFigures
{
    bool stopped = false;
    long long texels = 0, missed = 0, overlapped = 0; //!< see BakeResult
    //! As BakeSettings::maps; of all tiles. Not compared: files of floating point numbers and material IDs.
    std::vector<SeamDifference> seams;

    //! Adds the counts of another job.
    void add(const BakeFigures &other)
    {
        stopped = stopped || other.stopped;
        texels += other.texels;
        missed += other.missed;
        overlapped += other.overlapped;
    }
};

//! Receives a finished map: its number in BakeSettings::maps and its tile. Returns false to end the bake.
using MapSink = std::function<bool(std::size_t map, int tile, const Picture &picture)>;

//! Bakes all maps of all tiles, filled around islands and encoded for files. A map that was not finished when
//! the job was stopped is not given to the sink.
BakeFigures runBake(const BakeJob &job, const MapSink &sink, const JobContext &context);

} // namespace autocuts::bake
