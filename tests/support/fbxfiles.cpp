#include "support/fbxfiles.h"

#include <QtEndian>

#include <cstring>
#include <map>
#include <type_traits>
#include <zlib.h>

namespace fbxfiles {

namespace {

template <typename T>
void put(QByteArray &out, T value, bool bigEndian)
{
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (bigEndian)
        std::reverse(bytes, bytes + sizeof value);
    out.append(bytes, sizeof value);
}

QByteArray zlibStream(const QByteArray &bytes)
{
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    QByteArray packed(static_cast<qsizetype>(size), '\0');
    compress(reinterpret_cast<Bytef *>(packed.data()), &size,
             reinterpret_cast<const Bytef *>(bytes.constData()), static_cast<uLong>(bytes.size()));
    return packed.left(static_cast<qsizetype>(size));
}

template <typename T>
constexpr char code()
{
    if constexpr (std::is_same_v<T, std::int32_t>)
        return 'I';
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return 'L';
    else if constexpr (std::is_same_v<T, float>)
        return 'F';
    else
        return 'D';
}

struct BinaryValue
{
    const Kind &kind;
    QByteArray &out;
    std::uint32_t &count;

    void operator()(bool value) { scalar('C', static_cast<char>(value)); }
    void operator()(std::int16_t value) { scalar('Y', value); }
    template <typename T>
    void operator()(T value)
    {
        scalar(code<T>(), value);
    }
    void operator()(const QByteArray &text)
    {
        scalar('S', static_cast<std::uint32_t>(text.size()));
        out.append(text);
    }
    template <typename T>
    void operator()(const std::vector<T> &array)
    {
        if (kind.version < 7000) {
            for (T value : array)
                (*this)(value);
            return;
        }
        QByteArray content;
        for (T value : array)
            put(content, value, kind.bigEndian);
        if (kind.packed)
            content = zlibStream(content);
        scalar(static_cast<char>(code<T>() + 32), static_cast<std::uint32_t>(array.size()));
        put(out, static_cast<std::uint32_t>(kind.packed), kind.bigEndian);
        put(out, static_cast<std::uint32_t>(content.size()), kind.bigEndian);
        out.append(content);
    }

    template <typename T>
    void scalar(char type, T value)
    {
        out.append(type);
        put(out, value, kind.bigEndian);
        ++count;
    }
};

void putHead(QByteArray &out, qsizetype value, const Kind &kind)
{
    if (kind.version >= 7500)
        put(out, static_cast<std::uint64_t>(value), kind.bigEndian);
    else
        put(out, static_cast<std::uint32_t>(value), kind.bigEndian);
}

void putBinary(QByteArray &out, const Node &node, const Kind &kind)
{
    const qsizetype headSize = kind.version >= 7500 ? 25 : 13;
    const qsizetype begin = out.size();
    QByteArray values;
    std::uint32_t count = 0;
    for (const Value &value : node.values)
        std::visit(BinaryValue{kind, values, count}, value);
    out.append(headSize, '\0').append(node.name).append(values);
    for (const Node &child : node.children)
        putBinary(out, child, kind);
    if (node.list || !node.children.empty())
        out.append(headSize, '\0');
    QByteArray head;
    putHead(head, out.size(), kind);
    putHead(head, count, kind);
    putHead(head, values.size(), kind);
    out.replace(begin, headSize, head.append(static_cast<char>(node.name.size())));
}

struct TextValue
{
    const Kind &kind;
    const QByteArray &indent;
    QByteArray &out;
    bool first;

