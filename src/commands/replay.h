// Doing again what a journal holds.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/journal.h"
#include "model/document/result.h"

namespace autocuts {

//! A command's description as an entry of a journal. \param command CBOR
QByteArray compressedEntry(const QByteArray &command);
QByteArray journalEntry(const QCborMap &command);

//! A document in the journal's initial state on which all its commands were done. An Error names the first
//! one that is damaged or does not fit.
Result<std::unique_ptr<Document>> replay(const Journal &journal);

//! True when the states are equal but for selection and view state, which are not replayed.
bool sameWork(const DocumentState &a, const DocumentState &b);

} // namespace autocuts
