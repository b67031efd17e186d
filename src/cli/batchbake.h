// Runs the commands that make pictures from models.
#pragma once

#include "cli/batchfiles.h"
#include "model/document/result.h"
#include "solver/bake/bakejob.h"
#include "solver/base/jobcontext.h"

#include <QJsonObject>

#include <map>

namespace autocuts {

//! What was baked, for the user.
struct BakeOutcome
{
    bake::BakeFigures figures;
    QStringList files; //!< written, in the order of their making
    QStringList warnings;
    //! By the names of the maps: the mean difference across seams, see bake::SeamDifference; 255 is the whole
    //! range.
    std::map<QString, double> seamDifferences;
    std::optional<double> cage; //!< its distance, where a detailed model was looked for by one

    QJsonObject json() const;
};

//! Bakes the maps of the options into the UV map of a scene. Files that are finished before a stop stay.
//! \param files that have read the scene
//! \param stop that of the job, which also ends the reading of further files
Result<BakeOutcome> bakeMaps(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                             const std::atomic<bool> &stop, const JobContext &job);

//! Makes the textures of the options new for the UV map of a scene. After a stop no file was written.
//! \param files that have read it \param stop as above
Result<BakeOutcome> carryTextures(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                                  const std::atomic<bool> &stop, const JobContext &job);

} // namespace autocuts
