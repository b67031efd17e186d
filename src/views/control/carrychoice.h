// How textures are to be carried over, as the user chose it.
#pragma once

#include <QString>

namespace autocuts {

//! Textures made new for the active map.
struct CarryChoice
{
    enum class From {
        Textures, //!< the map that they were made for, as the history knows it
        UvSet,    //!< another UV set
        File      //!< the map of a model's file
    };

    From from = From::Textures;
    int uvSet = 0;   //!< of the document
    QString file;    //!< a model or a session
    QString folder;  //!< for the pictures
    QString suffix;  //!< goes to the end of their names
    QString format;  //!< "png"; empty: as each source, see CarryTarget
    int size = 0;    //!< of each side; 0: as each source
    int margin = 16; //!< texels around islands

    bool operator==(const CarryChoice &) const = default;
};

} // namespace autocuts
