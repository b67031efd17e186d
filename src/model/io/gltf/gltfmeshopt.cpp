#include "model/io/gltf/gltfmeshopt.h"

#include <meshoptimizer.h>

namespace autocuts {

namespace {

//! A byte of compressed data stands for at most this many: a vertex block stores 16 equal bytes in 2 bits.
constexpr std::size_t maxRatio = 128;

int decoded(QByteArray &out, std::size_t count, std::size_t stride, const std::string &mode,
            QByteArrayView compressed)
{
    const auto *data = reinterpret_cast<const unsigned char *>(compressed.data());
    const auto size = static_cast<std::size_t>(compressed.size());
    if (mode == "ATTRIBUTES" && stride % 4 == 0)
        return meshopt_decodeVertexBuffer(out.data(), count, stride, data, size);
    const bool isIndex = stride == 2 || stride == 4;
    if (mode == "TRIANGLES" && isIndex && count % 3 == 0)
        return meshopt_decodeIndexBuffer(out.data(), count, stride, data, size);
    if (mode == "INDICES" && isIndex)
        return meshopt_decodeIndexSequence(out.data(), count, stride, data, size);
    return -1;
}

//! Undoes the filter in place; false when the elements have a wrong size for it.
bool unfilter(QByteArray &out, std::size_t count, std::size_t stride, const std::string &filter)
{
    if (filter.empty() || filter == "NONE")
        return true;
    if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
        meshopt_decodeFilterOct(out.data(), count, stride);
    else if (filter == "QUATERNION" && stride == 8)
        meshopt_decodeFilterQuat(out.data(), count, stride);
    else if (filter == "EXPONENTIAL" && stride % 4 == 0)
        meshopt_decodeFilterExp(out.data(), count, stride);
    else
        return false;
    return true;
}

} // namespace

QByteArray decodeMeshopt(const Json &extension, QByteArrayView compressed)
{
    const std::size_t count = requiredNumber(extension, "count");
    const std::size_t stride = requiredNumber(extension, "byteStride");
    if (stride == 0 || stride > 256 ||
        count / maxRatio > static_cast<std::size_t>(compressed.size()) / stride)
        throw GltfError("a compressed buffer view (EXT_meshopt_compression) has a wrong size");
    QByteArray out(static_cast<qsizetype>(count * stride), '\0');
    if (decoded(out, count, stride, textOf(extension, "mode"), compressed) != 0 ||
        !unfilter(out, count, stride, textOf(extension, "filter")))
        throw GltfError("a compressed buffer view (EXT_meshopt_compression) is damaged");
    return out;
}

} // namespace autocuts
