// The jobs that make pictures for the map, with what the window says about them.
#pragma once

#include "commands/journalrecorder.h"
#include "jobs/bakechoice.h"
#include "jobs/carrychoice.h"
#include "jobs/lightchoice.h"
#include "views/control/mapjobs/mapjobs.h"

#include <QImage>

namespace autocuts {

// Each leaves the map as it is, and writes the files. Of the input, packing and session path count.

//! \param model its first UV set is the one that is baked into
MapJobResult bakeJob(const DocumentState &model, const MapInput &input, const jobs::BakeChoice &choice,
                     JobControl &control);

//! Receives pictures of tiles, as they are written into files of 8 bits; called on the job's thread.
using LightReceiver = std::function<void(int tile, const QImage &picture)>;

//! \param model as above \param textureSet index of the set that the textures of its materials are for
//! \param shown gets pictures from coarse to fine; may be empty
MapJobResult lightBakeJob(const DocumentState &model, int textureSet, const MapInput &input,
                          const jobs::LightChoice &choice, const LightReceiver &shown, JobControl &control);

//! A copy of the document.
struct CarryInput
{
    DocumentState state;
    PendingJournal journal; //!< of the state
};

//! The result has the new texture sets. After a stop or an error no file was written.
MapJobResult carryJob(const CarryInput &input, const QString &sessionPath, const jobs::CarryChoice &choice,
                      JobControl &control);

} // namespace autocuts
