// The geometries of a Collada file, with the places of their UVs in the text.
#pragma once

#include "model/io/files/xmlspans.h"
#include "model/plain/types.h"

#include <map>

namespace autocuts {

//! An <input> of a primitive.
struct ColladaInput
{
    const XmlElement *element = nullptr;
    std::string_view semantic, source; //!< the source without its #
    int offset = 0;
    int set = 0; //!< 0 when the text does not say it
    //! It stands in <vertices>, for all primitives of the geometry; the offset is that of the vertices.
    bool inVertices = false;
};

//! The numbers of a <source>.
struct ColladaNumbers
{
    const XmlElement *source = nullptr, *array = nullptr, *accessor = nullptr;
    std::vector<double> values;
    int stride = 1;
    //! The rows are the whole array, and they have two columns or more, so the text can be replaced.
    bool isPlain = false;

    int rows() const { return static_cast<int>(values.size()) / stride; }
};

//! <triangles>, <polylist> or <polygons>.
struct ColladaPrimitive
{
    const XmlElement *element = nullptr;
    std::vector<ColladaInput> inputs;
    int stride = 1; //!< indices of a corner
    std::vector<int> faceSizes;
    std::vector<std::string_view> words; //!< stride for each corner, in the text
    std::vector<int> indices;            //!< their values

    int cornerCount() const { return static_cast<int>(indices.size()) / stride; }
    //! The texture coordinates of this set, or null.
    const ColladaInput *texcoord(int set) const;
};

//! A <geometry>.
struct ColladaGeometry
{
    std::string id, name;
    const XmlElement *mesh = nullptr, *vertices = nullptr;
    std::vector<ColladaPrimitive> primitives;

    //! The sets of the UVs that Assimp reads for a primitive, in the order in which it numbers them.
    std::vector<int> setsOf(std::size_t primitive) const;
};

//! The geometries of a file. The XML points into the text that it was made of.
struct ColladaFile
{
    XmlElement root;
    std::vector<ColladaGeometry> geometries;
    std::map<std::string_view, ColladaNumbers> sources; //!< by id
};

//! Nothing when the file contains something whose UVs cannot be replaced: strips, fans, polygons with holes,
//! wrong indices, numbers that are no numbers, ids that are there twice, sets that Assimp does not read.
std::optional<ColladaFile> readCollada(std::string_view text);

//! The positions of the corners of a primitive, in its own coordinates; empty when it has none.
std::vector<Vec3> positionsOf(const ColladaFile &file, const ColladaGeometry &geometry,
                              const ColladaPrimitive &primitive);

} // namespace autocuts
