// Bakes light into pictures for a map and writes their files.
#pragma once

#include "jobs/lightchoice.h"
#include "jobs/madepictures.h"
#include "model/document/result.h"
#include "solver/bake/lightjob.h"

namespace autocuts::jobs {

//! After a stop, the pictures are written as far as they are finished. With several tiles, the number of each
//! stands before the suffix. \param textureSet index of the UV set that the textures of the model's materials
//! are for \param shown gets pictures that are not finished, from coarse to fine, on the job's thread; may be
//! empty
Result<MadePictures> bakeLight(const PictureInput &input, int textureSet, const LightChoice &choice,
                               const bake::LightTilePreview &shown, const JobContext &context);

} // namespace autocuts::jobs
