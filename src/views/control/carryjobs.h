// The job that carries textures over to the map.
#pragma once

#include "commands/journalrecorder.h"
#include "views/control/carrychoice.h"
#include "views/control/mapjobs.h"

namespace autocuts {

//! A copy of the document.
struct CarryInput
{
    DocumentState state;
    PendingJournal journal; //!< of the state
};

//! Makes the pictures and writes their files; the result has the new texture sets. After a stop or an error
//! no file was written.
MapJobResult carryJob(const CarryInput &input, const QString &sessionPath, const CarryChoice &choice,
                      JobControl &control);

} // namespace autocuts
