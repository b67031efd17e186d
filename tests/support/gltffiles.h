// Small glTF files of all kinds, and what is compared of them.
#pragma once

#include "model/io/gltf/gltffile.h"
#include "model/io/gltf/gltfreader.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gltffiles {

using namespace autocuts;

constexpr int gridSize = 4;
constexpr int gridVertices = (gridSize + 1) * (gridSize + 1);

//! Puts a glTF file together.
struct FileBuilder
{
    Json json{{"asset", {{"version", "2.0"}, {"extras", {{"kept", 1.5}}}}}, {"unknown", {"kept", 7}}};
    QByteArray buffer;

    int addView(const QByteArray &bytes, int stride = 0)
    {
        buffer.append(-buffer.size() & 3, '\0');
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
        if (stride > 0)
            json["bufferViews"].back()["byteStride"] = stride;
        buffer.append(bytes);
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }
    int addAccessor(int view, const char *type, int componentType, std::size_t count)
    {
        json["accessors"].push_back({{"bufferView", view},
                                     {"componentType", componentType},
                                     {"count", count},
                                     {"type", type},
                                     {"name", "accessor " + std::to_string(json["accessors"].size())}});
        return static_cast<int>(json["accessors"].size()) - 1;
    }
    template <typename T>
    int add(const std::vector<T> &values, const char *type, int componentType, std::size_t components)
    {
        const QByteArray bytes(reinterpret_cast<const char *>(values.data()),
                               static_cast<qsizetype>(values.size() * sizeof(T)));
        return addAccessor(addView(bytes), type, componentType, values.size() / components);
    }
    Json &primitive() { return json["meshes"][0]["primitives"][0]; }

    //! The .glb file.
    QByteArray glb() const
    {
        GltfDocument document{json, {buffer}, {}};
        document.json["buffers"] = {{{"byteLength", buffer.size()}}};
        return glbBytes(std::move(document));
    }
    //! The .gltf file. \param uri of the buffer; empty: a data URI
    QByteArray text(const std::string &uri = {}) const
    {
        Json whole = json;
        whole["buffers"] = {{{"byteLength", buffer.size()}, {"uri", uri.empty() ? dataUri(buffer) : uri}}};
        return jsonText(whole, "{\n  \"a\"");
    }
};

//! Values that differ from vertex to vertex.
template <typename T>
std::vector<T> counted(std::size_t components)
{
    std::vector<T> values;
    for (std::size_t i = 0; i < gridVertices * components; ++i)
        values.push_back(static_cast<T>(i * 7 % 251));
    return values;
}

std::vector<float> gridPositions();
//! A bumpy grid of 32 triangles with one UV set.
FileBuilder grid();
FileBuilder interleaved();
//! Normals, two colours, a joint each, custom data and a second UV set of normalized bytes.
FileBuilder manyAttributes();
FileBuilder skinned();
//! A dense morph target, and a sparse one without other data.
FileBuilder morphed();
//! A strip for each row of the grid, joined by triangles without area.
FileBuilder strip();
FileBuilder fan();
FileBuilder withoutIndices();
//! Two primitives with the same attributes, another one with the same positions only, and one of lines.
FileBuilder shared();
//! Two nodes with the mesh, one of them mirrored.
FileBuilder instanced();
Scene parsed(const QByteArray &bytes);
//! UVs with seams: some corners of a vertex agree, some do not.
UvMatrix seamyUv(const MeshData &mesh);
//! What differs between two files besides UVs; empty when nothing does.
QString differenceOf(GltfFile before, GltfFile after);
//! The largest difference of the UVs of two scenes; infinite when they do not correspond.
double uvDifference(const Scene &a, const Scene &b);
QByteArray contentOf(const QString &path);
//! The bytes of the scene as .glb.
QByteArray written(const Scene &scene);
Json jsonOf(const QByteArray &glb);
std::size_t vertexCount(const Json &json, std::size_t primitive = 0);

} // namespace gltffiles
