// The commands that make maps, each by the job that the studio uses too.
#pragma once

#include "cli/batchfiles.h"
#include "cli/clioptions.h"
#include "cli/mapreporting.h"
#include "jobs/mapremarks.h"
#include "solver/base/jobcontext.h"
#include "solver/unwrap/packjob.h"
#include "solver/unwrap/separatejob.h"

namespace autocuts {

//! Results of a mapping command besides the UVs.
struct MadeMap
{
    std::optional<int> iterations;
    double lambda = MapReport::unknown, delta = MapReport::unknown;
    double hardShare = MapReport::unknown; //!< see unwrap::UnwrapResult
    std::vector<IslandFlags> flags;        //!< per face, with new stacks; empty: they stay
    bool boundMissed = false;
    QStringList notes;    //!< what was done
    QStringList warnings; //!< what was requested and could not be done
    std::optional<transfer::TransferFigures> transfer;
};

//! Gives the first UV set of a scene a new map. \pre the scene is what the files have read, with area
class MapMaking final
{
public:
    MapMaking(const CliOptions &options, const BatchFiles &files, const JobContext &job)
        : mOptions(options), mFiles(files), mJob(job)
    {}

    Result<MadeMap> unwrap(Scene &scene) const;
    Result<MadeMap> pack(Scene &scene) const;
    Result<MadeMap> separate(Scene &scene) const;
    Result<MadeMap> lightmap(Scene &scene) const;
    Result<MadeMap> finish(Scene &scene) const;
    Result<MadeMap> transfer(Scene &scene) const;

private:
    //! Puts the result of separating into the scene. Faces without UVs stay as they are.
    Result<MadeMap> separated(const Snapshot &snapshot, Scene &scene,
                              const unwrap::SeparateResult &made) const;
    //! Packs the islands of an existing map that may change.
    Result<Done> packIslands(const Snapshot &snapshot, Scene &scene, MadeMap &made) const;
    //! Packs a new map once more when the options distribute it over tiles.
    Result<Done> packIntoTiles(const Snapshot &snapshot, Scene &scene, MadeMap &made) const;
    //! The input of the solver, with the scope of --only.
    Result<Snapshot> snapshotOf(const Scene &scene) const;
    bool hasOwnTiles(const Snapshot &snapshot) const;
    void sayGivenSeams(const Snapshot &snapshot, MadeMap &made) const;
    void say(const jobs::MapRemarks &remarks, MadeMap &made) const;
    Error errorOf(jobs::Remark::Kind problem) const;
    Error noWholeChart() const;
    Error noUvs() const;

    const CliOptions &mOptions;
    const BatchFiles &mFiles;
    const JobContext &mJob;
};

} // namespace autocuts
