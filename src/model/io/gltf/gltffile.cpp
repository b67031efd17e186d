#include "model/io/gltf/gltffile.h"

#include <QtEndian>

#include <algorithm>
#include <iterator>
#include <limits>

namespace autocuts {

namespace {

constexpr quint32 glbMagic = 0x46546C67, jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;
constexpr qsizetype headerSize = 12, chunkHeaderSize = 8;
//! Arrays and objects within each other. Extensions nest some ten deep.
constexpr int maxDepth = 200;
//! Of one object. The file format needs some twenty; what programs add may be more.
constexpr int maxMembers = 20'000;
//! Wider indents are not copied.
constexpr qsizetype maxIndent = 8;

quint32 number(const QByteArray &bytes, qsizetype at)
{
    return qFromLittleEndian<quint32>(bytes.constData() + at);
}

void appendNumber(QByteArray &bytes, quint32 value)
{
    const quint32 little = qToLittleEndian(value);
    bytes.append(reinterpret_cast<const char *>(&little), sizeof little);
}

//! The parts of a .glb file. They share the memory of the file.
struct GlbParts
{
    QByteArray json, binary, later;
    bool hasBinary = false;
};

//! The content of the chunk at a place. Moves the place behind it.
QByteArray takeChunk(const QByteArray &file, qsizetype &at)
{
    const qsizetype size = number(file, at);
    at += chunkHeaderSize;
    if (size > file.size() - at)
        throw GltfError("the file is cut off");
    QByteArray content = QByteArray::fromRawData(file.constData() + at, size);
    at = std::min<qsizetype>(at + (size + 3) / 4 * 4, file.size());
    return content;
}

GlbParts partsOfGlb(const QByteArray &file)
{
    if (file.size() < headerSize + chunkHeaderSize)
        throw GltfError("the file is cut off");
    if (number(file, 4) == 1)
        throw GltfVersion1();
    if (number(file, 4) != 2)
        throw GltfError("its container has version " + std::to_string(number(file, 4)) +
                        ", known are 1 and 2");
    qsizetype at = headerSize;
    GlbParts parts;
    if (number(file, at + 4) != jsonChunk)
        throw GltfError("its first chunk is not JSON");
    parts.json = takeChunk(file, at);
    if (file.size() - at >= chunkHeaderSize && number(file, at + 4) == binaryChunk) {
        parts.hasBinary = true;
        parts.binary = takeChunk(file, at);
    }
    parts.later = QByteArray::fromRawData(file.constData() + at, file.size() - at);
    return parts;
}

//! The characters of a text; they end with an exception when a job is to stop. A callback of the parser would
//! do that as well, but makes it look at all neighbours of each object that ends.
class WatchedCharacter
{
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char *;
    using reference = char;

