#include "model/io/gltf/gltfappender.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace autocuts {

namespace {

void addNumber(std::set<std::size_t> &to, const Json &value)
{
    if (value.is_number_unsigned())
        to.insert(value.get<std::size_t>());
}

void addAllNumbers(GltfUses &uses, const Json &value)
{
    addNumber(uses.accessors, value);
    addNumber(uses.bufferViews, value);
    if (value.is_structured()) {
        for (const Json &part : value)
            addAllNumbers(uses, part);
    }
}

//! Finds the extensions and extras in any depth.
void addExtensions(GltfUses &uses, const Json &value)
{
    if (value.is_array()) {
        for (const Json &part : value)
            addExtensions(uses, part);
    } else if (value.is_object()) {
        for (const auto &[key, part] : value.items()) {
            if (key == "extensions" || key == "extras")
                addAllNumbers(uses, part);
            else
                addExtensions(uses, part);
        }
    }
}

void addPrimitive(GltfUses &uses, const Json &primitive)
{
    addNumber(uses.accessors, member(primitive, "indices"));
    for (const Json &attribute : member(primitive, "attributes"))
        addNumber(uses.accessors, attribute);
    for (const Json &target : member(primitive, "targets")) {
        for (const Json &attribute : target)
            addNumber(uses.accessors, attribute);
    }
}

//! Recomputes "min" and "max" where the accessor has them.
void setRange(Json &accessor, const GltfElements &elements)
{
    if (!accessor.contains("min") && !accessor.contains("max"))
        return;
    Json low = Json::array(), high = Json::array();
    for (int k = 0; k < elements.components && !elements.isMatrix; ++k) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (std::size_t i = 0; i < elements.count; ++i) {
            least = std::min(least, elements.stored(i, k));
            most = std::max(most, elements.stored(i, k));
        }
        if (!std::isfinite(least) || !std::isfinite(most))
            break;
        const bool isFloat = elements.componentType == GltfElements::float32;
        low.push_back(isFloat ? Json(least) : Json(static_cast<std::int64_t>(least)));
        high.push_back(isFloat ? Json(most) : Json(static_cast<std::int64_t>(most)));
    }
    const bool isComplete = low.size() == static_cast<std::size_t>(elements.components);
    for (const auto &[key, values] : {std::pair("min", low), std::pair("max", high)}) {
        if (!isComplete)
            accessor.erase(key);
        else if (accessor.contains(key))
            accessor[key] = values;
    }
}

//! The description of an accessor without its data.
Json withoutData(const Json &like)
{
    Json accessor = like.is_object() ? like : Json::object();
    accessor.erase("byteOffset");
    accessor.erase("bufferView");
    accessor.erase("sparse");
    return accessor;
}

template <typename T>
QByteArray packed(const std::vector<std::uint32_t> &values)
{
    const std::vector<T> narrow(values.begin(), values.end());
    return {reinterpret_cast<const char *>(narrow.data()), static_cast<qsizetype>(narrow.size() * sizeof(T))};
}

} // namespace

GltfUses usesIn(const Json &root)
{
    GltfUses uses;
    addExtensions(uses, root);
    for (const Json &mesh : member(root, "meshes")) {
        for (const Json &primitive : member(mesh, "primitives"))
            addPrimitive(uses, primitive);
    }
    for (const Json &skin : member(root, "skins"))
        addNumber(uses.accessors, member(skin, "inverseBindMatrices"));
    for (const Json &animation : member(root, "animations")) {
        for (const Json &sampler : member(animation, "samplers")) {
            addNumber(uses.accessors, member(sampler, "input"));
            addNumber(uses.accessors, member(sampler, "output"));
        }
    }
    for (const Json &image : member(root, "images"))
        addNumber(uses.bufferViews, member(image, "bufferView"));
    for (const Json &accessor : member(root, "accessors")) {
        const Json &sparse = member(accessor, "sparse");
        addNumber(uses.bufferViews, member(accessor, "bufferView"));
        addNumber(uses.bufferViews, member(member(sparse, "indices"), "bufferView"));
        addNumber(uses.bufferViews, member(member(sparse, "values"), "bufferView"));
    }
    return uses;
}

