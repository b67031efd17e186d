// Building commands again from what a journal holds.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/result.h"

#include <memory>

namespace autocuts {

//! The command that toCbor() described, for a document in the state in which that command was made. It
//! belongs to no gesture. An error, and no harm, when the map is damaged or does not fit the document's
//! present state. \pre the map was decoded without a QCborParserError: Qt 6.4 crashes on looking into a map
//! that broke off between a key and its value
Result<std::unique_ptr<DocumentCommand>> makeCommand(const QCborMap &map, Document &document);

} // namespace autocuts
