// The job "pack" of the window and the command line, and the placing of islands in all other jobs.
#pragma once

#include "model/plain/chart.h"
#include "model/plain/islandflags.h"
#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/packing/islandgeometry.h"

#include <Eigen/Geometry>

namespace autocuts::unwrap {

//! A rectangle in texture space whose islands are packed into it.
struct PackRectangle
{
    Eigen::AlignedBox2d box;
    std::vector<bool> faces; //!< per face: its island belongs to the rectangle
};

//! When only a quick layout is made.
enum class PackHurry {
    Never,
    WhenStopped, //!< when stopped before the first layout
    Always
};

//! The islands to pack, and the settings.
struct PackJob
{
    packing::PackOptions options{};       //!< settings, and the bin of islands without another one
    std::vector<IslandFlags> faceFlags{}; //!< per face; empty: none is locked, stacked or grouped
    std::vector<bool> movable{};          //!< per face; charts without such a face are obstacles; empty: all
    std::vector<bool> stays{};            //!< per face; charts with such a face are obstacles; empty: none
    std::vector<int> tiles{};             //!< per face: the UDIM tile it stays in, 0: none; empty: none
    std::vector<PackRectangle> rectangles{};
    //! Islands keep their size as long as there is room for them at that size.
    bool keepScaleIfPossible = false;
    //! Islands are as large as their rectangles allow, for there is no other island whose scale they could
    //! have.
    bool fillRectangles = false;
    //! Islands that are nearer to each other than this, UV units, are not where they belong; 0: those that
    //! overlap. See keptGap().
    double gap = 0;
    PackHurry hurry = PackHurry::Never;
    packing::DensityBasis density = packing::DensityBasis::FlatParts; //!< how islands get one texel density

    //! Packs into a box instead of tiles and rectangles.
    void packInto(const Eigen::AlignedBox2d &box);
};

//! A job that obeys the steering: locked and pinned islands and those outside the scope stay, stacks and
//! groups are rigid, islands of a rectangle stay in it, and the others in their tile.
[[nodiscard]] PackJob steeredPackJob(const Snapshot &snapshot, const packing::PackOptions &options);

//! The margin, less what rounding may take of it. UV units.
[[nodiscard]] double marginGap(const packing::PackOptions &options);

//! The distance that islands keep which stay where they are when they change: the margin, or less where they
//! were nearer to each other. UV units. \param before the map so far
[[nodiscard]] double keptGap(const MeshData &mesh, const PackJob &pack, const UvMatrix &before);

//! The number of charts that packing may move.
[[nodiscard]] int movingCharts(const MeshData &mesh, const ChartMap &charts, const PackJob &pack);

//! True when all islands may move and belong to rectangles: nothing but these says how large they are.
[[nodiscard]] bool onlyRectangles(const PackJob &pack);

//! Packs charts around those that stay; the charts of a stack or group move as one island. The islands of a
//! rectangle stay as they are when they lie in it and overlap nothing.
//! \param uv per corner, texture space; changed only when the result is true
//! \returns false when there is no room, or when stopped before there was a layout
[[nodiscard]] bool packCharts(const MeshData &mesh, const ChartMap &charts, const PackJob &pack, UvMatrix &uv,
                              const JobContext &job = {});

//! Packs islands around all others, at their size. \param faces of the islands, per face
//! \returns as packCharts()
[[nodiscard]] bool packAround(const MeshData &mesh, const ChartMap &charts, PackJob pack,
                              const std::vector<bool> &faces, UvMatrix &uv, const JobContext &job = {});

//! Packs all islands of the tiles to which some faces belong. \returns as packCharts()
[[nodiscard]] bool packTilesOf(const MeshData &mesh, const ChartMap &charts, PackJob pack,
                               const std::vector<bool> &faces, UvMatrix &uv, const JobContext &job = {});

//! Packs the islands that are not where they belong around the others, at their size and, as long as there is
//! room, without turning them. \returns as packCharts()
[[nodiscard]] bool packOnlyMisplaced(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                                     UvMatrix &uv, const JobContext &job = {});

//! The same; where there is no room, all islands of their tiles that may move. \returns as packCharts()
[[nodiscard]] bool packMisplaced(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                                 UvMatrix &uv, const JobContext &job = {});

//! Per face: true where an island that may move lies outside of its rectangle, tile or bin, or overlaps an
//! island that stays or is larger, or is nearer to it than the gap.
[[nodiscard]] std::vector<bool> misplacedFaces(const MeshData &mesh, const ChartMap &charts,
                                               const PackJob &pack, const UvMatrix &uv,
                                               const JobContext &job = {});

//! True when every island that may move lies in its rectangle, its tile or the bin, overlaps nothing, and
//! keeps the gap.
[[nodiscard]] bool liesFree(const MeshData &mesh, const ChartMap &charts, const PackJob &pack,
                            const UvMatrix &uv, const JobContext &job = {});

} // namespace autocuts::unwrap
