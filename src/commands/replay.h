// Replays the commands of a journal.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/journal.h"
#include "model/document/result.h"

namespace autocuts {

//! The journal entry of a command's description. \param command CBOR
QByteArray compressedEntry(const QByteArray &command);
QByteArray journalEntry(const QCborMap &command);

//! A document in the journal's initial state, after executing all its commands. An Error names the first
//! command that is damaged or does not fit.
Result<std::unique_ptr<Document>> replay(const Journal &journal);

//! True when the states are equal, ignoring selection and view state, which a journal does not contain.
bool sameWork(const DocumentState &a, const DocumentState &b);

} // namespace autocuts
