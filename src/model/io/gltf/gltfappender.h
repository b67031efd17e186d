// Adds accessors to a glTF file and takes out those at the end that nothing uses any more.
#pragma once

#include "model/io/gltf/gltfelements.h"

#include <set>

namespace autocuts {

//! What the accessors and buffer views of a file are used by.
struct GltfUses
{
    std::set<std::size_t> accessors, bufferViews;
};

//! Every number in an extension or in extras counts as a use, since any may be one.
GltfUses usesIn(const Json &root);

//! Adds data at the end of one buffer.
class GltfAppender
{
public:
    //! Chooses the first buffer with data; makes one when there is none.
    explicit GltfAppender(GltfDocument &document);

    //! The buffer that takes the data.
    std::size_t buffer() const { return mBuffer; }

    //! Takes out the last accessors and buffer views, with their data, as long as they were used before and
    //! are not used now. So a file that is saved again and again does not grow. A buffer in a file of its own
    //! keeps them: until the new .gltf file is in place, the old one has to find its data.
    void dropUnused(const GltfUses &before);

    //! Adds an accessor of vertices. \param like an accessor whose name, extras and form it takes over;
    //! sparse ones without other data stay so \returns its index
    std::size_t addVertices(const Json &like, const GltfElements &elements);
    //! Adds an accessor of indices. \param like as above; a null value when there is none
    std::size_t addIndices(const Json &like, const std::vector<std::uint32_t> &indices);
    //! Adds the bytes of a picture file. \returns the index of its buffer view
    std::size_t addPicture(const QByteArray &content) { return addView(content, 0, 0); }
    //! Adds matrices of 16 numbers each, column by column.
    std::size_t addMatrices(const std::vector<float> &numbers);
    //! Adds UVs.
    std::size_t addUvs(const Json &like, const QByteArray &floats);

private:
    static constexpr int vertexTarget = 34962, indexTarget = 34963;

    std::size_t addView(const QByteArray &bytes, std::size_t stride, int target);
    void addSparse(Json &accessor, const GltfElements &elements);
    std::size_t addAccessor(Json accessor);
    bool dropLastView();

    GltfDocument &mDocument;
    std::size_t mBuffer = 0;
};

} // namespace autocuts
