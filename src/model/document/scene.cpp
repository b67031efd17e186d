#include "model/document/scene.h"

namespace autocuts {

bool Scene::hasUv() const
{
    if (uvSets.empty())
        return false;
    const UvMatrix &uv = uvSets.front().uv;
    for (Eigen::Index i = 0; i < uv.rows(); ++i) {
        if (uv.row(i).allFinite())
            return true;
    }
    return false;
}

TextureSet Scene::fileSet(int material) const
{
    const auto place = static_cast<std::size_t>(material);
    TextureSet set = material >= 0 && place < materialSets.size() ? materialSets[place] : TextureSet();
    if (material >= 0 && place < materialTextures.size() && !materialTextures[place].isEmpty())
        set[TextureChannel::BaseColor].picture = materialTextures[place];
    return set;
}

} // namespace autocuts
