// The job that bakes light into a map.
#pragma once

#include "model/document/scene.h"
#include "views/control/lightchoice.h"
#include "views/control/mapjobs.h"

#include <QImage>

namespace autocuts {

//! Receives pictures of tiles, as they are written into files of 8 bits; called on the job's thread.
using LightReceiver = std::function<void(int tile, const QImage &picture)>;

//! Bakes light and writes the pictures; the map stays as it is. After a stop, what there is is written.
//! \param model the document, its first UV set being the one that is baked into \param textureSet index of
//! the set that the textures of its materials are for \param input its packing and session path count
//! \param shown gets pictures from coarse to fine; may be empty
MapJobResult lightBakeJob(const DocumentState &model, int textureSet, const MapInput &input,
                          const LightChoice &choice, const LightReceiver &shown, JobControl &control);

} // namespace autocuts
