#include "commands/journalrecorder.h"

#include "commands/documentcommand.h"
#include "commands/replay.h"

#include <algorithm>

namespace autocuts {

namespace {

DocumentState startState(const Document &document)
{
    DocumentState state = document.state();
    state.selection = {};
    state.viewState.clear();
    return state;
}

qint64 sumOf(const std::vector<QByteArray> &commands)
{
    qint64 sum = 0;
    for (const QByteArray &command : commands)
        sum += command.size();
    return sum;
}

} // namespace

JournalRecorder::JournalRecorder(Document &document, std::optional<Journal> earlier)
    : mDocument(document), mFirst(document.undoStack().index())
{
    if (earlier)
        mPast = std::move(*earlier);
    else
        mPast.initial = startState(document);
    connect(&document.undoStack(), &UndoStack::indexChanged, this, &JournalRecorder::forgetUndone);
    connect(&document.undoStack(), &UndoStack::aboutToRelease, this, &JournalRecorder::takeOver);
}

Journal JournalRecorder::journal()
{
    const UndoStack &stack = mDocument.undoStack();
    const int done = stack.index();
    mEncoded.resize(static_cast<std::size_t>(done));
    qint64 bytes = byteCount();
    for (int i = std::max(mFirst, stack.releasedCount()); i < done && !mMustStartAnew; ++i) {
        QByteArray &encoded = mEncoded[static_cast<std::size_t>(i)];
        if (encoded.isEmpty()) {
            encoded = journalEntry(static_cast<const DocumentCommand &>(*stack.command(i)).toCbor());
            bytes += encoded.size();
        }
        mMustStartAnew = bytes > mByteLimit;
    }
    if (mMustStartAnew)
        startAnew();
    Journal journal = mPast;
    for (const QByteArray &encoded : mEncoded) {
        if (!encoded.isEmpty())
            journal.commands.push_back(encoded);
    }
    if (!mEncoded.empty())
        mEncoded.pop_back();
    return journal;
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
    if (static_cast<int>(mEncoded.size()) >= index)
        mEncoded.resize(static_cast<std::size_t>(std::max(index - 1, 0)));
}

void JournalRecorder::takeOver(const UndoEntry &entry)
{
    const auto place = static_cast<std::size_t>(mDocument.undoStack().releasedCount());
    if (static_cast<int>(place) < mFirst || mMustStartAnew)
        return;
    if (place < mEncoded.size() && !mEncoded[place].isEmpty())
        mPast.commands.push_back(std::move(mEncoded[place]));
    else
        mPast.commands.push_back(journalEntry(static_cast<const DocumentCommand &>(entry).toCbor()));
    if (place < mEncoded.size())
        mEncoded[place].clear();
    if (byteCount() > mByteLimit) {
        mMustStartAnew = true;
        mPast.commands.clear();
    }
}

qint64 JournalRecorder::byteCount() const
{
    return sumOf(mPast.commands) + sumOf(mEncoded);
}

} // namespace autocuts
