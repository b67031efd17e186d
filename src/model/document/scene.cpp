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

} // namespace autocuts
