// New FBX nodes as bytes, binary and text.
#include "model/io/fbx/fbxbytes.h"
#include "model/io/fbx/fbxeditor.h"
#include "model/io/files/deflate.h"

#include <charconv>

namespace autocuts {

namespace {

//! Arrays of fewer bytes are not compressed, as in the files of most programs.
constexpr qsizetype smallArray = 128;
//! Arrays are one value from this version on.
constexpr int firstWithArrays = 7000;
//! Lines of text files are broken after this many characters; some programs read lines of limited length.
constexpr qsizetype lineLength = 2000;

template <typename T>
void appendBinary(QByteArray &out, T value, const FbxStyle &style)
{
    char bytes[sizeof value];
    putFbxNumber(bytes, value, style.bigEndian);
    out.append(bytes, sizeof bytes);
}

constexpr char typeOf(std::int32_t)
{
    return 'I';
}
constexpr char typeOf(std::int64_t)
{
    return 'L';
}
constexpr char typeOf(float)
{
    return 'F';
}
constexpr char typeOf(double)
{
    return 'D';
}

//! The values of a node in a binary file.
class BinaryValues
{
public:
    explicit BinaryValues(const FbxStyle &style) : mStyle(style) {}

    template <typename Number>
    void operator()(Number value)
    {
        mBytes.append(typeOf(value));
        appendBinary(mBytes, value, mStyle);
        ++mCount;
    }
    void operator()(const QByteArray &text) { append('S', text); }
    void operator()(const FbxRaw &raw) { append('R', raw.bytes); }
    template <typename Number>
    void operator()(const std::vector<Number> &array)
    {
        if (mStyle.version < firstWithArrays) {
            for (Number value : array)
                (*this)(value);
            return;
        }
        QByteArray content;
        content.reserve(std::ssize(array) * static_cast<qsizetype>(sizeof(Number)));
        for (Number value : array)
            appendBinary(content, value, mStyle);
        const bool pack = content.size() >= smallArray;
        if (pack)
            content = deflated(content);
        mBytes.append(static_cast<char>(typeOf(Number()) | 0x20)); // lower case
        appendBinary(mBytes, static_cast<std::uint32_t>(array.size()), mStyle);
        appendBinary(mBytes, static_cast<std::uint32_t>(pack), mStyle);
        appendBinary(mBytes, static_cast<std::uint32_t>(content.size()), mStyle);
        mBytes.append(content);
        ++mCount;
    }

    const QByteArray &bytes() const { return mBytes; }
    qint64 count() const { return mCount; }

private:
    void append(char type, const QByteArray &bytes)
    {
        mBytes.append(type);
        appendBinary(mBytes, static_cast<std::uint32_t>(bytes.size()), mStyle);
        mBytes.append(bytes);
        ++mCount;
    }

    const FbxStyle &mStyle;
    QByteArray mBytes;
    qint64 mCount = 0;
};

void appendHeadNumber(QByteArray &out, qint64 value, const FbxStyle &style)
{
    if (style.wide)
        appendBinary(out, static_cast<std::uint64_t>(value), style);
    else
        appendBinary(out, static_cast<std::uint32_t>(value), style);
}

QByteArray binaryNode(const FbxNewNode &node, const FbxStyle &style, qint64 position)
{
    BinaryValues values(style);
    for (const FbxNewValue &value : node.values)
        std::visit(values, value);
    const qint64 headSize = style.wide ? 25 : 13;
    QByteArray list;
    const qint64 listBegin = position + headSize + node.name.size() + values.bytes().size();
    for (const FbxNewNode &child : node.children)
        list.append(binaryNode(child, style, listBegin + list.size()));
    if (node.hasList || !node.children.empty())
        list.append(headSize, '\0');
    QByteArray out;
    appendHeadNumber(out, listBegin + list.size(), style);
    appendHeadNumber(out, values.count(), style);
    appendHeadNumber(out, values.bytes().size(), style);
    out.append(static_cast<char>(node.name.size()));
    return out.append(node.name).append(values.bytes()).append(list);
}

//! The values of a node in a text file.
class TextValues
{
public:
    TextValues(const FbxStyle &style, const QByteArray &indent) : mStyle(style), mIndent(indent) {}

    template <typename Number>
    void operator()(Number value)
    {
        mBytes.append(mBytes.isEmpty() ? " " : ",");
        appendNumber(mBytes, value);
    }
    void operator()(const QByteArray &text)
    {
        QByteArray escaped = text;
        escaped.replace('"', "&quot;");
        mBytes.append(mBytes.isEmpty() ? " \"" : ", \"").append(escaped).append('"');
    }
    void operator()(const FbxRaw &raw) { (*this)(raw.bytes.toBase64()); }
    template <typename Number>
    void operator()(const std::vector<Number> &array)
    {
        if (mStyle.version < firstWithArrays) {
            appendArray(mBytes.append(' '), array);
            return;
        }
        mBytes.append(" *").append(QByteArray::number(std::ssize(array))).append(" {").append(mStyle.lineEnd);
        appendArray(mBytes.append(mIndent).append("\ta: "), array);
        mBytes.append(mStyle.lineEnd).append(mIndent).append('}');
    }

    const QByteArray &bytes() const { return mBytes; }

private:
    template <typename Number>
    static void appendNumber(QByteArray &out, Number value)
    {
        char text[40];
        out.append(text, std::to_chars(text, text + sizeof text, value).ptr - text);
    }
    template <typename Number>
    void appendArray(QByteArray &out, const std::vector<Number> &array)
    {
        qsizetype lineBegin = out.size();
        for (std::size_t i = 0; i < array.size(); ++i) {
            if (i > 0)
                out.append(',');
            if (out.size() - lineBegin > lineLength) {
                out.append(mStyle.lineEnd);
                lineBegin = out.size();
            }
            appendNumber(out, array[i]);
        }
    }

    const FbxStyle &mStyle;
    const QByteArray &mIndent;
    QByteArray mBytes;
};

QByteArray textNode(const FbxNewNode &node, const FbxStyle &style, const QByteArray &indent)
{
    TextValues values(style, indent);
    for (const FbxNewValue &value : node.values)
        std::visit(values, value);
    QByteArray out = node.name + ':' + values.bytes();
    if (!node.hasList && node.children.empty())
        return out;
    out.append(node.values.empty() ? "  {" : " {").append(style.lineEnd);
    for (const FbxNewNode &child : node.children)
        out.append(indent).append('\t').append(textNode(child, style, indent + '\t')).append(style.lineEnd);
    return out.append(indent).append('}');
}

} // namespace

QByteArray fbxNodeBytes(const FbxNewNode &node, const FbxStyle &style, qint64 position,
                        const QByteArray &indent)
{
    return style.binary ? binaryNode(node, style, position) : textNode(node, style, indent);
}

} // namespace autocuts
