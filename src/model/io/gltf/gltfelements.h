// Reads accessors: rows of numbers in the buffers of a glTF file.
#pragma once

#include "model/io/gltf/gltffile.h"

#include <cstdint>

namespace autocuts {

//! The content of an accessor, one element behind the other.
struct GltfElements
{
    static constexpr int int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125,
                         float32 = 5126;

    int componentType = float32;
    int components = 1; //!< numbers in an element
    bool isMatrix = false;
    bool normalized = false; //!< integers stand for 0 to 1 or -1 to 1
    std::size_t count = 0;
    std::size_t size = 0; //!< bytes of an element
    QByteArray bytes;     //!< count * size

    const char *at(std::size_t index) const { return bytes.constData() + index * size; }
    //! A component as it is stored. \pre not a matrix
    double stored(std::size_t index, int component) const;
    //! A component as it is meant. \pre not a matrix
    double value(std::size_t index, int component) const;
};

//! The form of an accessor without its content. \throws GltfError
GltfElements emptyElements(const Json &accessor);

//! Reads the accessors of a file and keeps what it has read, since primitives share accessors.
class GltfData
{
public:
    //! \param document must outlive this
    explicit GltfData(const GltfDocument &document);

    const Json &json() const { return mDocument.json; }
    //! Sparse values and decompressed buffer views are in it; accessors without data are zeros.
    //! \throws GltfError, also for a count that damaged or made-up files have only
    const GltfElements &elements(std::size_t accessor);
    //! The bytes of a buffer view, decompressed. \throws GltfError
    QByteArrayView view(std::size_t bufferView);

private:
    void fill(GltfElements &elements, const Json &accessor);
    void addSparse(GltfElements &elements, const Json &sparse);
    QByteArrayView part(const Json &range) const;

    const GltfDocument &mDocument;
    std::map<std::size_t, GltfElements> mElements;
    std::map<std::size_t, QByteArray> mDecompressed;
    std::size_t mZerosLeft; //!< bytes that accessors without data may still take
};

} // namespace autocuts
