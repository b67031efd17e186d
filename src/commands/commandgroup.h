// The base class of commands that consist of other commands.
#pragma once

#include "commands/documentcommand.h"

#include <memory>
#include <vector>

namespace autocuts {

//! Executes several commands as one entry of the history. They are made for the same state of the document,
//! so they must not depend on each other.
class CommandGroup : public DocumentCommand
{
public:
    bool hasAnyChanges() const final;

protected:
    using DocumentCommand::DocumentCommand;

    void add(std::unique_ptr<DocumentCommand> part) { mParts.push_back(std::move(part)); }
    QString labelOf(int part) const { return mParts[part]->label(); }
    QCborMap payloadOf(int part) const;
    //! Merges each part of a newer group into the part of this one at the same place.
    //! \pre both have the same kinds of parts
    bool absorbParts(const CommandGroup &newer);

    void apply() final;
    void revert() final;
    qint64 payloadBytes() const final;
    void clearPayload() final { mParts.clear(); }
    void compact() final;

private:
    std::vector<std::unique_ptr<DocumentCommand>> mParts;
};

} // namespace autocuts
