#include "commands/edittextures.h"

#include "model/pictures/texturefiles.h"

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

int pictureCount(const std::vector<TextureSet> &sets)
{
    std::size_t count = 0;
    for (const TextureSet &set : sets)
        count += set.size();
    return static_cast<int>(count);
}

std::size_t mostSets(const Document &document)
{
    return document.state().scene.materialNames.size() + 1;
}

} // namespace

EditTextures::EditTextures(Document &document, std::vector<TextureSet> sets, Origin origin)
    : ChangeValue(document, document.state().textureSets, withoutEmptyEnd(std::move(sets))), mOrigin(origin),
      mIsFirst(!hasTextures(document.state()))
{
    if (!validateTextureSets(mAfter, mostSets(document)).isEmpty())
        mAfter = mBefore;
    for (TextureSet &set : mAfter) {
        for (auto &[channel, entry] : set)
            entry.picture.content.clear();
    }
}

std::unique_ptr<EditTextures> EditTextures::ofMaterial(Document &document, int material, TextureSet set)
{
    std::vector<TextureSet> sets = document.state().textureSets;
    const auto place = static_cast<std::size_t>(std::max(material, -1) + 1);
    if (place < mostSets(document)) {
        sets.resize(std::max(sets.size(), place + 1));
        sets[place] = std::move(set);
    }
    return std::make_unique<EditTextures>(document, std::move(sets));
}

QString EditTextures::label() const
{
    if (mOrigin == Origin::Carried)
        return UndoText::tr("Carry textures over");
    if (mOrigin == Origin::Baked)
        return UndoText::tr("Bake");
    const int more = pictureCount(mAfter) - pictureCount(mBefore);
    if (mAfter.empty())
        return UndoText::tr("Remove all chosen textures");
    return more > 0 ? UndoText::tr("Add %n textures", nullptr, more) : UndoText::tr("Change textures");
}

qint64 EditTextures::payloadBytes() const
{
    qint64 bytes = 0;
    for (const std::vector<TextureSet> *sets : {&mBefore, &mAfter}) {
        for (const TextureSet &set : *sets) {
            for (const auto &[channel, entry] : set)
                bytes += qint64(sizeof(entry)) + 2 * entry.picture.file.size();
        }
    }
    return bytes;
}

void EditTextures::writePayload(QCborMap &map) const
{
    map["sets"_L1] = autocuts::toCbor(mAfter);
    if (mOrigin != Origin::Chosen)
        map[mOrigin == Origin::Carried ? "carried"_L1 : "baked"_L1] = true;
}

std::unique_ptr<EditTextures> EditTextures::fromCbor(Document &document, CborReader &reader)
{
    const auto sets = readTextureSets(reader.array("sets"_L1), mostSets(document));
    if (reader.failed() || !sets)
        return nullptr;
    const Origin origin = reader.contains("carried"_L1) ? Origin::Carried
                          : reader.contains("baked"_L1) ? Origin::Baked
                                                        : Origin::Chosen;
    return std::make_unique<EditTextures>(document, *sets, origin);
}

} // namespace autocuts
