// The work on whole maps that MapController starts: functions of a copy of the document.
#pragma once

#include "commands/setuvs.h"
#include "model/document/constraints.h"
#include "model/document/islands.h"
#include "model/plain/packingsettings.h"
#include "model/plain/snapshot.h"
#include "solver/unwrap/unwrap.h"
#include "views/control/jobrunner.h"

#include <Eigen/Geometry>

#include <memory>
#include <optional>

namespace autocuts {

namespace live {
struct SolveResult;
}

//! The solver's own state, which knows more than the map that was made from it.
struct LiveSolve
{
    std::shared_ptr<const live::SolveResult> result; //!< null when the map was edited since
    bool hasMoreToDo = false;                        //!< paused before the schedule came to its end
};

//! What a job gets to see.
struct MapInput
{
    Snapshot snapshot;
    UvMatrix uv; //!< per corner, texture space
    double uvScale = 1;
    PackingSettings packing;
    IslandMarks marks;
    Constraints constraints;
    QList<int> selectedFaces;
    std::vector<int> selectedEdges;
    LiveSolve live; //!< that the map was made from

    const MeshData &mesh() const { return *snapshot.mesh; }
};

//! What a job gives back.
struct MapJobResult
{
    StateToken token; //!< of the state that the job was given
    UvEdit edit = UvEdit::Pack;
    UvMatrix uv;              //!< per corner, texture space; no rows: the map stays as it is
    QString message;          //!< what was done
    QString problem;          //!< what could not be done
    std::optional<int> count; //!< for the text in the history
};

//! Which islands are packed, and where to.
struct PackTarget
{
    bool all = true;                        //!< else those of `faces`; the others are obstacles
    QList<int> faces;                       //!< empty: those selected
    std::optional<Eigen::AlignedBox2d> box; //!< texture space; none: the tile of the settings
};

MapJobResult unwrapJob(const MapInput &input, unwrap::UnwrapQuality quality, double maxDistortion,
                       JobControl &control);
//! Without a live solve the seams are those of the map; one that was paused early is taken to its end first.
MapJobResult finishJob(const MapInput &input, double maxDistortion, JobControl &control);
MapJobResult packJob(const MapInput &input, const PackTarget &target, JobControl &control);
MapJobResult separateJob(const MapInput &input, JobControl &control);
MapJobResult equalizeJob(const MapInput &input);
//! Solves for the selected faces while all others stay.
MapJobResult relaxJob(const MapInput &input, JobControl &control);
//! Makes the chains of selected edges straight lines; the rest of their islands follows.
MapJobResult straightenJob(const MapInput &input, JobControl &control);

} // namespace autocuts