    void operator()(bool value) { word(value ? "T" : "F"); }
    void operator()(std::int16_t value) { word(QByteArray::number(value)); }
    void operator()(std::int32_t value) { word(QByteArray::number(value)); }
    void operator()(std::int64_t value) { word(QByteArray::number(static_cast<qlonglong>(value))); }
    void operator()(float value) { word(QByteArray::number(static_cast<double>(value), 'g', 9)); }
    void operator()(double value) { word(QByteArray::number(value, 'g', 17)); }
    void operator()(const QByteArray &text) { word('"' + text + '"'); }
    template <typename T>
    void operator()(const std::vector<T> &array)
    {
        if (kind.version < 7000) {
            for (T value : array) {
                (*this)(value);
                first = false;
                if (&value != &array.back())
                    out.append(out.size() % 5 == 0 ? kind.lineEnd + "\t\t" : QByteArray());
            }
            return;
        }
        out.append(" *" + QByteArray::number(std::ssize(array)) + " {" + kind.lineEnd + indent + "\ta: ");
        for (std::size_t i = 0; i < array.size(); ++i) {
            first = true;
            out.append(i > 0 ? "," : "");
            (*this)(array[i]);
        }
        out.append(kind.lineEnd + indent + "}");
    }
    void word(const QByteArray &text) { out.append(first ? " " : ",").append(text); }
};

void putText(QByteArray &out, const Node &node, const Kind &kind, const QByteArray &indent)
{
    out.append(indent + node.name + ':');
    for (std::size_t v = 0; v < node.values.size(); ++v)
        std::visit(TextValue{kind, indent, out, v == 0}, node.values[v]);
    if (node.list || !node.children.empty()) {
        out.append(" {" + kind.lineEnd);
        for (const Node &child : node.children)
            putText(out, child, kind, indent + '\t');
        out.append(indent + "} ");
    }
    out.append(kind.lineEnd);
}

QByteArray footer(const Kind &kind, qsizetype position)
{
    QByteArray out = QByteArray::fromHex("fabcab0fd2cfd065b373ff801df82e7a");
    out.append(4, '\0');
    const qsizetype pad = 16 - (position + out.size()) % 16;
    out.append(pad, '\0');
    put(out, static_cast<std::uint32_t>(kind.version), kind.bigEndian);
    out.append(120, '\0');
    return out.append(QByteArray::fromHex("f85a8c6adef5d97eece90ce3758f297e"));
}

//! What connections call an object.
QByteArray objectName(const Kind &kind, const QByteArray &cls, const QByteArray &name)
{
    return kind.binary ? name + QByteArray("\0\1", 2) + cls : cls + "::" + name;
}

} // namespace

QByteArray file(const Kind &kind, const std::vector<Node> &nodes)
{
    std::vector<Node> all{
        {"FBXHeaderExtension",
         {},
         {{"FBXHeaderVersion", {std::int32_t(1003)}, {}}, {"FBXVersion", {std::int32_t(kind.version)}, {}}}}};
    all.insert(all.end(), nodes.begin(), nodes.end());
    QByteArray out;
    if (!kind.binary) {
        out = "; FBX " + QByteArray::number(kind.version) + " project file" + kind.lineEnd;
        for (const Node &node : all) {
            out.append("; a comment with { and \"" + kind.lineEnd);
            putText(out, node, kind, {});
        }
        return out;
    }
    out = QByteArray("Kaydara FBX Binary  \0\x1a\0", 23);
    out[22] = static_cast<char>(kind.bigEndian);
    put(out, static_cast<std::uint32_t>(kind.version), kind.bigEndian);
    for (const Node &node : all)
        putBinary(out, node, kind);
    out.append(kind.version >= 7500 ? 25 : 13, '\0');
    return out + footer(kind, out.size());
}

Node layerElement(const QByteArray &name, int index, const QByteArray &called, const QByteArray &mapping,
                  const QByteArray &reference, std::vector<Node> content)
{
    Node node{name,
              {std::int32_t(index)},
              {{"Version", {std::int32_t(101)}, {}},
               {"Name", {called}, {}},
               {"MappingInformationType", {mapping}, {}},
               {"ReferenceInformationType", {reference}, {}}}};
    node.children.insert(node.children.end(), content.begin(), content.end());
    return node;
}

Node uvElement(int index, const QByteArray &called)
{
    const std::vector<double> uv{0, 0, 0.5, 0, 0.5, 1, 0, 1, 1, 0, 1, 1};
    const std::vector<std::int32_t> indices{0, 1, 2, 3, 1, 4, 5, 2};
    return layerElement("LayerElementUV", index, called, "ByPolygonVertex", "IndexToDirect",
                        {{"UV", {uv}, {}}, {"UVIndex", {indices}, {}}});
}

std::vector<Node> quads(std::vector<Node> more)
{
    const std::vector<double> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0};
    const std::vector<std::int32_t> corners{0, 1, 2, -4, 1, 4, 5, -3};
    std::vector<Node> nodes{{"Vertices", {points}, {}}, {"PolygonVertexIndex", {corners}, {}}};
    nodes.insert(nodes.end(), more.begin(), more.end());
    return nodes;
}

