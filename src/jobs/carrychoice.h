// How textures are to be carried over, as the user chose it.
#pragma once

#include <QString>
#include <QStringList>

namespace autocuts::jobs {

//! The settings for carrying textures over to the active map.
struct CarryChoice
{
    enum class From {
        Textures, //!< the map that they were made for, as told by the undo history
        UvSet,    //!< another UV set
        File      //!< the map of a model's file
    };

    From from = From::Textures;
    int uvSet = 0;        //!< of the model
    QString file;         //!< a model or a session
    QString fileUvSet;    //!< name, or number from 1, of a UV set in it; empty: its active one
    QStringList textures; //!< files of pictures; empty: those of the model's materials
    QString folder;       //!< for the pictures
    QString suffix;       //!< goes to the end of their names
    QString format;       //!< "png"; empty: as each source, see CarryTarget
    int size = 0;         //!< of each side; 0: as each source
    int margin = 16;      //!< texels around islands

    bool operator==(const CarryChoice &) const = default;
};

} // namespace autocuts::jobs
