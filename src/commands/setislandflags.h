// Commands that lock, stack and group islands, and keep their orientation.
#pragma once

#include "commands/changeelements.h"

namespace autocuts {

//! Sets one of the flags of islands, on all of their faces.
class SetIslandFlags final : public ChangeElements
{
public:
    //! Stored in journals by number.
    enum class Edit { Lock, Unlock, Stack, Unstack, Group, Ungroup, Clear, KeepOrientation, FreeOrientation };

    //! Stack and Group put all islands into one new stack or group; Clear removes all flags. An island that
    //! all others of its stack or group leave is taken out of it as well, here and by stackEach(). \param
    //! islands indices in Document::islands(), in any order
    SetIslandFlags(Document &document, Edit edit, const std::vector<int> &islands);

    CommandId commandId() const override { return CommandId::SetIslandFlags; }
    static std::unique_ptr<SetIslandFlags> fromCbor(Document &document, CborReader &reader);
    //! Makes one new stack of each list of islands.
    static std::unique_ptr<SetIslandFlags> stackEach(Document &document,
                                                     const std::vector<std::vector<int>> &stacks);
    //! Clears the flags of all faces, including faces without UVs.
    static std::unique_ptr<SetIslandFlags> clearAll(Document &document);

protected:
    void apply() override;
    bool absorb(const DocumentCommand &) override { return false; }
    void writePayload(QCborMap &map) const override;
    QString label() const override;

private:
    void setFlags(std::vector<IslandFlags> after);

    Edit mEdit;
    int mCount = 0; //!< islands whose flags change
};

} // namespace autocuts
