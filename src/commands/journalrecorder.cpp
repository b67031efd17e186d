#include "commands/journalrecorder.h"

#include "commands/documentcommand.h"
#include "commands/replay.h"

#include <algorithm>
#include <iterator>

namespace autocuts {

namespace {

DocumentState startState(const Document &document)
{
    DocumentState state = document.state();
    state.selection = {};
    state.viewState.clear();
    return state;
}

} // namespace

JournalEntry::JournalEntry(const QCborMap &command)
    : mBytes(command.toCborValue().toCbor()), mSize(mBytes.size())
{}

const QByteArray &JournalEntry::bytes()
{
    std::call_once(mCompressed, [this] { mBytes = compressedEntry(mBytes); });
    return mBytes;
}

PendingJournal::PendingJournal(Journal past, std::vector<std::shared_ptr<JournalEntry>> newer)
    : mPast(std::move(past)), mNewer(std::move(newer))
{}

Journal PendingJournal::finished() const
{
    Journal journal = mPast;
    for (const std::shared_ptr<JournalEntry> &entry : mNewer)
        journal.commands.push_back(entry->bytes());
    return journal;
}

JournalRecorder::JournalRecorder(Document &document, std::optional<Journal> earlier)
    : mDocument(document), mFirst(earlier ? 0 : document.undoStack().index())
{
    if (earlier)
        mPast = std::move(*earlier);
    else
        mPast.initial = startState(document);
    connect(&document.undoStack(), &UndoStack::indexChanged, this, &JournalRecorder::forgetUndone);
    connect(&document.undoStack(), &UndoStack::aboutToRelease, this, &JournalRecorder::takeOver);
}

PendingJournal JournalRecorder::pending()
{
    const UndoStack &stack = mDocument.undoStack();
    const int done = stack.index();
    mEncoded.resize(static_cast<std::size_t>(done));
    qint64 bytes = byteCount();
    for (int i = std::max(mFirst, stack.releasedCount()); i < done && !mMustStartAnew; ++i) {
        std::shared_ptr<JournalEntry> &encoded = mEncoded[static_cast<std::size_t>(i)];
        if (!encoded) {
            encoded = std::make_shared<JournalEntry>(
                static_cast<const DocumentCommand &>(*stack.command(i)).toCbor());
            bytes += encoded->size();
        }
        mMustStartAnew = bytes > mByteLimit;
    }
    if (mMustStartAnew)
        startAnew();
    std::vector<std::shared_ptr<JournalEntry>> newer;
    std::copy_if(mEncoded.begin(), mEncoded.end(), std::back_inserter(newer),
                 [](const std::shared_ptr<JournalEntry> &encoded) { return encoded != nullptr; });
    if (!mEncoded.empty())
        mEncoded.pop_back();
    return {mPast, std::move(newer)};
}

void JournalRecorder::startAnew()
{
    mPast = {startState(mDocument), {}};
    mFirst = mDocument.undoStack().index();
    mEncoded.clear();
    mMustStartAnew = false;
}

void JournalRecorder::forgetUndone(int index)
{
    mMustStartAnew = mMustStartAnew || index < mFirst;
    // Also when the command was merged into the one before.
    if (index > 0 && index >= mFirst &&
        static_cast<const DocumentCommand &>(*mDocument.undoStack().command(index - 1)).beginsJournal())
        startAnew();
    if (static_cast<int>(mEncoded.size()) >= index)
        mEncoded.resize(static_cast<std::size_t>(std::max(index - 1, 0)));
}

void JournalRecorder::takeOver(const UndoEntry &entry)
{
    const auto place = static_cast<std::size_t>(mDocument.undoStack().releasedCount());
    if (static_cast<int>(place) < mFirst || mMustStartAnew)
        return;
    if (place < mEncoded.size() && mEncoded[place])
        mPast.commands.push_back(mEncoded[place]->bytes());
    else
        mPast.commands.push_back(journalEntry(static_cast<const DocumentCommand &>(entry).toCbor()));
    if (place < mEncoded.size())
        mEncoded[place].reset();
    if (byteCount() > mByteLimit) {
        mMustStartAnew = true;
        mPast.commands.clear();
    }
}

qint64 JournalRecorder::byteCount() const
{
    qint64 sum = 0;
    for (const QByteArray &command : mPast.commands)
        sum += command.size();
    for (const std::shared_ptr<JournalEntry> &entry : mEncoded)
        sum += entry ? entry->bytes().size() : 0;
    return sum;
}

} // namespace autocuts
