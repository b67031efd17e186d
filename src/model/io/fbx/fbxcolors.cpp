#include "model/io/fbx/fbxcolors.h"

namespace autocuts {

std::shared_ptr<const CornerColors> fbxCornerColors(const FbxTree &tree, const MeshData &mesh,
                                                    const FbxSource &source, const FbxGeometries &geometries,
                                                    int &damaged)
{
    CornerColors colors;
    const auto corners = static_cast<std::size_t>(mesh.cornerCount());
    for (std::size_t u = 0; u < source.uses.size(); ++u) {
        const FbxGeometry &geometry = geometries[u];
        const int element = tree.child(geometry.node, "LayerElementColor");
        if (element < 0)
            continue;
        const auto values = readFbxLayer(tree, element, geometry, "Colors", "ColorIndex", 4);
        if (!values || (colors.empty() && !tree.take(qint64(sizeof(CornerColor)) * mesh.cornerCount()))) {
            ++damaged;
            continue;
        }
        colors.resize(corners);
        for (const FbxUse::Instance &instance : source.uses[u].instances) {
            const std::vector<int> soup = fbxSoupCorners(mesh, geometry, instance);
            for (int c = 0; c < geometry.cornerCount(); ++c) {
                if (soup[c] >= 0)
                    colors[static_cast<std::size_t>(soup[c])] =
                        CornerColor::fromSrgb((*values)(c, 0), (*values)(c, 1), (*values)(c, 2));
            }
        }
    }
    return sharedColors(std::move(colors), corners);
}

} // namespace autocuts