GltfAppender::GltfAppender(GltfDocument &document) : mDocument(document)
{
    const auto hasData = [](const QByteArray &buffer) { return !buffer.isEmpty(); };
    const auto found = std::find_if(document.buffers.begin(), document.buffers.end(), hasData);
    mBuffer = static_cast<std::size_t>(found - document.buffers.begin());
    if (found != document.buffers.end())
        return;
    document.buffers.emplace_back();
    document.json["buffers"].push_back({{"byteLength", 0}});
}

bool GltfAppender::dropLastView()
{
    Json &views = mDocument.json["bufferViews"];
    QByteArray &buffer = mDocument.buffers[mBuffer];
    const Json &last = views.back();
    const std::size_t begin = wholeNumber(last, "byteOffset").value_or(0);
    const std::size_t size = requiredNumber(last, "byteLength");
    const auto total = static_cast<std::size_t>(buffer.size());
    if (requiredNumber(last, "buffer") != mBuffer || last.contains("extensions") || begin > total ||
        size + 3 < total - begin)
        return false;
    const auto reachesInto = [&](const Json &range) {
        return wholeNumber(range, "buffer") == mBuffer &&
               wholeNumber(range, "byteOffset").value_or(0) + wholeNumber(range, "byteLength").value_or(0) >
                   begin;
    };
    const auto isInTheWay = [&](const Json &view) {
        const Json &extensions = member(view, "extensions");
        return reachesInto(view) ||
               (extensions.is_object() && std::any_of(extensions.begin(), extensions.end(), reachesInto));
    };
    if (std::any_of(views.begin(), views.end() - 1, isInTheWay))
        return false;
    buffer.truncate(static_cast<qsizetype>(begin));
    views.erase(views.size() - 1);
    return true;
}

void GltfAppender::dropUnused(const GltfUses &before)
{
    Json &accessors = mDocument.json["accessors"];
    GltfUses now = usesIn(mDocument.json);
    const auto isDropped = [](const Json &array, const std::set<std::size_t> &then,
                              const std::set<std::size_t> &still) {
        return !array.empty() && then.contains(array.size() - 1) && !still.contains(array.size() - 1);
    };
    while (isDropped(accessors, before.accessors, now.accessors))
        accessors.erase(accessors.size() - 1);
    now = usesIn(mDocument.json);
    while (isDropped(member(mDocument.json, "bufferViews"), before.bufferViews, now.bufferViews)) {
        if (!dropLastView())
            return;
    }
}

std::size_t GltfAppender::addView(const QByteArray &bytes, std::size_t stride, int target)
{
    QByteArray &buffer = mDocument.buffers[mBuffer];
    buffer.append(-buffer.size() & 3, '\0');
    Json view{{"buffer", mBuffer},
              {"byteOffset", static_cast<std::size_t>(buffer.size())},
              {"byteLength", static_cast<std::size_t>(bytes.size())}};
    if (stride > 0)
        view["byteStride"] = stride;
    if (target > 0)
        view["target"] = target;
    buffer.append(bytes);
    mDocument.json["buffers"][mBuffer]["byteLength"] = static_cast<std::size_t>(buffer.size());
    Json &views = mDocument.json["bufferViews"];
    views.push_back(std::move(view));
    return views.size() - 1;
}

std::size_t GltfAppender::addAccessor(Json accessor)
{
    Json &accessors = mDocument.json["accessors"];
    accessors.push_back(std::move(accessor));
    return accessors.size() - 1;
}

