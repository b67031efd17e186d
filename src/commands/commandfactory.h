// Restores commands from their descriptions in a journal.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/result.h"

#include <memory>

namespace autocuts {

//! Restores the command that toCbor() described, for a document in the state in which that command was made.
//! The command belongs to no gesture. Returns an Error, and changes nothing, when the map is damaged or does
//! not fit the document.
//! \pre the map was decoded without a QCborParserError: Qt 6.4 crashes on a map that ends between a key and
//! its value
Result<std::unique_ptr<DocumentCommand>> makeCommand(const QCborMap &map, Document &document);

//! The error for a description that cannot be read.
Error damagedCommand();

} // namespace autocuts
