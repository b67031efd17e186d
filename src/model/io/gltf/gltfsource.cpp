#include "model/io/gltf/gltfsource.h"

namespace autocuts {

bool isGltfFormat(const QString &format)
{
    return format == QLatin1String("gltf") || format == QLatin1String("glb");
}

QString gltfUvSetName(int texcoord)
{
    return texcoord == 0 ? QStringLiteral("UVMap") : QStringLiteral("UVMap%1").arg(texcoord + 1);
}

const GltfSource *gltfSourceOf(const Scene &scene)
{
    const auto *source = dynamic_cast<const GltfSource *>(scene.source.get());
    const bool fits =
        source && !source->pieces.empty() &&
        source->pieces.back().firstFace + source->pieces.back().faceCount == scene.mesh->faceCount();
    return fits ? source : nullptr;
}

} // namespace autocuts
