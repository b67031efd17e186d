// The jobs of MapController, as functions of a copy of the document.
#pragma once

#include "commands/editmapseams.h"
#include "jobs/packmap.h"
#include "model/document/constraints.h"
#include "model/document/islands.h"
#include "model/document/selection.h"
#include "model/document/texturesets.h"
#include "model/plain/packingsettings.h"
#include "model/plain/snapshot.h"
#include "solver/base/jobcontext.h"
#include "solver/unwrap/seamprices.h"
#include "solver/unwrap/unwrapquality.h"
#include "views/control/session/jobrunner.h"

#include <Eigen/Geometry>

#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace autocuts {

namespace overlap {
enum class SeparationMethod;
}
namespace unwrap {
struct UnwrapResult;
}

namespace live {
struct SolveResult;
}

//! The state of the solver, which contains more than the map made from it.
struct LiveSolve
{
    std::shared_ptr<const live::SolveResult> result; //!< null when the map was edited since
    bool hasMoreToDo = false;                        //!< it was paused before the end of its schedule
};

//! The input of a job.
struct MapInput
{
    Snapshot snapshot;
    UvMatrix uv; //!< per corner, texture space
    double uvScale = 1;
    PackingSettings packing;
    QString sessionPath; //!< empty when there is none
    IslandMarks marks;
    Constraints constraints;
    QList<int> selectedFaces;
    std::vector<int> selectedEdges;
    LiveSolve live; //!< the solve from which the map was made

    const MeshData &mesh() const { return *snapshot.mesh; }
};

//! The seams that a job ripped or stitched.
struct MapSeamEdit
{
    EditMapSeams::Edit edit = EditMapSeams::Edit::Rip;
    std::vector<int> edges; //!< edge pairs
};

//! Texture sets that a job made, as DocumentState::textureSets.
struct MadeTextures
{
    std::vector<TextureSet> before, sets;
    bool baked = false; //!< false: carried over
};

//! The result of a job.
struct MapJobResult
{
    StateToken token; //!< token of the state that the job was given
    UvEdit edit = UvEdit::Pack;
    UvMatrix uv;                       //!< per corner, texture space; without rows, the map is not changed
    QString message;                   //!< what was done
    QString problem;                   //!< what could not be done
    Selection problemItems{};          //!< what the problem is about
    std::optional<int> count;          //!< number for the text in the history
    std::optional<double> hardShare{}; //!< see unwrap::UnwrapResult, where the kind was recognised
    std::vector<IslandFlags> flags{};  //!< new flags of the islands, per face; empty: they stay
    std::optional<unwrap::SeamPrices> prices{};
    //! Of a rip or a stitch; then the map is not a whole new one.
    std::optional<MapSeamEdit> seams{};
    std::optional<MadeTextures> textures{}; //!< for the map of the token
};

//! Which islands are packed, and where.
struct PackTarget
{
    bool all = true;                        //!< false: only those of `faces`; the others are obstacles
    QList<int> faces;                       //!< empty: the selected faces
    std::optional<Eigen::AlignedBox2d> box; //!< texture space; without it, the tile of the settings
    jobs::PackChoice choice{};              //!< but for the first tile, which the settings have
};

//! The context of a job: its progress never falls. \param bound on the distortion, for the text about the
//! stage
JobContext contextOf(JobControl &control, double bound = std::numeric_limits<double>::infinity());

//! The scope of a job that may change these faces only. \param attached see JobScope \param chosen the same
std::shared_ptr<const JobScope> scopeOf(const MeshData &mesh, const QList<int> &faces, bool attached,
                                        bool chosen = true);

//! What to select, of what remarks are about.
Selection itemsOf(const Snapshot &snapshot, const jobs::Remarks &remarks);

//! Says which faces of the new map overlap that did not before. \pre the result has a map
void tellNewOverlaps(const MapInput &input, const JobControl &control, MapJobResult &result);

//! \param better receives ever better maps while the job runs, on another thread; may be empty
MapJobResult unwrapJob(const MapInput &input, unwrap::UnwrapQuality quality,
                       std::function<void(const unwrap::UnwrapResult &)> better, JobControl &control);
//! Finishes the map. Without a live solve it keeps the seams of the map; a solve that was paused early is
//! first continued to its end.
MapJobResult finishJob(const MapInput &input, JobControl &control);
MapJobResult packJob(const MapInput &input, const PackTarget &target, JobControl &control);
MapJobResult separateJob(const MapInput &input, overlap::SeparationMethod method, JobControl &control);
//! Takes the map, which is a copy in a set of its own, apart for lightmaps (solver/unwrap/lightmapjob.h).
MapJobResult lightmapJob(const MapInput &input, JobControl &control);
MapJobResult equalizeJob(const MapInput &input, JobControl &control);
//! Minimises the distortion of the selected faces while all others stay.
MapJobResult relaxJob(const MapInput &input, JobControl &control);
//! Prices the seams of the map, which stays as it is.
MapJobResult priceJob(const MapInput &input, JobControl &control);
//! Makes the chains of selected edges straight; the rest of their islands follows.
MapJobResult straightenJob(const MapInput &input, JobControl &control);
//! Makes the selected quads a rectangle of straight rows and columns; the rest of their islands follows.
MapJobResult gridJob(const MapInput &input, JobControl &control);
//! Turns the islands of these faces to the axes and makes straight what is straight on the model.
MapJobResult alignJob(const MapInput &input, const QList<int> &faces, JobControl &control);
//! Cuts the map along edges. \param edges edges of MeshAdjacency
MapJobResult ripJob(const MapInput &input, const QList<int> &edges, JobControl &control);
//! Closes seams of the map. \param edges edges of MeshAdjacency; those that are no seams are left out
MapJobResult stitchJob(const MapInput &input, const QList<int> &edges, JobControl &control);

} // namespace autocuts
