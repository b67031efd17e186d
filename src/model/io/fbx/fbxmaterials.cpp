#include "model/io/fbx/fbxmaterials.h"

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

//! The numbers of a layer element, one for each polygon.
std::vector<int> polygonNumbers(const FbxTree &tree, const FbxGeometry &geometry,
                                std::string_view elementName, std::string_view numbersName, int otherwise)
{
    std::vector<int> result(static_cast<std::size_t>(geometry.polygonCount()), otherwise);
    const int element = tree.child(geometry.node, elementName);
    const auto numbers = tree.integers(tree.child(element, numbersName));
    if (!numbers || numbers->empty())
        return result;
    if (tree.text(tree.child(element, "MappingInformationType")) == "AllSame")
        std::fill(result.begin(), result.end(), numbers->front());
    else if (numbers->size() >= result.size())
        std::copy_n(numbers->begin(), result.size(), result.begin());
    return result;
}

int entryOf(const std::vector<int> &list, int slot)
{
    return slot >= 0 && slot < std::ssize(list) ? list[static_cast<std::size_t>(slot)] : -1;
}

} // namespace

FbxFaceSlots readFbxFaceSlots(const FbxTree &tree, const FbxGeometry &geometry)
{
    return {polygonNumbers(tree, geometry, "LayerElementMaterial", "Materials", 0),
            polygonNumbers(tree, geometry, "LayerElementTexture", "TextureId", -1)};
}

FbxMaterials::FbxMaterials(FbxObjects &objects)
    : mObjects(objects), mSettled(objects.materialNames.size()), mOwn(objects.materialNames.size())
{
    for (std::size_t m = 0; m < objects.materialTextures.size(); ++m)
        mOwn[m] = !objects.materialTextures[m].isEmpty();
}

int FbxMaterials::of(const FbxModel &model, int materialSlot, int textureSlot)
{
    const int material = entryOf(model.materials, materialSlot);
    const int texture = entryOf(model.textures, textureSlot);
    if (material < 0 ? texture < 0 : mOwn[static_cast<std::size_t>(material)])
        return material;
    const auto [known, isNew] = mKnown.try_emplace({material, texture}, material);
    if (isNew)
        known->second = added(material, texture);
    return known->second;
}

//! The material itself when this is the first texture that is seen with it, or a new one.
int FbxMaterials::added(int material, int texture)
{
    const auto m = static_cast<std::size_t>(material);
    std::size_t target = m;
    if (material >= 0 && !mSettled[m]) {
        mSettled[m] = true;
    } else {
        target = mObjects.materialNames.size();
        const QString suffix =
            texture < 0 ? u"plain"_s : mObjects.textures[static_cast<std::size_t>(texture)].name;
        mObjects.materialNames.push_back(material < 0 ? suffix : mObjects.materialNames[m] + u'_' + suffix);
        mObjects.materialColors.push_back(material < 0 ? 0 : mObjects.materialColors[m]);
    }
    if (texture >= 0) {
        std::vector<SceneTexture> &pictures = mObjects.materialTextures;
        pictures.resize(std::max(pictures.size(), target + 1));
        pictures[target] = mObjects.textures[static_cast<std::size_t>(texture)].picture;
    }
    return static_cast<int>(target);
}

} // namespace autocuts
