#include "model/io/gltf/gltfuniquemeshes.h"

#include "model/io/gltf/gltfnodes.h"

#include <set>

namespace autocuts {

GltfFile withUniqueMeshes(const GltfFile &file)
{
    GltfFile result = file;
    GltfDocument document = openGltf(result);
    std::set<std::size_t> used;
    for (const GltfMeshNode &node : meshNodes(document.json)) {
        if (used.insert(node.mesh).second)
            continue;
        Json &meshes = document.json["meshes"];
        document.json["nodes"][node.node]["mesh"] = meshes.size();
        meshes.push_back(Json(meshes[node.mesh]));
    }
    result.main = file.isBinary() ? glbBytes(std::move(document)) : jsonText(document.json, file.main);
    return result;
}

} // namespace autocuts
