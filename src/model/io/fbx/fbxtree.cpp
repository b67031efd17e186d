#include "model/io/fbx/fbxtree.h"

#include "model/io/fbx/fbxbytes.h"
#include "model/io/files/deflate.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

namespace autocuts {

namespace {

//! What the arrays of a file may take together, and what each byte of the file adds. Chosen by hand.
constexpr qint64 roomBase = qint64(512) << 20;
constexpr qint64 roomPerByte = 64;

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

//! Bytes of one element of an array of this type; 0 for other types.
int elementSize(char type)
{
    switch (type) {
    case 'd':
    case 'l':
        return 8;
    case 'f':
    case 'i':
        return 4;
    case 'b':
    case 'c':
        return 1;
    default:
        return 0;
    }
}

template <typename T>
T converted(double value)
{
    if constexpr (std::is_same_v<T, double>)
        return value;
    // Also for NaN.
    return value > -2147483649.0 && value < 2147483648.0 ? static_cast<int>(value) : -1;
}

template <typename Stored, typename T>
void appendElements(const char *data, std::int64_t count, bool bigEndian, std::vector<T> &numbers)
{
    for (std::int64_t i = 0; i < count; ++i) {
        const auto value = fbxNumber<Stored>(data + i * static_cast<std::int64_t>(sizeof(Stored)), bigEndian);
        if constexpr (std::is_same_v<Stored, std::int32_t> && std::is_same_v<T, int>)
            numbers.push_back(value);
        else
            numbers.push_back(converted<T>(static_cast<double>(value)));
    }
}

//! A number of a text file; NaN when it is none. Some programs write "1.#QNAN".
double textNumber(std::string_view word)
{
    double value = std::numeric_limits<double>::quiet_NaN();
    if (!word.empty() && word.front() == '+')
        word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::result_out_of_range)
        return std::numeric_limits<double>::infinity();
    return error == std::errc() && end == word.data() + word.size()
               ? value
               : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::string_view FbxTree::name(int node) const
{
    const FbxNode &n = nodes[static_cast<std::size_t>(node)];
    return {bytes.constData() + n.begin + n.nameBegin, static_cast<std::size_t>(n.nameLength)};
}

int FbxTree::child(int node, std::string_view wanted) const
{
    if (node < 0)
        return -1;
    int c = nodes[static_cast<std::size_t>(node)].firstChild;
    while (c >= 0 && name(c) != wanted)
        c = nodes[static_cast<std::size_t>(c)].next;
    return c;
}

int FbxTree::find(std::span<const std::string_view> path) const
{
    int node = 0;
    for (const std::string_view wanted : path)
        node = child(node, wanted);
    return node;
}

int FbxTree::nextNamed(int node) const
{
    int c = nodes[static_cast<std::size_t>(node)].next;
    while (c >= 0 && name(c) != name(node))
        c = nodes[static_cast<std::size_t>(c)].next;
    return c;
}

bool FbxTree::nextValue(qint64 &position, qint64 end, FbxValue &value) const
{
    value = {};
    return binary ? nextBinaryValue(position, end, value) : nextTextValue(position, end, value);
}

bool FbxTree::nextBinaryValue(qint64 &position, qint64 end, FbxValue &value) const
{
    const qint64 size = fbxValueSize(*this, position, end);
    if (size <= 0)
        return false;
    const char *data = bytes.constData() + position;
    value.begin = position;
    value.end = position += size;
    value.type = *data++;
    const auto setInteger = [&](std::int64_t number) {
        value.integer = number;
        value.number = static_cast<double>(number);
    };
    switch (value.type) {
    case 'Y':
        setInteger(fbxNumber<std::int16_t>(data, bigEndian));
        return true;
    case 'I':
        setInteger(fbxNumber<std::int32_t>(data, bigEndian));
        return true;
    case 'L':
        setInteger(fbxNumber<std::int64_t>(data, bigEndian));
        return true;
    case 'F':
        value.kind = FbxValue::Kind::Number;
        value.number = static_cast<double>(fbxNumber<float>(data, bigEndian));
        return true;
    case 'D':
        value.kind = FbxValue::Kind::Number;
        value.number = fbxNumber<double>(data, bigEndian);
        return true;
    case 'S':
    case 'R':
        value.kind = FbxValue::Kind::Text;
        value.text = {data + 4, static_cast<std::size_t>(size - 5)};
        return true;
    default:
        break;
    }
    if (elementSize(value.type) == 0) {
        setInteger(static_cast<signed char>(*data)); // one byte: B, C, Z
        return true;
    }
    value.kind = FbxValue::Kind::Array;
    value.count = fbxNumber<std::uint32_t>(data, bigEndian);
    value.packed = fbxNumber<std::uint32_t>(data + 4, bigEndian) == 1;
    value.contentBegin = value.begin + 13;
    return true;
}

bool FbxTree::nextTextValue(qint64 &position, qint64 end, FbxValue &value) const
{
    const char *data = bytes.constData();
    while (position < end) {
        const char c = data[position];
        if (c == ';')
            while (position < end && data[position] != '\n')
                ++position;
        else if (isBlank(c) || c == ',')
            ++position;
        else
            break;
    }
    if (position >= end)
        return false;
    const std::string_view rest(data + position, static_cast<std::size_t>(end - position));
    value.begin = position;
    if (rest.front() == '"') {
        const std::size_t quote = rest.find('"', 1);
        if (quote == std::string_view::npos)
            return false;
        value.kind = FbxValue::Kind::Text;
        value.text = rest.substr(1, quote - 1);
        value.end = position += static_cast<qint64>(quote) + 1;
        return true;
    }
    const std::size_t length = std::min(rest.find_first_of(" \t\r\n,;\""), rest.size());
    value.text = rest.substr(0, length);
    value.end = position += static_cast<qint64>(length);
    if (value.text.front() == '*') {
        value.kind = FbxValue::Kind::Array;
        std::from_chars(value.text.data() + 1, value.text.data() + length, value.count);
        return true;
    }
    const auto whole = std::from_chars(value.text.data(), value.text.data() + length, value.integer);
    value.number = static_cast<double>(value.integer);
    if (whole.ec == std::errc() && whole.ptr == value.text.data() + length)
        return true;
    value.number = textNumber(value.text);
    // Words such as T and Y; "1.#IND" and "nan" are numbers.
    const char first = value.text.front();
    const bool isNumber = !std::isnan(value.number) || (first >= '0' && first <= '9') || first == '-' ||
                          first == '+' || first == '.' || first == 'n' || first == 'N';
    value.kind = isNumber ? FbxValue::Kind::Number : FbxValue::Kind::Text;
    return true;
}

std::vector<FbxValue> FbxTree::values(int node, std::size_t most) const
{
    const FbxNode &n = nodes[static_cast<std::size_t>(node)];
    std::vector<FbxValue> result;
    qint64 position = n.valuesBegin;
    FbxValue value;
    while (result.size() < most && nextValue(position, n.valuesEnd, value))
        result.push_back(value);
    return result;
}

std::optional<std::int64_t> FbxTree::integer(int node) const
{
    if (node < 0)
        return {};
    const std::vector<FbxValue> first = values(node, 1);
    if (first.empty() || first[0].kind != FbxValue::Kind::Integer)
        return {};
    return first[0].integer;
}

std::string_view FbxTree::text(int node) const
{
    if (node < 0)
        return {};
    const std::vector<FbxValue> first = values(node, 1);
    return first.empty() || first[0].kind != FbxValue::Kind::Text ? std::string_view() : first[0].text;
}

bool FbxTree::take(qint64 count) const
{
    if (count > mRoom)
        return false;
    mRoom -= count;
    return true;
}

void FbxTree::fillRoom()
{
    mRoom = roomBase + roomPerByte * bytes.size();
}

template <typename T>
bool FbxTree::appendArray(const FbxValue &value, std::vector<T> &numbers) const
{
    const int size = elementSize(value.type);
    const qint64 content = value.count * size;
    if (!take(content + value.count * static_cast<qint64>(sizeof(T))))
        return false;
    const char *data = bytes.constData() + value.contentBegin;
    std::optional<QByteArray> unpacked;
    if (value.packed) {
        unpacked = inflated({data, value.end - value.contentBegin}, content);
        if (!unpacked)
            return false;
        data = unpacked->constData();
    }
    numbers.reserve(numbers.size() + static_cast<std::size_t>(value.count));
    switch (value.type) {
    case 'd':
        appendElements<double>(data, value.count, bigEndian, numbers);
        break;
    case 'f':
        appendElements<float>(data, value.count, bigEndian, numbers);
        break;
    case 'l':
        appendElements<std::int64_t>(data, value.count, bigEndian, numbers);
        break;
    case 'i':
        appendElements<std::int32_t>(data, value.count, bigEndian, numbers);
        break;
    default:
        appendElements<signed char>(data, value.count, bigEndian, numbers);
    }
    return true;
}

template <typename T>
std::optional<std::vector<T>> FbxTree::numbers(int node) const
{
    std::vector<T> result;
    if (node < 0)
        return {};
    const int list = binary ? -1 : child(node, "a");
    const FbxNode &n = nodes[static_cast<std::size_t>(list >= 0 ? list : node)];
    qint64 position = n.valuesBegin;
    FbxValue value;
    while (nextValue(position, n.valuesEnd, value)) {
        if (value.kind == FbxValue::Kind::Text)
            return {};
        if (value.kind == FbxValue::Kind::Array) {
            if (binary && !appendArray(value, result))
                return {};
            continue; // an empty array of a text file has no list
        }
        if (!take(sizeof(T)))
            return {};
        result.push_back(converted<T>(value.number));
    }
    return result;
}

std::optional<std::vector<double>> FbxTree::doubles(int node) const
{
    return numbers<double>(node);
}

std::optional<std::vector<int>> FbxTree::integers(int node) const
{
    return numbers<int>(node);
}

QByteArray unescapedFbx(std::string_view text)
{
    QByteArray result(text.data(), static_cast<qsizetype>(text.size()));
    if (text.find('&') != std::string_view::npos)
        result.replace("&quot;", "\"").replace("&lf;", "\n").replace("&cr;", "\r");
    return result;
}

qint64 fbxValueSize(const FbxTree &tree, qint64 position, qint64 end)
{
    const qint64 room = end - position;
    if (room < 1)
        return -1;
    const char *data = tree.bytes.constData() + position;
    const auto number = [&](qint64 at) {
        return static_cast<qint64>(fbxNumber<std::uint32_t>(data + at, tree.bigEndian));
    };
    qint64 size = -1;
    qint64 element = 1;
    switch (*data) {
    case 'B':
    case 'C':
    case 'Z':
        size = 2;
        break;
    case 'Y':
        size = 3;
        break;
    case 'I':
    case 'F':
        size = 5;
        break;
    case 'L':
    case 'D':
        size = 9;
        break;
    case 'S':
    case 'R':
        size = room >= 5 ? 5 + number(1) : -1;
        break;
    case 'd':
    case 'l':
        element = 8;
        [[fallthrough]];
    case 'f':
    case 'i':
        element = element == 8 ? 8 : 4;
        [[fallthrough]];
    case 'b':
    case 'c':
        if (room < 13 || number(5) > 1)
            return -1;
        size = 13 + (number(5) == 1 ? number(9) : number(1) * element);
        break;
    default:
        return -1;
    }
    return size <= room ? size : -1;
}

} // namespace autocuts
