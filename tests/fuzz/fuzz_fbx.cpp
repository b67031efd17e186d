// Fuzzes the FBX reader and rewriter: any bytes are refused, or give a valid mesh that is written with the
// same bytes, and with other UVs gives the same faces again.
#include "fuzz/fuzzing.h"
#include "model/io/fbx/fbxreader.h"
#include "model/io/fbx/fbxrewriter.h"
#include "model/io/fbx/fbxsource.h"
#include "support/fbxfiles.h"
#include "support/objcases.h"

#include <cstdint>

using namespace autocuts;
using fuzz::require;

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    int number = 0;
    for (const fbxfiles::Kind &kind : {fbxfiles::Kind{true, 6100}, fbxfiles::Kind{true, 7400},
                                       fbxfiles::Kind{true, 7700, true}, fbxfiles::Kind{false, 7500}}) {
        fbxfiles::Object object{"quads",
                                fbxfiles::quads({fbxfiles::uvElement(0, "UVMap"), fbxfiles::layer(0, {0})})};
        object.properties = {fbxfiles::property(kind, "Lcl Translation", {10, 0, 0})};
        object.materials = {"red"};
        fuzz::writeSeed(QStringLiteral("quads%1").arg(number++), fbxfiles::model(kind, {object}));
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    Result<Scene> scene = parseFbx(bytes, QStringLiteral("fuzz.fbx"));
    if (!scene)
        return 0;
    require(scene->mesh->validate().empty(), "the mesh is not valid");
    const FbxSource *source = sourceOf<FbxSource>(scene.value());
    require(source, "the source is missing");
    require(rewriteFbx(*source, scene.value()) == bytes, "writing changes bytes");
    test::setNewUvs(scene.value());
    const Result<Scene> again = parseFbx(rewriteFbx(*source, scene.value()), QStringLiteral("again.fbx"));
    require(again.ok(), "the written file cannot be read");
    require(again->mesh->cornerVertex == scene->mesh->cornerVertex, "the faces differ");
    return 0;
}
