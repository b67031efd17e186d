// What the jobs that make pictures have in common.
#pragma once

#include "jobs/remark.h"
#include "model/document/documentstate.h"
#include "model/pictures/picturefiles.h"
#include "model/plain/packingsettings.h"

#include <map>
#include <optional>

namespace autocuts::jobs {

//! The model that a job makes pictures for.
struct PictureInput
{
    DocumentState model;     //!< its first UV set is the one that the pictures are for
    PackingSettings packing; //!< the size of the pictures where the choice has none
    QStringList kept;        //!< files that must not be replaced
    QStringList alsoWritten; //!< what the caller writes besides, such as a report
};

//! The pictures that a job has made.
struct MadePictures
{
    bool stopped = false;
    QStringList files; //!< written, in the order of their making
    Remarks warnings;
    long long texels = 0;     //!< inside of islands
    long long missed = 0;     //!< of them: nothing of the other model was found
    long long overlapped = 0; //!< of them: with several faces
    //! Of a bake, by the names of its maps: the mean difference across seams, see bake::SeamDifference; 255
    //! is the whole range.
    std::map<QString, double> seamDifferences;
    //! Of a bake, by the names of its maps: one of the files; it stands for those of all tiles.
    std::map<QString, QString> fileOfMap;
    std::optional<double> cage; //!< distance of the cage, if a detailed model was baked with one
    //! The model's with the new pictures, as DocumentState::textureSets; empty: they are not for materials.
    std::vector<TextureSet> textureSets;
};

} // namespace autocuts::jobs
