// Keeps the journal of a session.
#pragma once

#include "model/document/document.h"
#include "model/document/journal.h"

#include <QCborMap>

#include <memory>
#include <mutex>
#include <optional>

namespace autocuts {

//! A command's description, compressed when it is first asked for, on whatever thread that is.
class JournalEntry final
{
public:
    explicit JournalEntry(const QCborMap &command);

    //! Before compression.
    qint64 size() const { return mSize; }
    //! As it stands in a Journal.
    const QByteArray &bytes();

private:
    QByteArray mBytes;
    qint64 mSize;
    std::once_flag mCompressed;
};

//! A journal of which some commands may have to be compressed yet, so that it is quickly taken.
class PendingJournal final
{
public:
    PendingJournal(Journal past, std::vector<std::shared_ptr<JournalEntry>> newer);

    //! Compresses what is left; can be called on another thread than the recorder's.
    Journal finished() const;

private:
    Journal mPast;
    std::vector<std::shared_ptr<JournalEntry>> mNewer;
};

//! Writes down the commands of a document: those on its undo stack that are done, and before them those that
//! the stack has forgotten. What was undone is not in the journal.
//!
//! The journal is bounded: when it has grown too large, or when the user undoes what it does not contain any
//! more, it begins anew with the state at that time.
class JournalRecorder final : public QObject
{
    Q_OBJECT

public:
    static constexpr qint64 defaultByteLimit = qint64(32) * 1024 * 1024;

    //! \param document must outlive the recorder; nothing was undone in it yet
    //! \param earlier the journal that leads to the document's present state: of a session that was loaded
    explicit JournalRecorder(Document &document, std::optional<Journal> earlier = std::nullopt);

    //! \pre bytes >= 0
    void setByteLimit(qint64 bytes) { mByteLimit = bytes; }

    //! The journal up to the present state.
    PendingJournal pending();
    Journal journal() { return pending().finished(); }

private:
    void startAnew();
    void forgetUndone(int index);
    void takeOver(const UndoEntry &entry);
    qint64 byteCount() const;

    Document &mDocument;
    Journal mPast; //!< with the commands that are not on the stack any more
    int mFirst;    //!< stack entries below it are part of mPast.initial
    //! Descriptions of the stack's entries by their place, as far as they were needed; never of the newest
    //! entry, which can still change.
    std::vector<std::shared_ptr<JournalEntry>> mEncoded;
    qint64 mByteLimit = defaultByteLimit;
    bool mMustStartAnew = false;
};

} // namespace autocuts
