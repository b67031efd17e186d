#include "model/io/gltf/gltfelements.h"

#include "model/io/gltf/gltfmeshopt.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace autocuts {

namespace {

//! Accessors without data may take this many bytes, and as many for each byte of the buffers.
constexpr std::size_t zerosOfAnyFile = 64 << 20, zerosPerByte = 16;
constexpr std::size_t maxCount = std::numeric_limits<int>::max() / 8;

std::size_t componentSize(int type)
{
    switch (type) {
    case GltfElements::int8:
    case GltfElements::uint8:
        return 1;
    case GltfElements::int16:
    case GltfElements::uint16:
        return 2;
    case GltfElements::uint32:
    case GltfElements::float32:
        return 4;
    default:
        throw GltfError("an accessor has the unknown component type " + std::to_string(type));
    }
}

template <typename T>
double read(const char *from)
{
    T value;
    std::memcpy(&value, from, sizeof value);
    return static_cast<double>(value);
}

//! \pre begin <= range.size()
QByteArrayView sliced(QByteArrayView range, std::size_t begin, std::size_t size)
{
    const auto all = static_cast<std::size_t>(range.size());
    if (begin > all || size > all - begin)
        throw GltfError("an accessor or a buffer view is larger than its data");
    return range.sliced(static_cast<qsizetype>(begin), static_cast<qsizetype>(size));
}

} // namespace

double GltfElements::stored(std::size_t index, int component) const
{
    const char *from =
        at(index) + static_cast<std::size_t>(component) * (size / static_cast<std::size_t>(components));
    switch (componentType) {
    case int8:
        return read<std::int8_t>(from);
    case uint8:
        return read<std::uint8_t>(from);
    case int16:
        return read<std::int16_t>(from);
    case uint16:
        return read<std::uint16_t>(from);
    case uint32:
        return read<std::uint32_t>(from);
    default:
        return read<float>(from);
    }
}

double GltfElements::value(std::size_t index, int component) const
{
    const double number = stored(index, component);
    if (!normalized)
        return number;
    switch (componentType) {
    case int8:
        return std::max(number / 127, -1.0);
    case uint8:
        return number / 255;
    case int16:
        return std::max(number / 32767, -1.0);
    case uint16:
        return number / 65535;
    default:
        return number;
    }
}

GltfElements emptyElements(const Json &accessor)
{
    struct Form
    {
        const char *type;
        int components;
        std::size_t columns;
    };
    static constexpr std::array<Form, 7> forms{{{"SCALAR", 1, 0},
                                                {"VEC2", 2, 0},
                                                {"VEC3", 3, 0},
                                                {"VEC4", 4, 0},
                                                {"MAT2", 4, 2},
                                                {"MAT3", 9, 3},
                                                {"MAT4", 16, 4}}};
    const std::string type = textOf(accessor, "type");
    const auto form = std::find_if(forms.begin(), forms.end(), [&](const Form &f) { return type == f.type; });
    if (form == forms.end())
        throw GltfError("an accessor has the unknown type \"" + type.substr(0, 40) + '"');
    GltfElements result;
    result.componentType =
        static_cast<int>(std::min<std::size_t>(requiredNumber(accessor, "componentType"), 1 << 16));
    result.components = form->components;
    result.isMatrix = form->columns > 0;
    result.normalized = member(accessor, "normalized") == true;
    result.count = requiredNumber(accessor, "count");
    if (result.count > maxCount)
        throw GltfError("an accessor has too many elements");
    result.size = componentSize(result.componentType) * static_cast<std::size_t>(form->components);
    // Each column of a matrix starts at a multiple of four bytes.
    if (result.isMatrix)
        result.size = (result.size / form->columns + 3) / 4 * 4 * form->columns;
    return result;
}

GltfData::GltfData(const GltfDocument &document) : mDocument(document), mZerosLeft(zerosOfAnyFile)
{
    for (const QByteArray &buffer : document.buffers)
        mZerosLeft += zerosPerByte * static_cast<std::size_t>(buffer.size());
}

