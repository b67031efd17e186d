// An undo history with a memory limit.
//
// QUndoStack can only be limited to a number of entries, and only while it is empty. Here the oldest entries
// release their contents when the memory limit is passed. They become obsolete: undoing one changes nothing
// and only removes it from the stack. canUndoFurther() tells in advance that nothing is left to undo.
// Released entries stay listed, because QUndoStack cannot drop its oldest ones. They are always the lowest
// ones, so all entries above them can be undone exactly. The mark of the saved state is removed once that
// state cannot be reached any more.
#pragma once

#include <QUndoStack>

#include <memory>
#include <memory_resource>

namespace autocuts {

class UndoStack;

//! An entry that knows how much memory it takes and can release it.
class UndoEntry : public QUndoCommand
{
public:
    ~UndoEntry() override;

    //! True once the contents were released.
    bool isReleased() const { return mReleased; }

protected:
    //! Bytes held besides the object itself, including shared ones.
    virtual qint64 contentBytes() const = 0;
    //! Called when no more merging is expected: the entry may compress its contents.
    virtual void compact() = 0;
    //! Releases the contents. undo() may be called once more and must then change nothing.
    virtual void clearContent() = 0;

private:
    friend class UndoStack;

    void account();

    //! Sum of the stack that it is on; shared, because entries may outlive the stack.
    std::shared_ptr<qint64> mTotal;
    qint64 mAccounted = 0;
    bool mReleased = false;
};

//! A QUndoStack with a memory limit. Macros must not be used: every entry has to be an UndoEntry.
class UndoStack final : public QUndoStack
{
    Q_OBJECT

public:
    //! Blocks of up to this size, in bytes, come from the pool. Chosen by hand; its effect has not been
    //! measured.
    static constexpr qint64 poolBlockSize = 16 * 1024;
    static constexpr qint64 defaultMemoryLimit = qint64(400) * 1024 * 1024;

    explicit UndoStack(QObject *parent = nullptr);

    //! Use this instead of QUndoStack::push(). Also compacts the entry below and keeps the memory limit.
    void push(std::unique_ptr<UndoEntry> entry);

    //! True when the next entry to undo still has its contents.
    bool canUndoFurther() const;
    //! The number of entries, counted from the oldest, that have released their contents.
    int releasedCount() const;

    //! Bytes held by all entries.
    qint64 memoryUsed() const { return *mTotal; }
    qint64 memoryLimit() const { return mLimit; }
    //! The newest entry that is done is never released, however large. \pre bytes >= 0
    void setMemoryLimit(qint64 bytes);

    //! Memory for the contents of entries, separate from the heap: without the pool, short-lived blocks
    //! between them let the heap grow to about ten times its size.
    const std::shared_ptr<std::pmr::memory_resource> &pool() const { return mPool; }

    //! A new number for one gesture, brush stroke or solver run: entries with the same number merge. Never 0.
    quint64 newGesture() { return ++mLastGesture; }

Q_SIGNALS:
    //! The oldest entry is about to release its contents: it cannot be undone from now on. A journal has to
    //! store it now.
    void aboutToRelease(const autocuts::UndoEntry &entry);

private:
    UndoEntry *entry(int index) const;
    static void compact(UndoEntry &entry);
    void keepLimit();

    std::shared_ptr<qint64> mTotal = std::make_shared<qint64>(0);
    std::shared_ptr<std::pmr::memory_resource> mPool;
    qint64 mLimit = defaultMemoryLimit;
    quint64 mLastGesture = 0;
};

} // namespace autocuts