void GltfAppender::addSparse(Json &accessor, const GltfElements &elements)
{
    std::vector<std::uint32_t> changed;
    QByteArray values;
    const QByteArray zero(static_cast<qsizetype>(elements.size), '\0');
    for (std::size_t i = 0; i < elements.count; ++i) {
        // At least one element has to be named.
        const bool isLast = i + 1 == elements.count && changed.empty();
        if (!isLast && std::memcmp(elements.at(i), zero.constData(), elements.size) == 0)
            continue;
        changed.push_back(static_cast<std::uint32_t>(i));
        values.append(elements.at(i), static_cast<qsizetype>(elements.size));
    }
    accessor["sparse"] = {{"count", changed.size()},
                          {"indices",
                           {{"bufferView", addView(packed<std::uint32_t>(changed), 0, 0)},
                            {"componentType", GltfElements::uint32}}},
                          {"values", {{"bufferView", addView(values, 0, 0)}}}};
}

std::size_t GltfAppender::addVertices(const Json &like, const GltfElements &elements)
{
    Json accessor = withoutData(like);
    accessor["count"] = elements.count;
    setRange(accessor, elements);
    if (like.contains("sparse") && !like.contains("bufferView")) {
        addSparse(accessor, elements);
        return addAccessor(std::move(accessor));
    }
    // Vertices start at multiples of four bytes.
    const std::size_t stride = (elements.size + 3) / 4 * 4;
    QByteArray rows = elements.bytes;
    if (stride != elements.size) {
        rows = QByteArray(static_cast<qsizetype>(stride * elements.count), '\0');
        for (std::size_t i = 0; i < elements.count; ++i)
            std::memcpy(rows.data() + i * stride, elements.at(i), elements.size);
    }
    accessor["bufferView"] = addView(rows, stride, vertexTarget);
    return addAccessor(std::move(accessor));
}

std::size_t GltfAppender::addUvs(const Json &like, const QByteArray &floats)
{
    GltfElements elements;
    elements.components = 2;
    elements.size = 2 * sizeof(float);
    elements.count = static_cast<std::size_t>(floats.size()) / elements.size;
    elements.bytes = floats;
    Json accessor = withoutData(like);
    accessor.erase("normalized");
    accessor["componentType"] = GltfElements::float32;
    accessor["type"] = "VEC2";
    return addVertices(accessor, elements);
}

std::size_t GltfAppender::addMatrices(const std::vector<float> &numbers)
{
    const QByteArray bytes(reinterpret_cast<const char *>(numbers.data()),
                           static_cast<qsizetype>(numbers.size() * sizeof(float)));
    return addAccessor({{"bufferView", addView(bytes, 0, 0)},
                        {"componentType", GltfElements::float32},
                        {"count", numbers.size() / 16},
                        {"type", "MAT4"}});
}

std::size_t GltfAppender::addIndices(const Json &like, const std::vector<std::uint32_t> &indices)
{
    const std::uint32_t highest = indices.empty() ? 0 : *std::max_element(indices.begin(), indices.end());
    int type =
        like.is_object() ? static_cast<int>(requiredNumber(like, "componentType")) : GltfElements::uint8;
    // The highest number of a type means something else.
    if (type == GltfElements::uint8 && highest >= 0xFF)
        type = GltfElements::uint16;
    if (type == GltfElements::uint16 && highest >= 0xFFFF)
        type = GltfElements::uint32;
    const QByteArray bytes = type == GltfElements::uint8    ? packed<std::uint8_t>(indices)
                             : type == GltfElements::uint16 ? packed<std::uint16_t>(indices)
                                                            : packed<std::uint32_t>(indices);
    Json accessor = withoutData(like);
    accessor["bufferView"] = addView(bytes, 0, indexTarget);
    accessor["componentType"] = type;
    accessor["count"] = indices.size();
    accessor["type"] = "SCALAR";
    accessor.erase("min");
    accessor.erase("max");
    return addAccessor(std::move(accessor));
}

} // namespace autocuts
