#include "model/io/obj/objscanner.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace autocuts {

namespace {

bool isBlank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

//! True for a backslash that continues a line; it counts as white space.
bool isContinuation(std::string_view text, std::size_t at)
{
    return text[at] == '\\' && at + 1 < text.size() && (text[at + 1] == '\n' || text[at + 1] == '\r');
}

std::string_view firstWord(std::string_view line)
{
    std::size_t first = 0;
    while (first < line.size() && isBlank(line[first]))
        ++first;
    std::size_t last = first;
    while (last < line.size() && !isBlank(line[last]) && line[last] != '\\')
        ++last;
    return line.substr(first, last - first);
}

ObjStatement statementOf(std::string_view keyword)
{
    if (keyword == "v")
        return ObjStatement::Vertex;
    if (keyword == "f")
        return ObjStatement::Face;
    if (keyword == "vt")
        return ObjStatement::TextureVertex;
    if (keyword == "vn")
        return ObjStatement::Normal;
    if (keyword == "l" || keyword == "surf")
        return ObjStatement::Element;
    if (keyword == "o")
        return ObjStatement::Object;
    if (keyword == "usemtl")
        return ObjStatement::Material;
    if (keyword == "s")
        return ObjStatement::Smoothing;
    return ObjStatement::Other;
}

//! In names a backslash may be the last character (Windows paths); in comments it has no meaning.
bool canContinue(std::string_view keyword)
{
    return !keyword.empty() && keyword.front() != '#' && keyword != "o" && keyword != "g" &&
           keyword != "usemtl" && keyword != "mtllib" && keyword != "usemap" && keyword != "maplib";
}

} // namespace

ObjScanner::ObjScanner(std::string_view bytes) : mBytes(bytes)
{
    if (mBytes.substr(0, 3) == "\xEF\xBB\xBF")
        mPosition = 3;
    const std::size_t feed = mBytes.find('\n');
    if (feed != std::string_view::npos) {
        if (feed > 0 && mBytes[feed - 1] == '\r')
            mLineEnd = "\r\n";
    } else if (mBytes.find('\r') != std::string_view::npos) {
        mEndOfLine = '\r';
        mLineEnd = "\r";
    }
}

bool ObjScanner::next()
{
    if (mPosition >= mBytes.size())
        return false;
    mLineNumber += mLineNumber == 0 ? 1 : mPhysicalLines;
    mPhysicalLines = 0;

    const std::size_t begin = mPosition;
    std::size_t physicalBegin = begin;
    std::string_view keyword;
    bool continued = true;
    while (continued && mPosition < mBytes.size()) {
        physicalBegin = mPosition;
        const void *end =
            std::memchr(mBytes.data() + physicalBegin, mEndOfLine, mBytes.size() - physicalBegin);
        std::size_t contentEnd = mBytes.size();
        mPosition = mBytes.size();
        if (end) {
            contentEnd = static_cast<const char *>(end) - mBytes.data();
            mPosition = contentEnd + 1;
        }
        ++mPhysicalLines;
        const std::string_view physical = mBytes.substr(physicalBegin, contentEnd - physicalBegin);
        if (physicalBegin == begin)
            keyword = firstWord(physical);
        std::size_t tail = physical.size();
        if (tail > 0 && physical[tail - 1] == '\r')
            --tail;
        continued = end && tail > 0 && physical[tail - 1] == '\\' && canContinue(keyword) &&
                    physical.find('#') == std::string_view::npos;
    }
    mLine = mBytes.substr(begin, mPosition - begin);
    mStatement = statementOf(keyword);
    mArguments = mLine.substr(keyword.empty() ? 0 : keyword.data() + keyword.size() - mLine.data());
    return true;
}

bool nextWord(std::string_view &rest, std::string_view &word)
{
    std::size_t begin = 0;
    while (begin < rest.size() && (isBlank(rest[begin]) || isContinuation(rest, begin)))
        ++begin;
    if (begin == rest.size() || rest[begin] == '#')
        return false;
    std::size_t end = begin;
    while (end < rest.size() && !isBlank(rest[end]) && !isContinuation(rest, end))
        ++end;
    word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return true;
}

std::string_view nameArgument(std::string_view arguments)
{
    while (!arguments.empty() && isBlank(arguments.front()))
        arguments.remove_prefix(1);
    while (!arguments.empty() && isBlank(arguments.back()))
        arguments.remove_suffix(1);
    return arguments;
}

ObjCornerWord::ObjCornerWord(std::string_view word)
{
    const std::size_t first = word.find('/');
    vertex = word.substr(0, first);
    if (first == std::string_view::npos)
        return;
    const std::size_t second = word.find('/', first + 1);
    textureVertex = word.substr(first + 1, second == std::string_view::npos ? second : second - first - 1);
    if (second == std::string_view::npos)
        return;
    normal = word.substr(second + 1);
    tooManyParts = normal.find('/') != std::string_view::npos;
}

bool parseNumber(std::string_view word, double &value)
{
    if (!word.empty() && word.front() == '+')
        word.remove_prefix(1);
    const char *end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, value);
    if (result.ec == std::errc::invalid_argument || result.ptr != end)
        return false;
    if (result.ec == std::errc::result_out_of_range) {
        // The value is too large or too small for a double: a wider type tells which.
        long double wide = 0;
        const bool fits = std::from_chars(word.data(), end, wide).ec == std::errc();
        value = fits ? static_cast<double>(wide) : std::numeric_limits<double>::infinity();
    }
    return true;
}

bool parseIndex(std::string_view word, std::int64_t count, std::int64_t &index)
{
    if (!word.empty() && word.front() == '+')
        word.remove_prefix(1);
    const char *end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, index);
    if (result.ec != std::errc() || result.ptr != end || index == 0)
        return false;
    index = index > 0 ? index - 1 : count + index;
    return index >= 0;
}

} // namespace autocuts
