#include "commands/setislandtag.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

SetIslandTag::SetIslandTag(Document &document, const QString &name, const std::vector<int> &islands, bool on)
    : ChangeValue(document, {}, {}), mName(name), mOn(on), mCount(static_cast<int>(islands.size()))
{
    if (const IslandTag *tag = document.marks().tag(name))
        mBefore = tag->faces;
    if (name.isEmpty() || name.size() > maxNameLength) {
        mAfter = mBefore;
        return;
    }
    QList<int> faces;
    for (int island : islands) {
        for (int face : document.islands().faces(island))
            faces.append(face);
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    if (on)
        std::set_union(mBefore.cbegin(), mBefore.cend(), faces.cbegin(), faces.cend(),
                       std::back_inserter(mAfter));
    else
        std::set_difference(mBefore.cbegin(), mBefore.cend(), faces.cbegin(), faces.cend(),
                            std::back_inserter(mAfter));
}

std::unique_ptr<SetIslandTag> SetIslandTag::remove(Document &document, const QString &name)
{
    auto command = std::make_unique<SetIslandTag>(document, name, std::vector<int>(), false);
    command->mAfter.clear();
    command->mCount = document.islands().count();
    return command;
}

QString SetIslandTag::label() const
{
    if (mOn)
        return UndoText::tr("Tag %n islands", nullptr, mCount);
    return UndoText::tr("Untag %n islands", nullptr, mCount);
}

void SetIslandTag::writePayload(QCborMap &map) const
{
    map["name"_L1] = mName;
    map["on"_L1] = mOn;
    map["count"_L1] = mCount;
    map["faces"_L1] = packedIntegers(mAfter);
}

std::unique_ptr<SetIslandTag> SetIslandTag::fromCbor(Document &document, CborReader &reader)
{
    const QString name = reader.text("name"_L1);
    const bool on = reader.boolean("on"_L1);
    const int count = static_cast<int>(reader.integer("count"_L1, 0, std::numeric_limits<int>::max()));
    const QList<int> faces = reader.indexSet("faces"_L1, document.mesh().faceCount());
    if (reader.failed() || name.isEmpty())
        return nullptr;
    auto command = std::make_unique<SetIslandTag>(document, name, std::vector<int>(), on);
    command->mCount = count;
    command->mAfter = faces;
    return command;
}

} // namespace autocuts
