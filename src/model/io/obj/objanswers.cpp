// What an ObjSource says of its file.
#include "model/io/obj/objmaterials.h"
#include "model/io/obj/objsource.h"
#include "model/io/obj/objwriter.h"

#include <QCoreApplication>

namespace autocuts {

bool ObjSource::isOf(const MeshData &mesh) const
{
    return std::ssize(cornerTextureVertex) == mesh.cornerCount();
}

SceneWriter ObjSource::rewriter(const QString &suffix) const
{
    return suffix == QLatin1String("obj") ? writeObj : nullptr;
}

QStringList ObjSource::rewritingLosses(const Scene &scene) const
{
    if (scene.uvSets.size() < 2)
        return {};
    return {QCoreApplication::translate("ExportLosses", "OBJ holds one UV set: only \"%1\" is written")
                .arg(scene.uvSets.front().name)};
}

std::vector<UvSet> ObjSource::uvSets(const Scene &scene) const
{
    return {{scene.uvSets.empty() ? QString() : scene.uvSets.front().name, originalUv()}};
}

QStringList ObjSource::filesBeside(const QString &path) const
{
    return materialFiles(bytes, path);
}

} // namespace autocuts
