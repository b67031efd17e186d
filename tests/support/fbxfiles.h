// Makes small FBX files of all kinds, without the program's own writer.
#pragma once

#include <QByteArray>

#include <cstdint>
#include <variant>
#include <vector>

namespace fbxfiles {

//! The kind of a file.
struct Kind
{
    bool binary = true;
    int version = 7400; //!< nodes of binary files have heads of 64 bits from 7500 on
    bool bigEndian = false;
    bool packed = true; //!< arrays are zlib streams
    QByteArray lineEnd{"\n"};
};

using Value = std::variant<bool, std::int16_t, std::int32_t, std::int64_t, float, double, QByteArray,
                           std::vector<std::int32_t>, std::vector<std::int64_t>, std::vector<float>,
                           std::vector<double>>;

struct Node
{
    QByteArray name;
    std::vector<Value> values;
    std::vector<Node> children;
    bool list = false; //!< also braces without children
};

//! The file with these nodes behind its header nodes. A text file has comments.
QByteArray file(const Kind &kind, const std::vector<Node> &nodes);

//! A layer element. \param content its values, such as UV and UVIndex
Node layerElement(const QByteArray &name, int index, const QByteArray &called, const QByteArray &mapping,
                  const QByteArray &reference, std::vector<Node> content);

//! A LayerElementUV by polygon vertex for the 8 corners of quads(), each with the UV of its control point.
Node uvElement(int index, const QByteArray &called);

//! The nodes of a mesh of two quads beside each other, with 6 control points. \param more layer elements and
//! layers
std::vector<Node> quads(std::vector<Node> more);

//! A layer that names LayerElementUV nodes.
Node layer(int index, const std::vector<int> &uvs);

//! A model that shows a mesh.
struct Object
{
    QByteArray name;
    std::vector<Node> mesh;         //!< empty: the mesh of the object before
    std::vector<Node> properties{}; //!< made by property()
    int parent = -1;                //!< index of an object
    std::vector<QByteArray> materials{};
};

//! A property of a model, of a vector or a number.
Node property(const Kind &kind, const QByteArray &name, const std::vector<double> &values);

//! A whole file of objects.
QByteArray model(const Kind &kind, const std::vector<Object> &objects);

} // namespace fbxfiles
