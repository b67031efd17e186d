#include "model/io/assimp/blendnames.h"

#include "model/io/files/unzipping.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace autocuts {

namespace {

constexpr std::string_view gzipMark = "\x1f\x8b";
constexpr std::size_t headSize = 12; //!< of a file
//! Behind the "OB" of a name there is room for this many characters, in files of all versions.
constexpr std::size_t nameRoom = 21;

//! A whole number of four bytes.
std::size_t numberAt(std::string_view bytes, std::size_t at, bool littleEndian)
{
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k)
        value = value << 8 | static_cast<unsigned char>(bytes[at + (littleEndian ? 3 - k : k)]);
    return value;
}

//! The place of the "OB" before the name of an object, or npos: it stands behind a few pointers.
std::size_t nameIn(std::string_view block, std::size_t pointer)
{
    for (std::size_t at = 2 * pointer; at <= 6 * pointer && at + 2 + nameRoom < block.size(); at += pointer) {
        if (block.substr(at).starts_with("OB"))
            return at;
    }
    return std::string_view::npos;
}

} // namespace

std::string blendName(std::size_t number)
{
    constexpr std::size_t digits = 8;
    const std::string text = std::to_string(number);
    return '#' + std::string(digits - std::min(digits, text.size()), '0') + text;
}

BlendObjects withDistinctNames(std::string bytes)
{
    BlendObjects result{std::move(bytes), {}};
    if (std::string_view(result.bytes).starts_with(gzipMark))
        result.bytes = unzipped(result.bytes);
    std::string &file = result.bytes;
    if (file.size() < headSize || !std::string_view(file).starts_with("BLENDER"))
        return result;
    const std::size_t pointer = file[7] == '-' ? 8 : 4;
    const bool littleEndian = file[8] == 'v';
    const std::size_t head = 16 + pointer; // code, size, pointer, structure, count
    std::size_t at = headSize;
    while (at + head <= file.size()) {
        const std::size_t size = numberAt(file, at + 4, littleEndian);
        const std::string_view code = std::string_view(file).substr(at, 4);
        const std::size_t begin = at + head;
        if (size > file.size() - begin || code == "ENDB")
            break;
        const std::size_t name = code == std::string_view("OB\0\0", 4)
                                     ? nameIn(std::string_view(file).substr(begin, size), pointer)
                                     : std::string_view::npos;
        if (name != std::string_view::npos) {
            const std::string fresh = blendName(result.names.size());
            result.names.emplace_back(file.c_str() + begin + name + 2);
            file.replace(begin + name + 2, fresh.size() + 1, fresh.c_str(), fresh.size() + 1);
        }
        at = begin + size;
    }
    return result;
}

} // namespace autocuts
