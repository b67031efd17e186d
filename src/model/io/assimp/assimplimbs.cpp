#include "model/io/assimp/assimplimbs.h"

#include <assimp/scene.h>

#include <utility>

namespace autocuts {

namespace {

constexpr const char *limbKey = "autocuts.limb";

} // namespace

void markLimb(aiNode &node)
{
    if (!node.mMetaData)
        node.mMetaData = new aiMetadata;
    node.mMetaData->Add(limbKey, true);
}

std::set<std::string> takeLimbs(aiNode &node)
{
    std::set<std::string> limbs;
    aiMetadata *data = node.mMetaData;
    const unsigned last = data && data->mNumProperties > 0 ? data->mNumProperties - 1 : 0; // markLimb()'s
    if (data && data->mNumProperties > 0 && data->mKeys[last] == aiString(limbKey) &&
        data->mValues[last].mType == AI_BOOL) {
        limbs.insert(node.mName.C_Str());
        delete static_cast<bool *>(std::exchange(data->mValues[last].mData, nullptr));
        data->mNumProperties = last;
        if (last == 0)
            delete std::exchange(node.mMetaData, nullptr);
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c)
        limbs.merge(takeLimbs(*node.mChildren[c]));
    return limbs;
}

} // namespace autocuts
