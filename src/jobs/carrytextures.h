// Makes textures new for another UV map of their model and writes their files.
#pragma once

#include "jobs/carrychoice.h"
#include "jobs/carryplan.h"
#include "jobs/madepictures.h"
#include "model/document/result.h"
#include "solver/bake/carrying.h"

namespace autocuts::jobs {

//! \param mapOfTextures the map that the model's textures were made for, for CarryChoice::From::Textures;
//! nothing where it is not known
//!
//! After a stop or an Error no file was written. When the textures are those of the materials,
//! MadePictures::textureSets has the new ones.
Result<MadePictures> carryTextures(const PictureInput &input, const std::optional<UvMatrix> &mapOfTextures,
                                   const CarryChoice &choice, const JobContext &context);

//! How the pictures of a plan are made.
struct CarrySettings
{
    int width = 0, height = 0; //!< of the new pictures; 0: as the largest of each texture
    bool needsAll = false;     //!< a picture that cannot be read is an Error; else it is left out
};

//! The result of carrying textures over.
struct CarriedFiles
{
    bool stopped = false; //!< then nothing was written
    QStringList files;
    QStringList problems;      //!< pictures that could not be read, with the reasons
    CarryPlan plan;            //!< the pictures that were made; the names are those of their files
    bake::BakeFigures figures; //!< of all pictures together
};

//! Reads, bakes and writes all pictures of a plan. The files are put in their places when all of them are
//! finished: after an error or a stop everything is as before. Takes long.
//! \param faceMaterial of the model with the new map, see Scene::faceMaterial
Result<CarriedFiles> carryPictures(const CarryPlan &plan, const std::vector<int> &faceMaterial,
                                   const bake::CarryModel &model, const CarrySettings &settings,
                                   const JobContext &context);

} // namespace autocuts::jobs
