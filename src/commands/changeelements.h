// The base class of commands that change elements of an array of the document.
#pragma once

#include "commands/documentcommand.h"
#include "commands/xordelta.h"

namespace autocuts {

//! Stores only the difference between the arrays before and after, so that undo and redo are the same: a
//! derived class sets the elements to mDelta.applied() in apply(). Commands of one gesture merge.
class ChangeElements : public DocumentCommand
{
public:
    bool hasAnyChanges() const final { return !mDelta.isEmpty(); }

protected:
    using DocumentCommand::DocumentCommand;

    void revert() final { apply(); }
    bool absorb(const DocumentCommand &newer) override
    {
        mDelta.combine(static_cast<const ChangeElements &>(newer).mDelta);
        return true;
    }
    qint64 payloadBytes() const final { return mDelta.byteCount(); }
    void clearPayload() final { mDelta = XorDelta(); }
    void compact() final { mDelta.pack(document().undoStack().pool()); }

    XorDelta mDelta;
};

} // namespace autocuts