Node layer(int index, const std::vector<int> &uvs)
{
    Node node{"Layer", {std::int32_t(index)}, {{"Version", {std::int32_t(100)}, {}}}};
    for (const int uv : uvs)
        node.children.push_back(
            {"LayerElement",
             {},
             {{"Type", {QByteArray("LayerElementUV")}, {}}, {"TypedIndex", {std::int32_t(uv)}, {}}}});
    return node;
}

Node property(const Kind &kind, const QByteArray &name, const std::vector<double> &values)
{
    Node node{kind.version < 7000 ? "Property" : "P", {name, name, QByteArray()}, {}};
    if (kind.version >= 7000)
        node.values.push_back(QByteArray("A"));
    for (const double value : values)
        node.values.push_back(value);
    return node;
}

QByteArray model(const Kind &kind, const std::vector<Object> &objects)
{
    const bool old = kind.version < 7000;
    Node list{"Objects", {}, {}};
    Node connections{"Connections", {}, {}};
    std::map<QByteArray, std::int64_t> materials;
    std::int64_t mesh = 0;
    const auto connect = [&](const Value &child, const Value &parent) {
        connections.children.push_back({old ? "Connect" : "C", {QByteArray("OO"), child, parent}, {}});
    };
    const auto modelKey = [&](int object) -> Value {
        if (object < 0)
            return old ? Value(objectName(kind, "Model", "Scene")) : Value(std::int64_t(0));
        return old ? Value(objectName(kind, "Model", objects[object].name))
                   : Value(std::int64_t(1000 + object));
    };
    for (int o = 0; o < std::ssize(objects); ++o) {
        const Object &object = objects[o];
        const QByteArray name = objectName(kind, "Model", object.name);
        Node node{"Model", {name, QByteArray("Mesh")}, {{"Version", {std::int32_t(232)}, {}}}};
        node.children.push_back({old ? "Properties60" : "Properties70", {}, object.properties, true});
        if (old) {
            node.children.insert(node.children.end(), object.mesh.begin(), object.mesh.end());
        } else {
            node.values.insert(node.values.begin(), std::int64_t(1000 + o));
            if (!object.mesh.empty()) {
                mesh = 2000 + o;
                list.children.push_back(
                    {"Geometry", {mesh, objectName(kind, "Geometry", ""), QByteArray("Mesh")}, object.mesh});
            }
            connect(mesh, modelKey(o));
        }
        list.children.push_back(node);
        connect(modelKey(o), modelKey(object.parent));
        for (const QByteArray &material : object.materials) {
            const QByteArray materialName = objectName(kind, "Material", material);
            const auto [it, isNew] =
                materials.try_emplace(material, 3000 + static_cast<std::int64_t>(materials.size()));
            Node added{"Material", {materialName, QByteArray()}, {{"Version", {std::int32_t(102)}, {}}}};
            if (!old)
                added.values.insert(added.values.begin(), it->second);
            if (isNew)
                list.children.push_back(added);
            connect(old ? Value(materialName) : Value(it->second), modelKey(o));
        }
    }
    return file(kind, {list, connections, {"Takes", {}, {{"Current", {QByteArray()}, {}}}}});
}

} // namespace fbxfiles
