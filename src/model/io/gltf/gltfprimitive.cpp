#include "model/io/gltf/gltfprimitive.h"

#include "model/io/gltf/gltfdraco.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace autocuts {

namespace {

enum Mode : std::size_t { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

std::size_t modeOf(const Json &primitive)
{
    return wholeNumber(primitive, "mode").value_or(Triangles);
}

const Json &dracoOf(const Json &primitive)
{
    return member(member(primitive, "extensions"), "KHR_draco_mesh_compression");
}

std::vector<std::uint32_t> indicesOf(GltfData &data, const Json &primitive, std::size_t vertexCount)
{
    const std::optional<std::size_t> accessor = wholeNumber(primitive, "indices");
    std::vector<std::uint32_t> indices;
    if (!accessor) {
        indices.resize(vertexCount);
        std::iota(indices.begin(), indices.end(), 0);
        return indices;
    }
    const GltfElements &elements = data.elements(*accessor);
    if (elements.components != 1 || elements.componentType == GltfElements::float32)
        throw GltfError("the indices of a mesh are not whole numbers");
    indices.reserve(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i)
        indices.push_back(static_cast<std::uint32_t>(std::max(elements.stored(i, 0), 0.0)));
    return indices;
}

//! Adds a triangle, unless it is one that a strip is joined by or one with a wrong index.
void addTriangle(GltfPrimitive &to, const std::array<std::uint32_t, 3> &t, bool isList)
{
    if (std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return v >= to.vertexCount; }))
        ++to.brokenTriangles;
    else if (isList || (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]))
        to.corners.insert(to.corners.end(), t.begin(), t.end());
}

void addTriangles(GltfPrimitive &to, const std::vector<std::uint32_t> &v, std::size_t mode)
{
    if (mode == Triangles) {
        for (std::size_t i = 0; i + 2 < v.size(); i += 3)
            addTriangle(to, {v[i], v[i + 1], v[i + 2]}, true);
        return;
    }
    for (std::size_t i = 0; i + 2 < v.size(); ++i) {
        if (mode == TriangleStrip)
            addTriangle(to, {v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]}, false);
        else
            addTriangle(to, {v[i + 1], v[i + 2], v[0]}, false);
    }
}

} // namespace

bool hasTriangles(const Json &primitive)
{
    return modeOf(primitive) >= Triangles && modeOf(primitive) <= TriangleFan;
}

std::size_t countPointsAndLines(GltfData &data, const Json &primitive)
{
    std::optional<std::size_t> accessor = wholeNumber(primitive, "indices");
    if (!accessor)
        accessor = wholeNumber(member(primitive, "attributes"), "POSITION");
    const std::size_t count =
        accessor ? emptyElements(element(data.json(), "accessors", *accessor)).count : 0;
    if (modeOf(primitive) == Lines)
        return count / 2;
    return modeOf(primitive) == LineStrip && count > 0 ? count - 1 : count;
}

GltfPrimitive readPrimitive(GltfData &data, const Json &primitive)
{
    GltfPrimitive result;
    const Json &draco = dracoOf(primitive);
    std::vector<std::uint32_t> compressed;
    if (!draco.is_null()) {
        DracoGeometry geometry =
            decodeDraco(data.json(), primitive, data.view(requiredNumber(draco, "bufferView")));
        result.attributes = std::move(geometry.attributes);
        compressed = std::move(geometry.corners);
    }
    const Json &attributes = member(primitive, "attributes");
    for (const auto &[name, accessor] : attributes.items()) {
        if (!result.attributes.contains(name))
            result.attributes[name] = data.elements(requiredNumber(attributes, name.c_str()));
    }
    const auto position = result.attributes.find("POSITION");
    if (position == result.attributes.end())
        return result;
    result.vertexCount = position->second.count;
    for (const auto &[name, elements] : result.attributes) {
        if (elements.count != result.vertexCount)
            throw GltfError("the attributes of a mesh have different numbers of elements");
    }
    if (draco.is_null())
        addTriangles(result, indicesOf(data, primitive, result.vertexCount), modeOf(primitive));
    else
        addTriangles(result, compressed, Triangles);
    return result;
}

int texcoordNumber(const std::string &attribute)
{
    const bool fits = attribute.size() == 10 && attribute.starts_with("TEXCOORD_") && attribute[9] >= '0' &&
                      attribute[9] <= '7';
    return fits ? attribute[9] - '0' : -1;
}

std::string texcoordName(int set)
{
    return "TEXCOORD_" + std::to_string(set);
}

} // namespace autocuts
