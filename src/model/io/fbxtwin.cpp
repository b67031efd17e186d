#include "model/io/fbxtwin.h"

#include "model/io/assimpmatch.h"

namespace autocuts {

std::optional<Scene> assimpTwin(const Scene &scene, const FbxSource &source)
{
    // Assimp reads files from version 7.1 on.
    Eigen::Matrix4d placement = Eigen::Matrix4d::Identity();
    placement.topLeftCorner<3, 3>() = source.space.metres * source.space.axes;
    std::optional<Scene> twin = source.version >= 7100
                                    ? asAssimpReads(scene, source.bytes, QStringLiteral("fbx"), placement)
                                    : std::nullopt;
    source.twin = twin ? FbxTwin::Found : FbxTwin::None;
    return twin;
}

} // namespace autocuts
