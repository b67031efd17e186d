// What was done in a session, so that it can be done again.
#pragma once

#include "model/document/documentstate.h"

#include <QByteArray>

#include <vector>

namespace autocuts {

//! The commands that lead from one state of a document to another.
struct Journal
{
    DocumentState initial; //!< valid, without selection and view state, which no command depends on
    //! Each command's CBOR description as a zlib stream behind its size in four bytes, little-endian.
    std::vector<QByteArray> commands;
};

} // namespace autocuts
