// The journal of a session: its commands, so that they can be replayed.
#pragma once

#include "model/document/documentstate.h"

#include <QByteArray>

#include <vector>

namespace autocuts {

//! The commands that lead from an initial state of a document to a later one.
struct Journal
{
    DocumentState initial; //!< valid; without selection and view state, on which no command depends
    //! The CBOR description of each command: its size in four bytes, little-endian, then a zlib stream.
    std::vector<QByteArray> commands;
};

} // namespace autocuts
