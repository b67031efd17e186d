#include "commands/commandgroup.h"

#include <algorithm>

namespace autocuts {

bool CommandGroup::hasAnyChanges() const
{
    return std::ranges::any_of(mParts, [](const auto &part) { return part->hasAnyChanges(); });
}

QCborMap CommandGroup::payloadOf(int part) const
{
    QCborMap map;
    mParts[part]->writePayload(map);
    return map;
}

bool CommandGroup::absorbParts(const CommandGroup &newer)
{
    for (std::size_t i = 0; i < mParts.size(); ++i) {
        if (!mParts[i]->absorb(*newer.mParts[i]))
            return false;
    }
    return true;
}

void CommandGroup::apply()
{
    for (const auto &part : mParts)
        part->apply();
}

void CommandGroup::revert()
{
    for (auto it = mParts.rbegin(); it != mParts.rend(); ++it)
        (*it)->revert();
}

qint64 CommandGroup::payloadBytes() const
{
    qint64 bytes = 0;
    for (const auto &part : mParts)
        bytes += part->payloadBytes() + qint64(sizeof(DocumentCommand));
    return bytes;
}

void CommandGroup::compact()
{
    for (const auto &part : mParts)
        part->compact();
}

} // namespace autocuts
