#include "model/document/undostack.h"

namespace autocuts {

namespace {

//! The pool allocates chunks of up to this many blocks. Chosen by hand; its effect has not been measured.
constexpr std::size_t poolBlocksPerChunk = 256;

} // namespace

UndoEntry::~UndoEntry()
{
    if (mTotal)
        *mTotal -= mAccounted;
}

void UndoEntry::account()
{
    const qint64 bytes = mReleased ? 0 : contentBytes();
    *mTotal += bytes - mAccounted;
    mAccounted = bytes;
}

UndoStack::UndoStack(QObject *parent)
    : QUndoStack(parent), mPool(std::make_shared<std::pmr::unsynchronized_pool_resource>(
                              std::pmr::pool_options{poolBlocksPerChunk, poolBlockSize}))
{}

UndoEntry *UndoStack::entry(int index) const
{
    // Only push() adds entries. QUndoStack returns them as const.
    return static_cast<UndoEntry *>(const_cast<QUndoCommand *>(command(index)));
}

void UndoStack::push(std::unique_ptr<UndoEntry> entry_)
{
    UndoEntry *pushed = entry_.release();
    UndoEntry *const below = index() > 0 ? entry(index() - 1) : nullptr;
    // Another kind of entry does not merge. What is below is compacted before, because the new entry may
    // replace the model that the contents are about.
    const bool mayMerge = below && below->id() == pushed->id();
    if (below && !mayMerge)
        compact(*below);
    QUndoStack::push(pushed);
    const int top = index() - 1;
    if (top < 0)
        return;
    const bool added = entry(top) != below;
    if (added) {
        entry(top)->mTotal = mTotal;
        if (top > 0 && mayMerge)
            compact(*entry(top - 1));
    }
    entry(top)->account();
    keepLimit();
}

void UndoStack::compact(UndoEntry &entry)
{
    if (entry.isReleased())
        return;
    entry.compact();
    entry.account();
}

bool UndoStack::canUndoFurther() const
{
    return index() > 0 && !entry(index() - 1)->isReleased();
}

int UndoStack::releasedCount() const
{
    int low = 0;
    int high = count();
    while (low < high) {
        const int middle = (low + high) / 2;
        if (entry(middle)->isReleased())
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

void UndoStack::setMemoryLimit(qint64 bytes)
{
    mLimit = bytes;
    keepLimit();
}

void UndoStack::keepLimit()
{
    for (int i = releasedCount(); *mTotal > mLimit && i < index() - 1; ++i) {
        UndoEntry *oldest = entry(i);
        Q_EMIT aboutToRelease(*oldest);
        oldest->clearContent();
        oldest->mReleased = true;
        oldest->setObsolete(true);
        oldest->account();
        if (cleanIndex() >= 0 && cleanIndex() <= i)
            resetClean();
    }
}

} // namespace autocuts
