// Runs the commands that make pictures from models.
#pragma once

#include "cli/batchfiles.h"
#include "model/document/result.h"
#include "solver/bake/bakejob.h"
#include "solver/base/jobcontext.h"

#include <QJsonObject>

namespace autocuts {

//! What was baked, for the user.
struct BakeOutcome
{
    bake::BakeFigures figures;
    QStringList files; //!< written, in the order of their making
    QStringList warnings;

    QJsonObject json() const;
};

//! Bakes the maps of the options into the UV map of a scene. Files that are finished before a stop stay.
//! \param scene what `files` has read
Result<BakeOutcome> bakeMaps(const CliOptions &options, const Scene &scene, const JobContext &job);

//! Makes the textures of the options new for the UV map of a scene. After a stop no file was written. \param
//! files that have read it
Result<BakeOutcome> carryTextures(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                                  const JobContext &job);

} // namespace autocuts
