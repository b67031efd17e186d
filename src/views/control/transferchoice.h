// Where UVs are to come from, as the user chose it.
#pragma once

#include "model/transfer/uvtransfer.h"

#include <QString>

namespace autocuts {

//! What is transferred, and how.
struct TransferChoice
{
    enum class From { File, UvSet, Object };

    From from = From::File;
    QString path;   //!< of the file
    int uvSet = 0;  //!< of the document
    int object = 0; //!< of the document; its UVs are those of the active set
    transfer::UvMatch match = transfer::UvMatch::Auto;
    bool onlySelection = false; //!< give UVs to the selected faces only
};

} // namespace autocuts
