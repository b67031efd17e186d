// Replays the commands of a journal.
#pragma once

#include "commands/documentcommand.h"
#include "model/document/journal.h"
#include "model/document/result.h"

#include <QThread>

#include <atomic>
#include <functional>
#include <optional>

namespace autocuts {

//! The journal entry of a command's description. \param command CBOR
QByteArray compressedEntry(const QByteArray &command);
QByteArray journalEntry(const QCborMap &command);

//! A document in the journal's initial state, after executing all its commands. An Error names the first
//! command that is damaged or does not fit. \param before called before each command is done; may be empty
Result<std::unique_ptr<Document>>
replay(const Journal &journal,
       const std::function<void(const Document &, const DocumentCommand &next)> &before = {});

//! A session with its undo history.
struct RestoredSession
{
    std::unique_ptr<Document> document;
    std::optional<Journal> past; //!< leads to the beginning of the document's history
};

//! Entries of the undo history that come back with a session. Chosen by hand.
inline constexpr int mostRestoredEntries = 500;

//! Makes the document of a loaded session by its journal, so that its last commands can be undone. Where the
//! journal does not lead to the state, the document has the state and no history. Takes long.
//! \param state valid \param thread where the document is to be used
RestoredSession restoredSession(DocumentState state, std::optional<Journal> journal, QThread *thread,
                                const std::atomic<bool> *stop = nullptr, int most = mostRestoredEntries);

//! The map that a document's textures are for, as far as its journal tells: the active one at the beginning
//! of the journal, or when the first textures were chosen, or when they were carried over to it. Nothing
//! where that was no map, or the journal is damaged. Takes long.
std::optional<UvMatrix> mapOfTextures(const Journal &journal);

//! True when the states are equal, ignoring selection and view state, which a journal does not contain.
bool sameWork(const DocumentState &a, const DocumentState &b);

} // namespace autocuts
