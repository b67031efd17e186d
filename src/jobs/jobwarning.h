// Warnings about the result of a job: as data, and as texts.
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace autocuts::jobs {

//! A fact that the user should know about a result.
struct Warning
{
    enum class Kind {
        Said,          //!< `names` has the whole text, already translated
        FacesNotBaked, //!< `number` faces: without UVs, or on islands that cross the border of their tile
        FacesWithoutPicture, //!< the same, where textures are carried over
        NoSuchColors,        //!< the model has no colours of the chosen kind
        UnreadableTextures,  //!< `names`
        MissingPictures,     //!< `names`
        UnpairedObjects,     //!< `names`: no object of the detailed model belongs to these
        NoCage,              //!< the models are far apart; `number`: the distance that was taken, a share
        TexelsMissed,        //!< `number`: the share of the texels
        CarriedTexelsMissed, //!< the same, of another model's map
        TexelsShared,        //!< `number`: the share of the texels with several faces
        LightCutOff,         //!< `number`: the share of the texels that are brighter than the file can hold
    };
    Kind kind = Kind::Said;
    double number = 0;
    QStringList names = {};
};

using Warnings = std::vector<Warning>;

//! Adds texts that the model's files have given.
void addSaid(Warnings &warnings, const QStringList &texts);

//! Adds a warning of a share of texels if the share is large enough: single texels at borders are normal.
void addTexels(Warnings &warnings, Warning::Kind kind, long long some, long long all);

//! Translated, one sentence without a full stop.
QString textOf(const Warning &warning);
QStringList textsOf(const Warnings &warnings);

} // namespace autocuts::jobs
