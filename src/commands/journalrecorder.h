// Keeps the journal of a session.
#pragma once

#include "model/document/document.h"
#include "model/document/journal.h"

#include <QCborMap>

#include <memory>
#include <mutex>
#include <optional>

namespace autocuts {

//! The description of a command, compressed on first use on any thread.
class JournalEntry final
{
public:
    explicit JournalEntry(const QCborMap &command);

    //! Bytes before compression.
    qint64 size() const { return mSize; }
    //! The compressed bytes, as in a Journal.
    const QByteArray &bytes();

private:
    QByteArray mBytes;
    qint64 mSize;
    std::once_flag mCompressed;
};

//! A journal with commands that may not be compressed yet, so that it can be made quickly.
class PendingJournal final
{
public:
    PendingJournal(Journal past, std::vector<std::shared_ptr<JournalEntry>> newer);

    //! Adds a command behind the recorded ones, to this journal only.
    void add(const QCborMap &command) { mNewer.push_back(std::make_shared<JournalEntry>(command)); }
    //! Compresses the remaining commands; may be called on another thread than the recorder's.
    Journal finished() const;

private:
    Journal mPast;
    std::vector<std::shared_ptr<JournalEntry>> mNewer;
};

//! Records the commands of a document: those on its undo stack that are done, and those that the stack has
//! released. Commands that were undone are not in the journal.
//!
//! The size of the journal is limited. When it is exceeded, or when the user undoes a command that the
//! journal does not contain, or when the model is replaced, the journal starts again with the current state.
class JournalRecorder final : public QObject
{
    Q_OBJECT

public:
    //! Bytes; chosen by hand.
    static constexpr qint64 defaultByteLimit = qint64(32) * 1024 * 1024;

    //! \param document must outlive the recorder; nothing has been undone in it
    //! \param earlier for a loaded session, the journal that leads to the beginning of the document's
    //! history; without it the journal begins with the current state
    explicit JournalRecorder(Document &document, std::optional<Journal> earlier = std::nullopt);

    //! \pre bytes >= 0
    void setByteLimit(qint64 bytes) { mByteLimit = bytes; }

    //! The journal up to the current state.
    PendingJournal pending();
    Journal journal() { return pending().finished(); }

private:
    void startAnew();
    void forgetUndone(int index);
    void takeOver(const UndoEntry &entry);
    qint64 byteCount() const;

    Document &mDocument;
    Journal mPast; //!< includes the commands that are no longer on the stack
    int mFirst;    //!< entries of the stack below this index are part of mPast.initial
    //! Descriptions of the stack's entries by index, made on demand. Not of the newest entry, because it can
    //! still change.
    std::vector<std::shared_ptr<JournalEntry>> mEncoded;
    qint64 mByteLimit = defaultByteLimit;
    bool mMustStartAnew = false;
};

} // namespace autocuts
