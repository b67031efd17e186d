// The undo history with a memory limit.
//
// QUndoStack can only be limited by a number of entries, and only while it is empty. Here the oldest entries
// give up their contents when the limit is passed: they become obsolete, so that undoing one changes nothing
// and merely takes it off the stack, and canUndoFurther() says beforehand that there is nothing left to undo.
// The entries stay listed until then, because QUndoStack has no way to drop its oldest ones. They are always
// the lowest ones, so what is above them stays exactly undoable. The saved mark is taken away once it cannot
// be reached any more.
#pragma once

#include <QUndoStack>

#include <memory>
#include <memory_resource>

namespace autocuts {

class UndoStack;

//! An entry that knows how much memory it takes and how to do with less.
class UndoEntry : public QUndoCommand
{
public:
    ~UndoEntry() override;

    //! True once the contents were given up.
    bool isReleased() const { return mReleased; }

protected:
    //! Bytes held beyond the object itself, shared ones included.
    virtual qint64 contentBytes() const = 0;
    //! Called once no more merging is expected: the contents may be packed.
    virtual void compact() = 0;
    //! Gives up the contents. undo() may be called once more and must then change nothing.
    virtual void clearContent() = 0;

private:
    friend class UndoStack;

    void account();

    std::shared_ptr<qint64> mTotal; //!< of the stack it is on; outlives it
    qint64 mAccounted = 0;
    bool mReleased = false;
};

//! QUndoStack with a memory limit. Macros must not be used: every entry is an UndoEntry.
class UndoStack final : public QUndoStack
{
    Q_OBJECT

public:
    //! Size up to which pool() hands out blocks of its own.
    static constexpr qint64 poolBlockSize = 16 * 1024;
    static constexpr qint64 defaultMemoryLimit = qint64(400) * 1024 * 1024;

    explicit UndoStack(QObject *parent = nullptr);

    //! As QUndoStack::push(), which must not be called directly: packs the entry below and keeps the limit.
    void push(std::unique_ptr<UndoEntry> entry);

    //! True when an entry that still has its contents can be undone.
    bool canUndoFurther() const;
    //! The number of entries, counted from the oldest, that have given up their contents.
    int releasedCount() const;

    //! Bytes held by all entries.
    qint64 memoryUsed() const { return *mTotal; }
    qint64 memoryLimit() const { return mLimit; }
    //! The newest entry that is done is never given up, however large. \pre bytes >= 0
    void setMemoryLimit(qint64 bytes);

    //! Memory for the contents of entries, kept apart from everything that lives shortly.
    const std::shared_ptr<std::pmr::memory_resource> &pool() const { return mPool; }

    //! A number for one gesture, brush stroke or solver run: entries with the same one merge. Never 0.
    quint64 newGesture() { return ++mLastGesture; }

Q_SIGNALS:
    //! The oldest entry is about to give up its contents: it cannot be undone from now on, and a journal has
    //! to take it over.
    void aboutToRelease(const autocuts::UndoEntry &entry);

private:
    UndoEntry *entry(int index) const;
    void keepLimit();

    std::shared_ptr<qint64> mTotal = std::make_shared<qint64>(0);
    std::shared_ptr<std::pmr::memory_resource> mPool;
    qint64 mLimit = defaultMemoryLimit;
    quint64 mLastGesture = 0;
};

} // namespace autocuts