QByteArrayView GltfData::part(const Json &range) const
{
    const std::size_t buffer = requiredNumber(range, "buffer");
    if (buffer >= mDocument.buffers.size())
        throw GltfError("a buffer view refers to a buffer that is not there");
    return sliced(mDocument.buffers[buffer], wholeNumber(range, "byteOffset").value_or(0),
                  requiredNumber(range, "byteLength"));
}

QByteArrayView GltfData::view(std::size_t bufferView)
{
    const Json &range = element(json(), "bufferViews", bufferView);
    const Json &compression = member(member(range, "extensions"), "EXT_meshopt_compression");
    if (compression.is_null())
        return part(range);
    const auto known = mDecompressed.find(bufferView);
    if (known != mDecompressed.end())
        return known->second;
    return mDecompressed[bufferView] = decodeMeshopt(compression, part(compression));
}

void GltfData::fill(GltfElements &elements, const Json &accessor)
{
    const std::optional<std::size_t> number = wholeNumber(accessor, "bufferView");
    const std::size_t total = elements.count * elements.size;
    if (!number) {
        if (total > mZerosLeft)
            throw GltfError("an accessor without data has too many elements");
        mZerosLeft -= total;
        elements.bytes = QByteArray(static_cast<qsizetype>(total), '\0');
        return;
    }
    const QByteArrayView bytes = view(*number);
    const std::size_t offset = wholeNumber(accessor, "byteOffset").value_or(0);
    const std::size_t stride =
        wholeNumber(element(json(), "bufferViews", *number), "byteStride").value_or(elements.size);
    if (stride == elements.size) {
        elements.bytes = sliced(bytes, offset, total).toByteArray();
        return;
    }
    if (elements.count == 0)
        return;
    if (stride < elements.size || stride > 256)
        throw GltfError("a buffer view has a wrong stride");
    const QByteArrayView rows = sliced(bytes, offset, (elements.count - 1) * stride + elements.size);
    elements.bytes.reserve(static_cast<qsizetype>(total));
    for (std::size_t i = 0; i < elements.count; ++i)
        elements.bytes.append(rows.data() + i * stride, static_cast<qsizetype>(elements.size));
}

void GltfData::addSparse(GltfElements &elements, const Json &sparse)
{
    const auto read = [&](const char *key, GltfElements form) {
        const Json &from = member(sparse, key);
        form.count = requiredNumber(sparse, "count");
        if (form.count > elements.count)
            throw GltfError("a sparse accessor has more changes than elements");
        const std::size_t offset = wholeNumber(from, "byteOffset").value_or(0);
        form.bytes =
            sliced(view(requiredNumber(from, "bufferView")), offset, form.count * form.size).toByteArray();
        return form;
    };
    GltfElements form;
    form.componentType = static_cast<int>(
        std::min<std::size_t>(requiredNumber(member(sparse, "indices"), "componentType"), 1 << 16));
    form.size = componentSize(form.componentType);
    const GltfElements indices = read("indices", form);
    const GltfElements values = read("values", elements);
    for (std::size_t i = 0; i < indices.count; ++i) {
        const double index = indices.stored(i, 0);
        if (!(index >= 0 && index < static_cast<double>(elements.count)))
            throw GltfError("a sparse accessor changes an element that is not there");
        std::memcpy(elements.bytes.data() + static_cast<std::size_t>(index) * elements.size, values.at(i),
                    elements.size);
    }
}

const GltfElements &GltfData::elements(std::size_t accessor)
{
    const auto known = mElements.find(accessor);
    if (known != mElements.end())
        return known->second;
    const Json &description = element(json(), "accessors", accessor);
    GltfElements elements = emptyElements(description);
    fill(elements, description);
    if (const Json &sparse = member(description, "sparse"); !sparse.is_null())
        addSparse(elements, sparse);
    return mElements[accessor] = std::move(elements);
}

} // namespace autocuts
