// Fuzzes the OBJ reader and writer: any bytes are refused, or give a valid mesh that is written with the same
// bytes, and with other UVs gives the same mesh again.
#include "fuzz/fuzzing.h"
#include "model/io/obj/objreader.h"
#include "model/io/obj/objwriter.h"
#include "model/plain/uvlayout.h"
#include "support/objcases.h"

#include <cstdint>

using namespace autocuts;
using fuzz::require;

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    fuzz::writeSeed(QStringLiteral("triangle"), test::triangleObj);
    fuzz::writeSeed(QStringLiteral("nasty"), test::nastyObj);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    Result<Scene> scene = parseObj(bytes, QStringLiteral("fuzz.obj"));
    if (!scene)
        return 0;
    require(scene->mesh->validate().empty(), "the mesh is not valid");
    require(objBytes(scene.value()) == bytes, "writing changes bytes");
    test::setNewUvs(scene.value());
    const Result<Scene> again = parseObj(objBytes(scene.value()), QStringLiteral("again.obj"));
    require(again.ok(), "the written file cannot be read");
    require(sameBits(again->uvSets.at(0).uv, scene->uvSets.at(0).uv), "the UVs are not written exactly");
    require(again->mesh->cornerVertex == scene->mesh->cornerVertex, "the faces differ");
    return 0;
}
