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
#include <limits>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

Result<Scene> readForeign(const QString &path, const std::atomic<bool> *stop)
{
    return readWithAssimp(path, stop);
}

constexpr std::size_t anyNumber = std::numeric_limits<std::size_t>::max();

FormatLimits objLimits()
{
    FormatLimits limits{u"OBJ"_s};
    limits.nodes = limits.normals = false;
    limits.smoothing = limits.partialUvs = limits.comments = limits.doubles = true;
    limits.uvSets = 1;
    return limits;
}

FormatLimits fbxLimits()
{
    FormatLimits limits{u"FBX"_s};
    limits.smoothing = limits.partialUvs = limits.doubles = true;
    limits.uvSets = anyNumber;
    return limits;
}

FormatLimits gltfLimits()
{
    FormatLimits limits{u"glTF"_s};
    limits.polygons = false;
    limits.roughness = RoughnessPictures::AsGltf;
    return limits;
}

FormatLimits colladaLimits()
{
    FormatLimits limits{u"Collada"_s};
    limits.animations = false;
    limits.roughness = RoughnessPictures::None;
    return limits;
}

FormatLimits plyLimits()
{
    FormatLimits limits{u"PLY"_s};
    limits.nodes = limits.objects = limits.materials = false;
    limits.uvSets = 1;
    return limits;
}

} // namespace

const FormatCalls &callsOf(const QString &suffix)
{
    static const std::vector<FormatCalls> rows{
        {u"obj"_s, readObj, writeObj, false, filesBesideObj, objLimits()},
        {u"fbx"_s, readFbx, writeNewFbx, true, nullptr, fbxLimits()},
        {u"glb"_s, readGltf, writeNewGltf, true, filesBesideGltf, gltfLimits()},
        {u"gltf"_s, readGltf, writeNewGltf, true, filesBesideGltf, gltfLimits()},
        {u"dae"_s, readColladaFile, writeNewCollada, true, filesBesideCollada, colladaLimits()},
        {u"ply"_s, readForeign, writePly, true, nullptr, plyLimits()},
        {QString(), readForeign},
    };
    const auto found = std::ranges::find(rows, suffix, &FormatCalls::suffix);
    return found == rows.end() ? rows.back() : *found;
}

} // namespace autocuts
