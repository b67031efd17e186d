#include "model/io/gltf/gltfdraco.h"

#include <draco/compression/decode.h>

#include <memory>

namespace autocuts {

namespace {

template <typename T>
bool convert(const draco::PointAttribute &from, std::uint32_t points, GltfElements &to)
{
    std::vector<T> values(static_cast<std::size_t>(to.components));
    for (std::uint32_t p = 0; p < points; ++p) {
        const draco::AttributeValueIndex index = from.mapped_index(draco::PointIndex(p));
        if (index.value() >= from.size() ||
            !from.ConvertValue(index, static_cast<std::int8_t>(to.components), values.data()))
            return false;
        to.bytes.append(reinterpret_cast<const char *>(values.data()),
                        static_cast<qsizetype>(values.size() * sizeof(T)));
    }
    return true;
}

bool convert(const draco::PointAttribute &from, std::uint32_t points, GltfElements &to)
{
    switch (to.componentType) {
    case GltfElements::int8:
        return convert<std::int8_t>(from, points, to);
    case GltfElements::uint8:
        return convert<std::uint8_t>(from, points, to);
    case GltfElements::int16:
        return convert<std::int16_t>(from, points, to);
    case GltfElements::uint16:
        return convert<std::uint16_t>(from, points, to);
    case GltfElements::uint32:
        return convert<std::uint32_t>(from, points, to);
    default:
        return convert<float>(from, points, to);
    }
}

} // namespace

DracoGeometry decodeDraco(const Json &root, const Json &primitive, QByteArrayView compressed)
{
    const GltfError damaged("geometry that is compressed by KHR_draco_mesh_compression is damaged");
    draco::DecoderBuffer buffer;
    buffer.Init(compressed.data(), static_cast<std::size_t>(compressed.size()));
    auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok())
        throw damaged;
    const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
    DracoGeometry result;
    for (std::uint32_t f = 0; f < mesh->num_faces(); ++f) {
        for (std::size_t k = 0; k < 3; ++k)
            result.corners.push_back(mesh->face(draco::FaceIndex(f))[k].value());
    }
    const Json &ids =
        member(member(member(primitive, "extensions"), "KHR_draco_mesh_compression"), "attributes");
    for (const auto &[name, accessor] : member(primitive, "attributes").items()) {
        const std::optional<std::size_t> id = wholeNumber(ids, name.c_str());
        if (!id)
            continue;
        const draco::PointAttribute *attribute =
            mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(*id));
        const auto number = wholeNumber(member(primitive, "attributes"), name.c_str());
        GltfElements elements = emptyElements(element(root, "accessors", number.value_or(0)));
        elements.count = mesh->num_points();
        if (!attribute || elements.isMatrix || !convert(*attribute, mesh->num_points(), elements))
            throw damaged;
        result.attributes[name] = std::move(elements);
    }
    return result;
}

} // namespace autocuts
