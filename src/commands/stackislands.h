// Laying identical islands on top of each other, and apart again.
#pragma once

#include "commands/setislandflags.h"
#include "commands/setuvs.h"

namespace autocuts {

//! Gives copies the UVs of the island that they are copies of and makes them one stack, so that packing keeps
//! them together; or takes stacks apart. One entry for UVs and flags.
class StackIslands final : public DocumentCommand
{
public:
    //! What stacking found.
    struct Found
    {
        std::vector<std::vector<int>> stacks; //!< islands that are copies; that which stays comes first
        int mirrored = 0;                     //!< islands left out because they are mirror images
    };

    //! Groups the islands into stacks of copies. One island alone: all its copies are looked for. In each
    //! stack a locked island stays where it is, else the one with the lowest number.
    static Found copiesAmong(const Document &document, const std::vector<int> &islands);

    //! Lays the islands of each stack of copiesAmong() on its first one. Locked ones stay and are left out.
    static std::unique_ptr<StackIslands> stack(Document &document,
                                               const std::vector<std::vector<int>> &stacks);
    //! Takes the islands out of their stacks; those that lie on another one of the same stack are laid beside
    //! the map, in a row. Locked ones stay.
    static std::unique_ptr<StackIslands> unstack(Document &document, const std::vector<int> &islands);

    StackIslands(Document &document, std::unique_ptr<SetUvs> uvs, std::unique_ptr<SetIslandFlags> flags);

    CommandId commandId() const override { return CommandId::StackIslands; }
    bool hasAnyChanges() const override { return mUvs->hasAnyChanges() || mFlags->hasAnyChanges(); }
    static Result<std::unique_ptr<DocumentCommand>> fromCbor(Document &document, CborReader &reader);

protected:
    void apply() override;
    void revert() override;
    void writePayload(QCborMap &map) const override;
    QString label() const override { return labelOfPart(*mFlags); }
    qint64 payloadBytes() const override { return bytesOfPart(*mUvs) + bytesOfPart(*mFlags); }
    void clearPayload() override;
    void compact() override;

private:
    std::unique_ptr<SetUvs> mUvs;
    std::unique_ptr<SetIslandFlags> mFlags;
};

} // namespace autocuts
