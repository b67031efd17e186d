// Fuzzes the glTF reader and rewriter: any bytes are refused, or give a valid mesh of which nothing is
// written anew while its UVs stay, and which with other UVs gives as many faces again.
#include "fuzz/fuzzing.h"
#include "model/io/gltf/gltfreader.h"
#include "model/io/gltf/gltfrewriter.h"
#include "support/objcases.h"

#include <cstdint>

using namespace autocuts;
using fuzz::require;

namespace {

//! One triangle with UVs, a morph target and a sparse accessor.
constexpr const char *triangle = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0,"scale":[1,2,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},
"indices":2,"targets":[{"POSITION":3}]}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"},
{"bufferView":2,"componentType":5121,"count":3,"type":"SCALAR"},
{"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,0,0],"sparse":{"count":1,
"indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":0}}}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24},
{"buffer":0,"byteOffset":60,"byteLength":3}],
"buffers":[{"byteLength":63,"uri":"data:application/octet-stream;base64,)";

QByteArray triangleGltf()
{
    const float numbers[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1};
    QByteArray data(reinterpret_cast<const char *>(numbers), sizeof numbers);
    data.append("\0\1\2", 3);
    return triangle + data.toBase64() + "\"}]}";
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    GltfFile file{triangleGltf(), {}};
    fuzz::writeSeed(QStringLiteral("triangle.gltf"), file.main);
    GltfDocument document = openGltf(file);
    document.json["buffers"][0].erase("uri");
    fuzz::writeSeed(QStringLiteral("triangle.glb"), glbBytes(std::move(document)));
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    GltfFile file{{reinterpret_cast<const char *>(data), static_cast<qsizetype>(size)}, {}};
    Result<Scene> scene = parseGltf(file, QStringLiteral("fuzz.glb"));
    if (!scene)
        return 0;
    require(scene->mesh->validate().empty(), "the mesh is not valid");
    const GltfSource *source = sourceOf<GltfSource>(scene.value());
    if (!source)
        return 0;
    require(!rewriteGltf(*source, scene.value()), "unchanged UVs are written");
    test::setNewUvs(scene.value());
    std::optional<GltfDocument> document;
    try {
        document = rewriteGltf(*source, scene.value());
    } catch (const GltfError &) {
        return 0; // what else belongs to the vertices is damaged
    }
    require(document.has_value(), "changed UVs are not written");
    for (Json &buffer : document->json["buffers"])
        buffer.erase("uri"); // of the old data
    const Result<Scene> again = parseGltf({glbBytes(std::move(*document)), {}}, QStringLiteral("again.glb"));
    require(again.ok(), "the written file cannot be read");
    require(again->mesh->faceCount() == scene->mesh->faceCount(), "the faces differ");
    return 0;
}
