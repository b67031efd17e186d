// The command that stacks identical islands and takes stacks apart.
#pragma once

#include "commands/commandgroup.h"
#include "commands/setislandflags.h"
#include "commands/setuvs.h"

namespace autocuts {

//! Gives copies of an island the UVs of that island and makes them one stack, so that packing moves them
//! together; or takes stacks apart. Changes UVs and flags as one entry.
class StackIslands final : public CommandGroup
{
public:
    //! The result of copiesAmong().
    struct Found
    {
        //! Islands that are copies of each other; the one that stays in place comes first.
        std::vector<std::vector<int>> stacks;
        int mirrored = 0; //!< number of islands in them that will lie as mirror images
    };

    //! Finds stacks of copies among the islands; for a single island, all of its copies. The island of each
    //! stack that stays in place is a locked one, or else the one with the lowest number.
    static Found copiesAmong(const Document &document, const std::vector<int> &islands);

    //! Moves the islands of each stack onto its first one; mirrored copies are turned over for that. Other
    //! locked islands are left out.
    static std::unique_ptr<StackIslands> stack(Document &document,
                                               const std::vector<std::vector<int>> &stacks);
    //! Removes the islands from their stacks. Islands that lie on another one of the same stack are placed in
    //! a row beside the map, and turned over again where they are mirrored. Locked islands stay.
    static std::unique_ptr<StackIslands> unstack(Document &document, const std::vector<int> &islands);

    StackIslands(Document &document, std::unique_ptr<SetUvs> uvs, std::unique_ptr<SetIslandFlags> flags);

    CommandId commandId() const override { return CommandId::StackIslands; }
    static std::unique_ptr<StackIslands> fromCbor(Document &document, CborReader &reader);

protected:
    void writePayload(QCborMap &map) const override;
    QString label() const override { return labelOf(1); }
};

} // namespace autocuts
