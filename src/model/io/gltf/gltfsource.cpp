#include "model/io/gltf/gltfsource.h"

namespace autocuts {

QString gltfUvSetName(int texcoord)
{
    return texcoord == 0 ? QStringLiteral("UVMap") : QStringLiteral("UVMap%1").arg(texcoord + 1);
}

} // namespace autocuts
