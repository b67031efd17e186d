#include "commands/setislandflags.h"

#include <algorithm>
#include <limits>
#include <map>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The lowest positive number that no face uses.
std::int32_t freeNumber(const std::vector<IslandFlags> &flags, std::int32_t IslandFlags::*field)
{
    std::vector<std::int32_t> used;
    for (const IslandFlags &f : flags)
        used.push_back(f.*field);
    std::sort(used.begin(), used.end());
    std::int32_t number = 1;
    for (std::int32_t u : used)
        number += u == number;
    return number;
}

//! Takes islands out of stacks or groups whose other islands have left them.
void releaseLast(const Islands &islands, const std::vector<IslandFlags> &before,
                 std::vector<IslandFlags> &after, std::int32_t IslandFlags::*field)
{
    struct Members
    {
        int before = 0, after = 0, last = -1;
    };
    std::map<std::int32_t, Members> members;
    for (int island = 0; island < islands.count(); ++island) {
        const int face = islands.faces(island).front();
        ++members[before[face].*field].before;
        Members &now = members[after[face].*field];
        ++now.after;
        now.last = island;
    }
    members.erase(0);
    for (const auto &[number, of] : members) {
        if (of.before < 2 || of.after != 1)
            continue;
        for (const int face : islands.faces(of.last))
            after[face].*field = 0;
    }
}

IslandFlags edited(IslandFlags flags, SetIslandFlags::Edit edit, std::int32_t number)
{
    switch (edit) {
    case SetIslandFlags::Edit::Lock:
    case SetIslandFlags::Edit::Unlock:
        flags.locked = edit == SetIslandFlags::Edit::Lock;
        break;
    case SetIslandFlags::Edit::Stack:
    case SetIslandFlags::Edit::Unstack:
        flags.stack = number;
        break;
    case SetIslandFlags::Edit::Group:
    case SetIslandFlags::Edit::Ungroup:
        flags.group = number;
        break;
    case SetIslandFlags::Edit::Clear:
        flags = {};
        break;
    case SetIslandFlags::Edit::KeepOrientation:
    case SetIslandFlags::Edit::FreeOrientation:
        flags.upright = edit == SetIslandFlags::Edit::KeepOrientation;
        flags.aligned = flags.upright != 0 ? flags.aligned : 0;
        break;
    }
    return flags;
}

} // namespace

SetIslandFlags::SetIslandFlags(Document &document, Edit edit, const std::vector<int> &islands)
    : ChangeElements(document), mEdit(edit)
{
    const std::vector<IslandFlags> &flags = document.marks().faceFlags;
    std::int32_t number = 0;
    if (edit == Edit::Stack)
        number = freeNumber(flags, &IslandFlags::stack);
    else if (edit == Edit::Group)
        number = freeNumber(flags, &IslandFlags::group);
    std::vector<IslandFlags> after = flags;
    for (int island : islands) {
        bool changes = false;
        for (const int face : document.islands().faces(island)) {
            after[face] = edited(flags[face], edit, number);
            changes = changes || after[face] != flags[face];
        }
        mCount += changes;
    }
    setFlags(after);
}

void SetIslandFlags::setFlags(std::vector<IslandFlags> after)
{
    const std::vector<IslandFlags> &before = document().marks().faceFlags;
    for (const auto field : {&IslandFlags::stack, &IslandFlags::group})
        releaseLast(document().islands(), before, after, field);
    const IndexRanges all = IndexRanges::all(static_cast<int>(before.size()));
    mDelta = XorDelta::between<IslandFlags>(before.data(), all, after);
}

std::unique_ptr<SetIslandFlags> SetIslandFlags::stackEach(Document &document,
                                                          const std::vector<std::vector<int>> &stacks)
{
    auto command = std::make_unique<SetIslandFlags>(document, Edit::Stack, std::vector<int>());
    const std::vector<IslandFlags> &before = document.marks().faceFlags;
    std::vector<IslandFlags> after = before;
    for (const std::vector<int> &stack : stacks) {
        // Determined again for each stack, so that all stacks get different numbers.
        const std::int32_t number = freeNumber(after, &IslandFlags::stack);
        for (int island : stack) {
            for (int face : document.islands().faces(island))
                after[face].stack = number;
        }
        command->mCount += static_cast<int>(stack.size());
    }
    command->setFlags(std::move(after));
    return command;
}

std::unique_ptr<SetIslandFlags> SetIslandFlags::clearAll(Document &document)
{
    auto command = std::make_unique<SetIslandFlags>(document, Edit::Clear, std::vector<int>());
    const std::vector<IslandFlags> &flags = document.marks().faceFlags;
    const IndexRanges all = IndexRanges::all(static_cast<int>(flags.size()));
    const std::vector<IslandFlags> none(flags.size());
    command->mDelta = XorDelta::between<IslandFlags>(flags.data(), all, none);
    command->mCount = document.islands().count();
    return command;
}

void SetIslandFlags::apply()
{
    editor().setFaceFlags(mDelta.indices(), mDelta.applied(document().marks().faceFlags.data()));
}

QString SetIslandFlags::label() const
{
    switch (mEdit) {
    case Edit::Lock:
        return UndoText::tr("Lock %n islands", nullptr, mCount);
    case Edit::Unlock:
        return UndoText::tr("Unlock %n islands", nullptr, mCount);
    case Edit::Stack:
        return UndoText::tr("Stack %n islands", nullptr, mCount);
    case Edit::Unstack:
        return UndoText::tr("Unstack %n islands", nullptr, mCount);
    case Edit::Group:
        return UndoText::tr("Group %n islands", nullptr, mCount);
    case Edit::Ungroup:
        return UndoText::tr("Ungroup %n islands", nullptr, mCount);
    case Edit::KeepOrientation:
        return UndoText::tr("Keep orientation of %n islands", nullptr, mCount);
    case Edit::FreeOrientation:
        return UndoText::tr("Free orientation of %n islands", nullptr, mCount);
    case Edit::Clear:
        break;
    }
    return UndoText::tr("Clear flags of %n islands", nullptr, mCount);
}

void SetIslandFlags::writePayload(QCborMap &map) const
{
    map["edit"_L1] = static_cast<int>(mEdit);
    map["count"_L1] = mCount;
    mDelta.write(map);
}

std::unique_ptr<SetIslandFlags> SetIslandFlags::fromCbor(Document &document, CborReader &reader)
{
    const Edit edit = reader.enumerator("edit"_L1, Edit::FreeOrientation);
    const int count = static_cast<int>(reader.integer("count"_L1, 0, std::numeric_limits<int>::max()));
    XorDelta delta = XorDelta::read(reader, sizeof(IslandFlags), document.mesh().faceCount());
    const std::vector<IslandFlags> flags = delta.applied(document.marks().faceFlags.data());
    if (reader.failed() ||
        !std::all_of(flags.begin(), flags.end(), [](const IslandFlags &f) { return isValid(f); }))
        return nullptr;
    auto command = std::make_unique<SetIslandFlags>(document, edit, std::vector<int>());
    command->mCount = count;
    command->mDelta = std::move(delta);
    return command;
}

} // namespace autocuts
