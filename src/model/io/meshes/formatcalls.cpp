#include "model/io/meshes/formatcalls.h"

#include "model/io/assimp/assimpreader.h"
#include "model/io/assimp/assimpwriter.h"
#include "model/io/collada/assimpcolladawriter.h"
#include "model/io/collada/colladasource.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxwriter.h"
#include "model/io/gltf/assimpgltfwriter.h"
#include "model/io/gltf/gltfreader.h"
#include "model/io/obj/objreader.h"
#include "model/io/obj/objwriter.h"

#include <algorithm>

namespace autocuts {

namespace {

Result<Scene> readForeign(const QString &path, const std::atomic<bool> *stop)
{
    return readWithAssimp(path, stop);
}

} // namespace

const FormatCalls &callsOf(const QString &suffix)
{
    static const std::vector<FormatCalls> rows{
        {QStringLiteral("obj"), readObj, writeObj, false, filesBesideObj},
        {QStringLiteral("fbx"), readFbx, writeNewFbx, true},
        {QStringLiteral("glb"), readGltf, writeNewGltf, true, filesBesideGltf},
        {QStringLiteral("gltf"), readGltf, writeNewGltf, true, filesBesideGltf},
        {QStringLiteral("dae"), readColladaFile, writeNewCollada, true, filesBesideCollada},
        {QStringLiteral("ply"), readForeign, writePly, true},
        {QString(), readForeign},
    };
    const auto found = std::ranges::find(rows, suffix, &FormatCalls::suffix);
    return found == rows.end() ? rows.back() : *found;
}

} // namespace autocuts