    WatchedCharacter(const char *at, const std::atomic<bool> *stop) : mAt(at), mStop(stop) {}
    char operator*() const { return *mAt; }
    WatchedCharacter &operator++()
    {
        ++mAt;
        if (mStop && *mStop)
            throw GltfStopped();
        return *this;
    }
    bool operator==(const WatchedCharacter &other) const { return mAt == other.mAt; }

private:
    const char *mAt;
    const std::atomic<bool> *mStop;
};

//! Refuses text that would take a parsed document to its limits: what is nested too deeply, and objects with
//! so many members that looking for equal names would take minutes.
void checkShape(QByteArrayView text)
{
    std::vector<int> members; // of the objects and arrays around
    bool inString = false;
    for (const char *at = text.begin(); at != text.end(); ++at) {
        if (*at == '"')
            inString = !inString;
        else if (inString)
            at += *at == '\\' && at + 1 != text.end() ? 1 : 0;
        else if (*at == '{' || *at == '[')
            members.push_back(0);
        else if ((*at == '}' || *at == ']') && !members.empty())
            members.pop_back();
        else if (*at == ':' && !members.empty() && ++members.back() > maxMembers)
            throw GltfError("an object of its JSON has more than " + std::to_string(maxMembers) + " members");
        if (std::ssize(members) > maxDepth)
            throw GltfError("its JSON is nested too deeply");
    }
}

Json parsedJson(const QByteArray &text, const std::atomic<bool> *stop)
{
    // Some programs fill up the chunk with zeros.
    const char *end = text.end();
    while (end != text.begin() && end[-1] == '\0')
        --end;
    checkShape({text.begin(), end});
    Json json =
        Json::parse(WatchedCharacter(text.begin(), stop), WatchedCharacter(end, stop), nullptr, false);
    if (json.is_discarded() || !json.is_object())
        throw GltfError("its JSON is damaged or cut off");
    return json;
}

bool isFallback(const Json &buffer)
{
    return member(member(member(buffer, "extensions"), "EXT_meshopt_compression"), "fallback") == true;
}

//! Compressed data of an unknown kind would look like zeros.
void checkExtensions(const Json &json)
{
    const Json &required = member(json, "extensionsRequired");
    if (!required.is_array())
        return;
    for (const Json &extension : required) {
        if (extension.is_string() && extension.get<std::string>().ends_with("mesh_compression") &&
            extension != "KHR_draco_mesh_compression")
            throw GltfError("its geometry is compressed by " + extension.get<std::string>() +
                            ", which is not supported");
        if (extension == "KHR_meshopt_compression")
            throw GltfError("its geometry is compressed by KHR_meshopt_compression, which is not supported");
    }
}

} // namespace

bool GltfFile::isBinary() const
{
    return main.startsWith("glTF");
}

GltfDocument openGltf(GltfFile &file, const std::function<QByteArray(const QByteArray &uri)> &fetch,
                      const std::atomic<bool> *stop)
{
    GlbParts parts;
    if (file.isBinary())
        parts = partsOfGlb(file.main);
    else
        parts.json = file.main;
    GltfDocument document{parsedJson(parts.json, stop), {}, parts.later};
    // Version 1 named things by keys, not by numbers.
    if (member(document.json, "meshes").is_object())
        throw GltfVersion1();
    checkExtensions(document.json);
    const Json &buffers = member(document.json, "buffers");
    for (std::size_t b = 0; buffers.is_array() && b < buffers.size(); ++b) {
        const std::string uri = textOf(buffers[b], "uri");
        QByteArray content;
        if (isDataUri(uri)) {
            content = contentOfDataUri(uri);
        } else if (!uri.empty()) {
            const QByteArray key = QByteArray::fromStdString(uri);
            if (fetch && !file.outer.contains(key))
                file.outer[key] = fetch(key);
            content = file.outer[key];
        } else if (b == 0 && parts.hasBinary) {
            content = parts.binary;
        } else if (isFallback(buffers[b])) {
            document.buffers.emplace_back();
            continue;
        }
        const std::size_t size = requiredNumber(buffers[b], "byteLength");
        if (size > static_cast<std::size_t>(content.size()))
            throw GltfError("buffer " + std::to_string(b) + " has " + std::to_string(content.size()) +
                            " bytes and should have " + std::to_string(size));
        document.buffers.push_back(content.left(static_cast<qsizetype>(size)));
    }
    return document;
}

QByteArray jsonText(const Json &json, const QByteArray &like)
{
    const qsizetype line = like.indexOf('\n');
    const qsizetype brace = like.indexOf('{');
    int indent = -1;
    char filling = ' ';
    if (brace >= 0 && line > brace) {
        qsizetype end = line + 1;
        while (end < like.size() && (like[end] == ' ' || like[end] == '\t'))
            filling = like[end++];
        indent = static_cast<int>(std::min(end - line - 1, maxIndent));
    }
    QByteArray text = QByteArray::fromStdString(json.dump(indent, filling));
    if (like.endsWith('\n'))
        text.append('\n');
    return text;
}

QByteArray glbBytes(GltfDocument document)
{
    const bool hasBinary = !document.buffers.empty() && !document.json["buffers"][0].contains("uri") &&
                           !document.buffers[0].isEmpty();
    QByteArray binary;
    if (hasBinary)
        binary = document.buffers[0];
    for (std::size_t b = hasBinary; b < document.buffers.size(); ++b) {
        Json &buffer = document.json["buffers"][b];
        if (!buffer.contains("uri") && !document.buffers[b].isEmpty())
            buffer["uri"] = dataUri(document.buffers[b]);
    }
    QByteArray json = QByteArray::fromStdString(document.json.dump());
    json.append(-json.size() & 3, ' ');
    const qsizetype binarySize = (binary.size() + 3) / 4 * 4;
    const qsizetype size = headerSize + chunkHeaderSize + json.size() +
                           (hasBinary ? chunkHeaderSize + binarySize : 0) + document.laterChunks.size();
    if (size > std::numeric_limits<quint32>::max())
        throw GltfError("it would be larger than 4 GB");
    QByteArray out;
    out.reserve(size);
    for (const quint32 value :
         {glbMagic, quint32(2), quint32(size), static_cast<quint32>(json.size()), jsonChunk})
        appendNumber(out, value);
    out.append(json);
    if (hasBinary) {
        appendNumber(out, static_cast<quint32>(binarySize));
        appendNumber(out, binaryChunk);
        out.append(binary).append(binarySize - binary.size(), '\0');
    }
    return out.append(document.laterChunks);
}

std::string dataUri(const QByteArray &bytes)
{
    return "data:application/octet-stream;base64," + bytes.toBase64().toStdString();
}

QByteArray contentOfDataUri(const std::string &uri)
{
    const std::size_t comma = uri.find(',');
    if (comma == std::string::npos)
        throw GltfError("a data URI has no data");
    const auto data =
        QByteArray::fromRawData(uri.data() + comma + 1, static_cast<qsizetype>(uri.size() - comma - 1));
    const bool base64 = std::string_view(uri).substr(0, comma).ends_with(";base64");
    return base64 ? QByteArray::fromBase64(data) : QByteArray::fromPercentEncoding(data);
}

bool isDataUri(const std::string &uri)
{
    return uri.starts_with("data:");
}

} // namespace autocuts
