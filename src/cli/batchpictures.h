// The commands that make pictures from models, by the jobs that the studio uses too.
#pragma once

#include "cli/batchfiles.h"
#include "jobs/madepictures.h"
#include "solver/base/jobcontext.h"

#include <QImage>
#include <QJsonObject>

namespace autocuts {

// Each makes pictures for the first UV set of a scene. \param files that have read the scene

//! Bakes the maps of the options. Files that are finished before a stop stay.
Result<jobs::MadePictures> bakeMaps(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                                    const JobContext &context);
//! Bakes the lights of the options, and writes the picture; after a stop, what there is of it.
Result<jobs::MadePictures> bakeLights(const CliOptions &options, const BatchFiles &files, const Scene &scene,
                                      const JobContext &context);
//! Makes the textures of the options new. After a stop no file was written.
Result<jobs::MadePictures> carryTextures(const CliOptions &options, const BatchFiles &files,
                                         const Scene &scene, const JobContext &context);

//! The model, its map, or both beside each other, as the options say.
QImage thumbnailOf(const CliOptions &options, const Scene &scene);

//! The part of a report that is about pictures.
QJsonObject pictureReport(const jobs::MadePictures &made);

} // namespace autocuts
