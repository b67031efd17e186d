#include "model/io/fbxtwin.h"

#include "model/io/assimpmatch.h"

namespace autocuts {

std::optional<Scene> assimpTwin(const Scene &scene, const FbxSource &source)
{
    // Assimp reads files from version 7.1 on.
    std::optional<Scene> twin =
        source.version >= 7100 ? asAssimpReads(scene, source.bytes, QStringLiteral("fbx")) : std::nullopt;
    source.twin = twin ? FbxTwin::Found : FbxTwin::None;
    return twin;
}

} // namespace autocuts
