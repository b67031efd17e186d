#include "model/io/exportlosses.h"

#include "model/io/assimpscene.h"
#include "model/io/collada/colladasource.h"
#include "model/io/gltf/gltfwriter.h"
#include "model/io/objsource.h"

namespace autocuts {

namespace {

//! True when the active set has UVs at some corners but not at all of them.
bool hasPartialUv(const Scene &scene)
{
    if (!scene.hasUv())
        return false;
    const UvMatrix &uv = scene.uvSets.front().uv;
    return !uv.allFinite();
}

void addObjLosses(QStringList &losses, const Scene &scene)
{
    if (scene.uvSets.size() > 1)
        losses
            << QStringLiteral("OBJ holds one UV set: only \"%1\" is written").arg(scene.uvSets.front().name);
    if (!scene.materialNames.empty())
        losses << QStringLiteral("of the materials only the names are written");
    losses << QStringLiteral("normals and vertex colours are lost");
}

void addPlyLosses(QStringList &losses, const Scene &scene)
{
    if (scene.objectNames.size() > 1)
        losses << QStringLiteral("PLY holds one object: all are joined");
    if (!scene.materialNames.empty())
        losses << QStringLiteral("materials are lost");
    if (scene.uvSets.size() > 1)
        losses
            << QStringLiteral("PLY holds one UV set: only \"%1\" is written").arg(scene.uvSets.front().name);
}

} // namespace

QStringList exportLosses(const Scene &scene, const QString &format)
{
    QStringList losses;
    const bool isObj = format == QLatin1String("obj");
    const bool isPly = format == QLatin1String("ply");
    const auto *assimp = dynamic_cast<const AssimpSource *>(scene.source.get());
    const auto *obj = dynamic_cast<const ObjSource *>(scene.source.get());
    if (isObj && obj) {
        if (scene.uvSets.size() > 1)
            losses << QStringLiteral("OBJ holds one UV set: only \"%1\" is written")
                          .arg(scene.uvSets.front().name);
        return losses;
    }
    const GltfSource *gltf = gltfSourceOf(scene);
    if (gltf && isGltfFormat(format))
        return gltfLosses(*gltf, scene);
    if (const ColladaSource *collada = colladaSourceOf(scene); collada && format == QLatin1String("dae"))
        return colladaLosses(*collada, scene);
    if (gltf)
        losses << contentLosses(gltf->contents, format);
    if (assimp)
        losses << assimpLosses(*assimp, format);
    if (isObj) {
        addObjLosses(losses, scene);
        return losses;
    }
    if (obj)
        losses << QStringLiteral(
            "comments, groups, smoothing groups and material libraries of the OBJ file are lost");
    if (isPly)
        addPlyLosses(losses, scene);
    if (isGltfFormat(format) && scene.mesh->report.polygons > 0)
        losses << QStringLiteral("glTF holds triangles only: polygons are split");
    if (format == QLatin1String("fbx"))
        losses << QStringLiteral("the file is ASCII FBX, which Blender does not read: use glb or dae for it");
    if (scene.uvSets.size() > maxAssimpUvSets)
        losses << QStringLiteral("UV sets after the eighth are lost");
    if (hasPartialUv(scene))
        losses << QStringLiteral("corners without UV get the UV 0 0");
    losses << (format == QLatin1String("fbx")
                   ? QStringLiteral("positions and UVs are rounded to six decimals")
                   : QStringLiteral("positions and UVs are rounded to single precision"));
    return losses;
}

} // namespace autocuts
