// The job that bakes pictures for the map.
#pragma once

#include "model/document/scene.h"
#include "solver/bake/bakejob.h"
#include "views/control/bakechoice.h"
#include "views/control/mapjobs.h"

namespace autocuts {

//! The bake of a choice. Reads the detailed model, so it takes long.
//! \param scene of the document, its first UV set being the active one \param files gets those that the
//! other models were read from \param warnings gets what is not as wished
Result<bake::BakeJob> makeBakeJob(const DocumentState &model, const PackingSettings &packing,
                                  const BakeChoice &choice, const std::atomic<bool> &stop, QStringList &files,
                                  QStringList &warnings);

//! Bakes and writes the pictures; the map stays as it is. \param model as above \param input its packing and
//! session path count
MapJobResult bakeJob(const DocumentState &model, const MapInput &input, const BakeChoice &choice,
                     JobControl &control);

} // namespace autocuts
