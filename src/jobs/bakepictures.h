// Bakes pictures for a map and writes their files.
#pragma once

#include "jobs/bakechoice.h"
#include "jobs/madepictures.h"
#include "model/document/result.h"
#include "solver/bake/bakejob.h"

namespace autocuts::jobs {

//! A bake that can start: its models have been read.
struct PreparedBake
{
    bake::BakeJob job;
    QStringList read; //!< files of the other models
    Remarks warnings;
    std::optional<double> cage; //!< see MadePictures
};

//! Reads the other models of a choice, so it takes long. Without UVs, the surface has no texels.
//! Errors: too large a picture, a model that cannot be read, a cage with other faces.
Result<PreparedBake> prepareBake(const DocumentState &model, const PackingSettings &packing,
                                 const BakeChoice &choice, const JobContext &context);

//! The files that a bake writes, one for each map and tile. \param uv per corner, of the set to bake for
QStringList bakedFiles(const Scene &scene, const UvMatrix &uv, double tileHeight, const BakeChoice &choice);

//! After a stop, the files of finished pictures stay. With pictures of normals, occlusion or colours,
//! MadePictures::textureSets has them, so that the caller can put them on the model.
Result<MadePictures> bakePictures(const PictureInput &input, const BakeChoice &choice,
                                  const JobContext &context);

//! The cage that transfer::proposedCage() measures for a detailed model, whose file is read.
Result<double> proposedCage(const DocumentState &model, const QString &high, const JobContext &context);

} // namespace autocuts::jobs
