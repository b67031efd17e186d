// Where UVs are to come from, as the user chose it.
#pragma once

#include "model/transfer/uvtransfer.h"

#include <QString>

namespace autocuts::jobs {

//! The source of the UVs, and how faces are matched.
struct TransferChoice
{
    enum class From { File, UvSet, Object };

    From from = From::File;
    QString path;       //!< of the file
    QString fileUvSet;  //!< name, or number from 1, of a UV set in it; empty: its active one
    QString fileObject; //!< name of an object in it; empty: all
    int uvSet = 0;      //!< of the model, for From::UvSet
    int object = -1;    //!< of the model; -1: all. From::Object takes its UVs of the active set
    transfer::UvMatch match = transfer::UvMatch::Auto;
    bool onlySelection = false; //!< give UVs to the selected faces only
};

} // namespace autocuts::jobs
